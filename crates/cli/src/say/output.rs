use crate::say::diagnostic::CliError;
use indicatif::{ProgressBar, ProgressStyle};
use slideway_compare::Progress;
use std::fs;
use std::io::Write as _;
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

/// Prints to standard output; a reader that closes the pipe early is no error.
pub(crate) fn print(text: &str) {
    let mut out = std::io::stdout().lock();
    let _ = out.write_all(text.as_bytes()).and_then(|()| out.flush());
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

/// Makes the folders and writes `summary.json`; the folder of the figures.
pub(crate) fn write_summary(out: &Path, summary: &impl serde::Serialize) -> Result<PathBuf, CliError> {
    let figures_dir = out.join("figures");
    fs::create_dir_all(&figures_dir).map_err(|source| CliError::Write { path: figures_dir.clone(), source })?;
    create(out.join("summary.json"), |file| Ok(serde_json::to_writer_pretty(file, summary)?))?;
    Ok(figures_dir)
}

/// Creates a file with what `fill` writes into it.
pub(crate) fn create(
    path: PathBuf,
    fill: impl FnOnce(&mut dyn std::io::Write) -> std::io::Result<()>,
) -> Result<(), CliError> {
    let result = fs::File::create(&path).and_then(|file| {
        let mut out = std::io::BufWriter::new(file);
        fill(&mut out)?;
        std::io::Write::flush(&mut out)
    });
    result.map_err(|source| CliError::Write { path, source })
}

/// A value as the text of a JSON file.
pub(crate) fn json_text(value: &impl serde::Serialize) -> Result<String, CliError> {
    let text = serde_json::to_string_pretty(value);
    Ok(text.map_err(|error| CliError::Write { path: "standard output".into(), source: error.into() })? + "\n")
}

/// Prints a value as JSON.
pub(crate) fn print_json(value: &impl serde::Serialize) -> Result<(), CliError> {
    print(&json_text(value)?);
    Ok(())
}

/// Prints the summary as JSON or the table, and where the report is.
pub(crate) fn show(json: bool, summary: &impl serde::Serialize, table: &str, out: &Path) -> Result<(), CliError> {
    if json {
        print_json(summary)?;
    } else {
        print(&format!("{table}\nwrote {}\n", out.join("report.html").display()));
    }
    Ok(())
}
