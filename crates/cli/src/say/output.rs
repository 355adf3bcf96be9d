use crate::say::diagnostic::CliError;
use crate::say::loudness::Loudness;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use slideway_compare::Progress;
use slideway_figures::Rendered;
use std::fs;
use std::io::{ErrorKind, Write as _};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::Instant;

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

/// Prints to standard output what is neither a failure nor a verdict.
pub(crate) fn tell(text: &str) -> Result<(), CliError> {
    if Loudness::chosen() == Loudness::Quiet { Ok(()) } else { print(text) }
}

/// Prints the whole of an answer, or in quiet its verdict with what failed.
pub(crate) fn print_answer(whole: &str, verdict: &str) -> Result<(), CliError> {
    print(if Loudness::chosen() == Loudness::Quiet { verdict } else { whole })
}

/// Tells on the error stream of a file or folder that was written, where that is asked for.
pub(crate) fn wrote(path: &Path) {
    tell_verbose(|| format!("wrote {}", path.display()));
}

/// The same of figures.
pub(crate) fn wrote_figures(figures: &[Rendered]) {
    figures.iter().flat_map(|figure| [&figure.svg_path, &figure.png_path]).for_each(|path| wrote(path));
}

/// A line on the error stream, where that is asked for.
pub(crate) fn tell_verbose(line: impl FnOnce() -> String) {
    if Loudness::chosen() == Loudness::Verbose {
        print_error(&line());
    }
}

/// A bar that is seen unless the command is quiet, or tells of stages in lines instead.
pub(crate) fn bar(steps: u64) -> ProgressBar {
    match Loudness::chosen() {
        Loudness::Normal => ProgressBar::new(steps),
        Loudness::Quiet | Loudness::Verbose => ProgressBar::hidden(),
    }
}

/// A bar of so many steps.
pub(crate) fn progress(steps: u64) -> ProgressBar {
    let bar = bar(steps);
    if let Ok(style) = ProgressStyle::with_template("{bar:24} {pos}/{len} {msg}") {
        bar.set_style(style);
    }
    bar
}

/// The progress of a comparison as a bar, or as lines with the time of every stage.
pub(crate) struct Watched {
    bar: ProgressBar,
    /// The stage under way, and when it began.
    stage: Option<(String, Instant)>,
}

impl Watched {
    pub(crate) fn new() -> Self {
        Self { bar: progress(0), stage: None }
    }

    /// Moves the bar; writing the results is a step of its own.
    pub(crate) fn show(&mut self, progress: Progress) -> ControlFlow<()> {
        self.bar.set_length(progress.total as u64 + 1);
        self.bar.set_position(progress.done as u64);
        self.begin(progress.stage.to_string());
        ControlFlow::Continue(())
    }

    pub(crate) fn writing(&mut self) {
        self.bar.inc(1);
        self.begin("writing traces and figures".into());
    }

    pub(crate) fn end(mut self) {
        self.tell_time();
        self.bar.finish_and_clear();
    }

    /// Of a stage that goes on nothing is told.
    fn begin(&mut self, stage: String) {
        if self.stage.as_ref().is_some_and(|(under_way, _)| *under_way == stage) {
            return;
        }
        self.tell_time();
        self.bar.set_message(stage.clone());
        self.stage = Some((stage, Instant::now()));
    }

    fn tell_time(&mut self) {
        if let Some((stage, begin)) = self.stage.take() {
            tell_verbose(|| format!("{:9.3} s  {stage}", begin.elapsed().as_secs_f64()));
        }
    }
}

/// The summary as JSON.
pub(crate) fn as_json(summary: &impl Serialize) -> Result<serde_json::Value, CliError> {
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
    match whole(&path, fill) {
        Ok(()) => wrote(&path),
        Err(source) => return Err(CliError::Write { path, source }),
    }
    Ok(())
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
pub(crate) fn json_text(value: &impl Serialize) -> Result<String, CliError> {
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
pub(crate) fn print_json(value: &impl Serialize) -> Result<(), CliError> {
    print(&json_text(value)?)
}

/// A result as a table that ends in a verdict.
pub(crate) struct Answer<'a> {
    pub(crate) table: &'a str,
    pub(crate) verdict: &'a str,
}

/// Prints the summary as JSON or the answer, and where the report is.
pub(crate) fn show(json: bool, summary: &impl Serialize, answer: &Answer<'_>, out: &Path) -> Result<(), CliError> {
    if json {
        return print_json(summary);
    }
    let wrote = format!("{}\nwrote {}\n", answer.table, out.join("report.html").display());
    print_answer(&wrote, &format!("{}\n", answer.verdict))
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
