use crate::say::failures::difference::Difference;
use std::path::PathBuf;
use thiserror::Error;

/// Why a journal cannot be used.
#[derive(Debug, Error)]
pub(crate) enum JournalError {
    /// The folder holds the journal of something else.
    #[error(
        "{} holds another {writer}: its {} was {}, now it is {}",
        path.display(), difference.what, difference.was, difference.now
    )]
    Different { writer: &'static str, path: PathBuf, difference: Difference },
    /// A file with the journal's name that no such command wrote.
    #[error("{}, line {line}: not written by a {writer}: {reason}", path.display())]
    Foreign { writer: &'static str, path: PathBuf, line: usize, reason: String },
    /// Two commands at once.
    #[error("another {writer} is writing {}", path.display())]
    Busy { writer: &'static str, path: PathBuf },
    /// A journal that cannot be read.
    #[error("cannot read {}: {source}", path.display())]
    Unreadable { path: PathBuf, source: std::io::Error },
}

impl JournalError {
    pub(crate) fn remedy(&self) -> String {
        match self {
            Self::Different { writer, .. } => format!(
                "give the arguments of that {writer} to continue it, choose another folder with --out, or remove this one"
            ),
            Self::Foreign { .. } => "choose another folder with --out, or remove the file".into(),
            Self::Busy { .. } => "wait until it ends, or choose another folder with --out".into(),
            Self::Unreadable { .. } => "give the folder that `slideway verify` wrote, or its trials.jsonl".into(),
        }
    }
}
