use crate::say::diagnostic::CliError;
use indicatif::{ProgressBar, ProgressStyle};
use slideway_compare::Progress;
use std::fs;
use std::io::{ErrorKind, Write as _};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// How a command ended, short of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// Done, and the verdict (if there was one) holds.
    Holds,
    /// Done, and the verdict does not hold.
    Fails,
}

impl Outcome {
    pub(crate) fn exit_status(self) -> u8 {
        match self {
            Self::Holds => 0,
            Self::Fails => 1,
        }
    }
}

/// Prints to standard output.
///
/// # Errors
///
/// An output that takes no more: a full disk, a reader that closed the pipe.
pub(crate) fn print(text: &str) -> Result<(), CliError> {
    let mut out = std::io::stdout().lock();
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(CliError::Print)
}

/// Prints a line to standard error, which has no place left to complain to.
pub(crate) fn print_error(line: &str) {
    let _ = writeln!(std::io::stderr().lock(), "{line}");
}

/// A bar of so many steps.
pub(crate) fn progress(steps: u64) -> ProgressBar {
    let bar = ProgressBar::new(steps);
    if let Ok(style) = ProgressStyle::with_template("{bar:24} {pos}/{len} {msg}") {
        bar.set_style(style);
    }
    bar
}

/// The progress of a comparison as a bar.
pub(crate) struct Watched {
    bar: ProgressBar,
}

impl Watched {
    pub(crate) fn new() -> Self {
        Self { bar: progress(0) }
    }

    /// Moves the bar; writing the results is a step of its own.
    pub(crate) fn show(&self, progress: Progress) -> ControlFlow<()> {
        self.bar.set_length(progress.total as u64 + 1);
        self.bar.set_position(progress.done as u64);
        self.bar.set_message(progress.stage.to_string());
        ControlFlow::Continue(())
    }

    pub(crate) fn writing(&self) {
        self.bar.inc(1);
        self.bar.set_message("writing traces and figures");
    }

    pub(crate) fn end(self) {
        self.bar.finish_and_clear();
    }
}

/// The summary as JSON.
pub(crate) fn as_json(summary: &impl serde::Serialize) -> Result<serde_json::Value, CliError> {
    serde_json::to_value(summary).map_err(|error| CliError::Write { path: "summary.json".into(), source: error.into() })
}

/// Makes the folders of a run's results and takes away the summary of an earlier one, which would stand beside other traces; the
/// folder of the figures. [`write_summary`] comes last: where it stands, everything else is whole.
pub(crate) fn begin(out: &Path) -> Result<PathBuf, CliError> {
    let figures_dir = out.join("figures");
    fs::create_dir_all(&figures_dir).map_err(|source| CliError::Write { path: figures_dir.clone(), source })?;
    withdraw(&out.join("summary.json"))?;
    Ok(figures_dir)
}

/// Removes a file of an earlier run, if there is one.
pub(crate) fn withdraw(path: &Path) -> Result<(), CliError> {
    match fs::remove_file(path) {
        Err(source) if source.kind() != ErrorKind::NotFound => Err(CliError::Write { path: path.to_owned(), source }),
        _ => Ok(()),
    }
}

/// Writes `summary.json`.
pub(crate) fn write_summary(out: &Path, summary: &impl serde::Serialize) -> Result<(), CliError> {
    create(out.join("summary.json"), |file| Ok(serde_json::to_writer_pretty(file, summary)?))
}

/// Writes a file that appears under its name only when `fill` has written all of it.
pub(crate) fn create(
    path: PathBuf,
    fill: impl FnOnce(&mut dyn std::io::Write) -> std::io::Result<()>,
) -> Result<(), CliError> {
    whole(&path, fill).map_err(|source| CliError::Write { path, source })
}

/// Writes beside the file and renames; into what is no plain file, such as a device, directly.
fn whole(path: &Path, fill: impl FnOnce(&mut dyn std::io::Write) -> std::io::Result<()>) -> std::io::Result<()> {
    // A link keeps pointing where it did.
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    if fs::metadata(&path).is_ok_and(|data| !data.is_file()) {
        return filled(fs::OpenOptions::new().write(true).open(&path)?, fill);
    }
    let name = path.file_name().ok_or(ErrorKind::InvalidFilename)?;
    let part = path.with_file_name(format!(".{}.{}.part", name.to_string_lossy(), std::process::id()));
    let written = fs::File::create(&part).and_then(|file| filled(file, fill)).and_then(|()| fs::rename(&part, &path));
    written.inspect_err(|_| drop(fs::remove_file(&part)))
}

fn filled(file: fs::File, fill: impl FnOnce(&mut dyn std::io::Write) -> std::io::Result<()>) -> std::io::Result<()> {
    let mut out = std::io::BufWriter::new(file);
    fill(&mut out)?;
    out.flush()
}

/// A value as the text of a JSON file.
pub(crate) fn json_text(value: &impl serde::Serialize) -> Result<String, CliError> {
    let text = serde_json::to_string_pretty(value);
    let text = text.map_err(|error| CliError::Write { path: "standard output".into(), source: error.into() })?;
    Ok(text.lines().map(|line| without_words_for_numbers(line) + "\n").collect())
}

/// A line of JSON with null for a number that is none: journals keep such numbers as words, bit by bit, results do not.
fn without_words_for_numbers(line: &str) -> String {
    const KEYS: [&str; 8] = ["size", "measured", "bound", "margin", "value", "needed", "lower", "upper"];
    let Some((key, value)) = line.split_once(": ") else { return line.to_owned() };
    let is_word = ["\"NaN\"", "\"inf\"", "\"-inf\""].contains(&value.trim_end_matches(','));
    let is_number = KEYS.contains(&key.trim().trim_matches('"'));
    let comma = if value.ends_with(',') { "," } else { "" };
    if is_word && is_number { format!("{key}: null{comma}") } else { line.to_owned() }
}

/// Prints a value as JSON.
pub(crate) fn print_json(value: &impl serde::Serialize) -> Result<(), CliError> {
    print(&json_text(value)?)
}

/// Prints the summary as JSON or the table, and where the report is.
pub(crate) fn show(json: bool, summary: &impl serde::Serialize, table: &str, out: &Path) -> Result<(), CliError> {
    if json { print_json(summary) } else { print(&format!("{table}\nwrote {}\n", out.join("report.html").display())) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_that_is_none_is_null_in_results_and_a_name_stays() {
        let text = "{\n  \"scenario\": \"inf\",\n  \"margin\": \"-inf\",\n  \"bound\": \"NaN\"\n}";
        let lines: Vec<String> = text.lines().map(without_words_for_numbers).collect();
        assert_eq!(lines.join("\n"), "{\n  \"scenario\": \"inf\",\n  \"margin\": null,\n  \"bound\": null\n}");
    }
}
