use miette::NamedSource;
use slideway_lab::locate;
use slideway_lab::sweep::SweepError;
use std::ops::Range;
use std::path::PathBuf;
use thiserror::Error;

/// Why a sweep cannot be made or continued.
#[derive(Debug, Error)]
pub(crate) enum SweepFailure {
    /// The request is wrong.
    #[error("{error}")]
    Request { error: Box<SweepError>, file: String },
    /// The folder holds the rows of another sweep.
    #[error("{} holds another sweep: its {what} was {was}, now it is {now}", path.display())]
    Different { path: PathBuf, what: &'static str, was: String, now: String },
    /// A file with the journal's name that no sweep wrote.
    #[error("{}, line {line}: not written by a sweep: {reason}", path.display())]
    Foreign { path: PathBuf, line: usize, reason: String },
    /// Two commands at once.
    #[error("another sweep is writing {}", path.display())]
    Busy { path: PathBuf },
}

impl SweepFailure {
    pub(crate) fn remedy(&self) -> String {
        match self {
            Self::Request { error, .. } => error.remedy(),
            Self::Different { .. } => {
                "give the arguments of that sweep to continue it, choose another folder with --out, or remove this one"
                    .into()
            }
            Self::Foreign { .. } => "choose another folder with --out, or remove the file".into(),
            Self::Busy { .. } => "wait until it ends, or choose another folder with --out".into(),
        }
    }

    /// The scenario's text with the settings of the cell in it, and where in it the error lies.
    pub(crate) fn source_and_span(&self) -> (Option<NamedSource<String>>, Option<Range<usize>>) {
        let Self::Request { error, file } = self else { return (None, None) };
        let SweepError::Cell { error, settings, text } = error.as_ref() else { return (None, None) };
        let name = if settings.is_empty() { file.clone() } else { format!("{file} with {settings}") };
        (Some(NamedSource::new(name, text.clone()).with_language("TOML")), locate(text, error))
    }
}
