//! Numbers and phrases shared by headers and captions.

use crate::canvas::{Entry, Header};
use crate::scale::significant;
use crate::study::{Checked, Run};
use crate::style::{LIMIT, REFERENCE, label, stroke};
use slideway_lab::MethodSummary;

/// A header with the study's title, and an entry for each of `runs` after `reference`.
pub(crate) fn header<'a>(
    checked: &Checked,
    message: String,
    reference: Option<&str>,
    runs: impl IntoIterator<Item = &'a Run<'a>>,
) -> Header {
    let mut legend: Vec<Entry> =
        reference.into_iter().map(|name| Entry { label: name.to_owned(), stroke: REFERENCE }).collect();
    legend.extend(runs.into_iter().map(|r| Entry { label: label(r.method).to_owned(), stroke: stroke(r.method) }));
    Header { heading: checked.study.title.to_owned(), message, legend }
}

/// The legend's entry of limits and bounds.
pub(crate) fn limit_entry(name: &str) -> Entry {
    Entry { label: name.to_owned(), stroke: LIMIT }
}

/// "a 1.2 mm, b 3.4 mm": a value of each run that has one.
pub(crate) fn per_run<'a>(
    runs: impl IntoIterator<Item = &'a Run<'a>>,
    value: impl Fn(&Run) -> Option<String>,
) -> String {
    let parts: Vec<String> =
        runs.into_iter().filter_map(|run| Some(format!("{} {}", label(run.method), value(run)?))).collect();
    parts.join(", ")
}

/// Travel times of the regulated methods in units of the optimum's: from the start of motion to the robot's arrival.
pub(crate) fn travel_ratios(checked: &Checked) -> Option<String> {
    let shortest = checked.study.optimum?.duration().filter(|t| *t > 0.0)?;
    let ratio = |run: &Run| Some(format!("{:.4}", MethodSummary::new(run.trace).travel_s()? / shortest));
    let ratios = per_run(checked.regulated(), ratio);
    (!ratios.is_empty()).then(|| format!("Travel time / optimum's {} s: {ratios}.", significant(shortest, 4)))
}

/// When motion of the reference starts, the earliest of the regulated methods (else 0), s.
pub(crate) fn motion_start(checked: &Checked) -> f64 {
    let start = checked.regulated().filter_map(|run| run.trace.motion_start()).fold(f64::INFINITY, f64::min);
    if start.is_finite() { start } else { 0.0 }
}

/// Upper end of an axis for path rates: all of what the methods do, and of the optimum what is not out of all proportion.
pub(crate) fn rate_ceiling(checked: &Checked) -> f64 {
    let rates = checked.runs.iter().flat_map(|run| run.following()).map(|s| s.path_rate);
    let done = crate::scale::largest(rates);
    let best = crate::scale::largest(checked.study.optimum.into_iter().flat_map(|o| o.path_rate.iter().copied()));
    // A path that comes nearly to rest in joint space has an optimum without bound there.
    let optimum = if done > 0.0 { best.min(2.0 * done) } else { best };
    1.06 * done.max(optimum)
}
