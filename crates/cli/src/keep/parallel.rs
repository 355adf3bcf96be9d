//! Numbered pieces of work on all cores, each written into a journal as soon as it is done, under a progress bar.

use crate::keep::journal::Journal;
use crate::say::diagnostic::CliError;
use crate::say::output::{bar, tell_verbose};
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

/// What is shown and kept while pieces of work end.
pub(crate) struct Work<'a, R> {
    /// Where they are written.
    pub(crate) journal: &'a Journal,
    /// What an earlier command has done already.
    pub(crate) done: &'a [Option<R>],
    /// Whether one counts as a failure.
    pub(crate) failed: fn(&R) -> bool,
}

impl<R: Serialize> Work<'_, R> {
    /// Lets `run` do what is left, with a function that it gives every finished piece.
    pub(crate) fn finish(
        &self,
        run: impl FnOnce(&(dyn Fn(&R) -> Result<(), CliError> + Sync)) -> Result<Vec<R>, CliError>,
    ) -> Result<Vec<R>, CliError> {
        let before = self.done.iter().flatten();
        let failures = AtomicUsize::new(before.clone().filter(|row| (self.failed)(row)).count());
        let bar = progress(self.done.len(), before.count());
        let failed = self.failed;
        let sink = |row: &R| {
            self.journal.append(row)?;
            let failed = usize::from(failed(row));
            bar.set_message(format!("failures: {}", failures.fetch_add(failed, Ordering::Relaxed) + failed));
            bar.inc(1);
            Ok(())
        };
        let begin = Instant::now();
        let found = run(&sink);
        bar.finish_and_clear();
        if let Ok(found) = &found {
            tell_verbose(|| format!("{:9.3} s  {} runs", begin.elapsed().as_secs_f64(), found.len()));
        }
        found
    }
}

/// The number of threads asked for, else one per core.
pub(crate) fn jobs(asked: Option<NonZeroUsize>) -> NonZeroUsize {
    let cores = || std::thread::available_parallelism().unwrap_or(NonZeroUsize::MIN);
    asked.unwrap_or_else(cores)
}

fn progress(pieces: usize, done: usize) -> ProgressBar {
    let bar = bar(pieces as u64).with_position(done as u64);
    if let Ok(style) = ProgressStyle::with_template("{bar:24} {pos}/{len} {elapsed} (left: {eta}) {msg}") {
        bar.set_style(style);
    }
    // The pieces of an earlier session say nothing about the speed of this one.
    bar.reset_eta();
    bar
}
