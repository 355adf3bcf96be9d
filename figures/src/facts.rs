//! Numbers and phrases shared by headers and captions.

use crate::canvas::{Entry, Header};
use crate::scale::{largest, significant};
use crate::study::{Checked, Run};
use crate::style::{LIMIT, REFERENCE, Stroke, label, stroke};
use slideway_lab::MethodSummary;

/// A header with `subject` and the study's title, and a legend entry for each of `runs`, with its value in brackets.
///
/// `meaning` says what the values are; it is left out where no run has one.
pub(crate) fn header<'a>(
    checked: &Checked,
    subject: &str,
    meaning: &str,
    runs: impl IntoIterator<Item = &'a Run<'a>>,
    value: impl Fn(&Run) -> Option<String>,
) -> Header {
    let values: Vec<_> = runs.into_iter().map(|run| (run.method, value(run))).collect();
    let has_values = values.iter().any(|(_, value)| value.is_some());
    let message = if has_values { format!("In brackets: {meaning}.") } else { String::new() };
    let name = |method, value: Option<String>| match value {
        Some(value) => format!("{} ({value})", label(method)),
        None => label(method).to_owned(),
    };
    let legend = values.into_iter().map(|(m, value)| entry(&name(m, value), stroke(m))).collect();
    Header { heading: format!("{subject} – {}", checked.study.title), message, legend }
}

/// An entry of a legend.
pub(crate) fn entry(label: &str, stroke: Stroke) -> Entry {
    Entry { label: label.to_owned(), stroke }
}

/// The legend's entry of limits and bounds.
pub(crate) fn limit_entry(name: &str) -> Entry {
    entry(name, LIMIT)
}

/// The legend's entry of what is followed.
pub(crate) fn reference_entry(name: &str) -> Entry {
    entry(name, REFERENCE)
}

/// Duration of the optimum, if there is one.
pub(crate) fn shortest(checked: &Checked) -> Option<f64> {
    checked.study.optimum?.duration().filter(|t| *t > 0.0)
}

/// Travel time of a regulated method in units of the optimum's: from the start of motion to the robot's arrival.
pub(crate) fn travel_ratio(checked: &Checked, run: &Run) -> Option<String> {
    let travel = MethodSummary::new(run.trace).travel_s().filter(|_| run.method.is_regulated())?;
    Some(format!("{:.4}", travel / shortest(checked)?))
}

/// Meaning of the travel ratio, in words.
pub(crate) fn travel_meaning(checked: &Checked) -> String {
    let shortest = shortest(checked).map(|t| significant(t, 4)).unwrap_or_default();
    format!("travel time over the optimum's {shortest} s")
}

/// When motion of the reference starts, the earliest of the regulated methods (else 0), s.
pub(crate) fn motion_start(checked: &Checked) -> f64 {
    let start = checked.regulated().filter_map(|run| run.trace.motion_start()).fold(f64::INFINITY, f64::min);
    if start.is_finite() { start } else { 0.0 }
}

/// Upper end of an axis for path rates: all of what the methods do, and of the optimum what is not out of all proportion.
pub(crate) fn rate_ceiling(checked: &Checked) -> f64 {
    let done = largest(checked.runs.iter().flat_map(|run| run.following()).map(|s| s.path_rate));
    let best = largest(checked.study.optimum.into_iter().flat_map(|o| o.path_rate.iter().copied()));
    // A path that comes nearly to rest in joint space has an optimum without bound there.
    let optimum = if done > 0.0 { best.min(2.0 * done) } else { best };
    1.06 * done.max(optimum)
}
