use crate::say::diagnostic::CliError;
use crate::say::loudness::Loudness;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use slideway_compare::Progress;
use slideway_figures::Rendered;
use std::fs;
use std::io::Write as _;
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

/// Prints to standard output; a reader that closes the pipe early is no error.
pub(crate) fn print(text: &str) {
    let mut out = std::io::stdout().lock();
    let _ = out.write_all(text.as_bytes()).and_then(|()| out.flush());
}

/// Prints to standard output what is neither a failure nor a verdict.
pub(crate) fn tell(text: &str) {
    if Loudness::chosen() != Loudness::Quiet {
        print(text);
    }
}

/// Prints the whole of an answer, or in quiet its verdict with what failed.
pub(crate) fn print_answer(whole: &str, verdict: &str) {
    print(if Loudness::chosen() == Loudness::Quiet { verdict } else { whole });
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
        eprintln!("{}", line());
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

/// Makes the folders and writes `summary.json`; the folder of the figures.
pub(crate) fn write_summary(out: &Path, summary: &impl Serialize) -> Result<PathBuf, CliError> {
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
    match result {
        Ok(()) => wrote(&path),
        Err(source) => return Err(CliError::Write { path, source }),
    }
    Ok(())
}

/// A value as the text of a JSON file.
pub(crate) fn json_text(value: &impl Serialize) -> Result<String, CliError> {
    let text = serde_json::to_string_pretty(value);
    Ok(text.map_err(|error| CliError::Write { path: "standard output".into(), source: error.into() })? + "\n")
}

/// Prints a value as JSON.
pub(crate) fn print_json(value: &impl Serialize) -> Result<(), CliError> {
    print(&json_text(value)?);
    Ok(())
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
    print_answer(&wrote, &format!("{}\n", answer.verdict));
    Ok(())
}
