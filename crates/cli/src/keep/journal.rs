//! What a long command has finished: after a line that says whose journal it is, one line per finished piece, in the order in
//! which pieces end. A piece counts as finished when its line is whole.

use crate::say::diagnostic::CliError;
use crate::say::failures::difference::Difference;
use crate::say::failures::journal::JournalError;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Read as _, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// Everything that the lines of a journal depend on.
pub(crate) trait Identity: Serialize + DeserializeOwned {
    /// What has such a journal.
    const WRITER: &'static str;

    /// The first thing in which two identities differ.
    fn difference(&self, now: &Self) -> Option<Difference>;
}

/// A journal, open for appending and locked against a second writer.
#[derive(Debug)]
pub(crate) struct Journal {
    path: PathBuf,
    file: Mutex<File>,
}

impl Journal {
    /// Opens a journal, new or begun, and gives each entry it holds to `take`, which says what is wrong with one that has no
    /// place here. A last line that was cut short is removed; a file that is no journal of this identity stays as it is.
    pub(crate) fn open<I: Identity, E: DeserializeOwned>(
        path: &Path,
        identity: &I,
        take: impl FnMut(E) -> Result<(), String>,
    ) -> Result<Self, CliError> {
        let write = |source| CliError::Write { path: path.to_owned(), source };
        let mut file =
            OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path).map_err(write)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                return Err(JournalError::Busy { writer: I::WRITER, path: path.to_owned() }.into());
            }
            Err(TryLockError::Error(source)) => return Err(write(source)),
        }
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(write)?;
        let first = to_line(identity).map_err(write)?;
        let whole = whole_lines(&bytes);
        if whole.is_empty() && !first.as_bytes().starts_with(&bytes) {
            return Err(foreign::<I>(path, 1, "it does not begin like one".into()));
        }
        if !whole.is_empty() {
            parse(whole, path, |was: &I| same(was, identity, path), take)?;
        }
        let end = whole.len() as u64;
        file.set_len(end).and_then(|()| file.seek(SeekFrom::End(0)).map(drop)).map_err(write)?;
        if end == 0 {
            file.write_all(first.as_bytes()).map_err(write)?;
        }
        Ok(Self { path: path.to_owned(), file: Mutex::new(file) })
    }

    /// Appends an entry in one write, so that a killed command leaves whole lines and at most one cut short.
    pub(crate) fn append(&self, entry: &impl Serialize) -> Result<(), CliError> {
        let write = |source| CliError::Write { path: self.path.clone(), source };
        let line = to_line(entry).map_err(write)?;
        // A thread that panicked while writing has left at most a line cut short.
        let mut file = self.file.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        file.write_all(line.as_bytes()).map_err(write)
    }
}

/// Reads a journal without continuing it: whose it is, and each of its entries to `take`. A last line that was cut short does
/// not count.
pub(crate) fn read_journal<I: Identity, E: DeserializeOwned>(
    path: &Path,
    take: impl FnMut(E) -> Result<(), String>,
) -> Result<I, CliError> {
    let bytes = std::fs::read(path).map_err(|source| JournalError::Unreadable { path: path.to_owned(), source })?;
    parse(whole_lines(&bytes), path, |_| Ok(()), take)
}

/// Refuses a journal whose identity is not the one expected.
fn same<I: Identity>(was: &I, now: &I, path: &Path) -> Result<(), CliError> {
    was.difference(now).map_or(Ok(()), |difference| {
        Err(JournalError::Different { writer: I::WRITER, path: path.to_owned(), difference }.into())
    })
}

fn whole_lines(bytes: &[u8]) -> &[u8] {
    &bytes[..bytes.iter().rposition(|&b| b == b'\n').map_or(0, |end| end + 1)]
}

fn parse<I: Identity, E: DeserializeOwned>(
    lines: &[u8],
    path: &Path,
    accept: impl FnOnce(&I) -> Result<(), CliError>,
    mut take: impl FnMut(E) -> Result<(), String>,
) -> Result<I, CliError> {
    let text = std::str::from_utf8(lines).map_err(|error| foreign::<I>(path, 1, error.to_string()))?;
    let mut lines = text.lines().enumerate();
    let first = lines.next().map_or("", |(_, line)| line);
    let identity: I = serde_json::from_str(first).map_err(|error| foreign::<I>(path, 1, error.to_string()))?;
    accept(&identity)?;
    for (i, line) in lines {
        let entry = serde_json::from_str(line).map_err(|error| error.to_string());
        entry.and_then(&mut take).map_err(|reason| foreign::<I>(path, i + 1, reason))?;
    }
    Ok(identity)
}

/// A file with the name of a journal that is none, or a line that has no place in it.
pub(crate) fn foreign<I: Identity>(path: &Path, line: usize, reason: String) -> CliError {
    JournalError::Foreign { writer: I::WRITER, path: path.to_owned(), line, reason }.into()
}

fn to_line(value: &impl Serialize) -> std::io::Result<String> {
    Ok(serde_json::to_string(value)? + "\n")
}
