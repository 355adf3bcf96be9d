//! Headers and quantities shared by the figures of path conditioning.

use super::study::{Checked, PathRun};
use crate::canvas::Header;
use crate::facts::entry;
use crate::polyline::Point;
use crate::scale::significant;
use crate::style::{path_label, path_stroke};
use slideway_lab::conditioning::ConditionedSample;
use std::ops::Range;

/// A header with `subject` and the study's title, and a legend entry for each of `runs`, with its value in brackets.
///
/// `meaning` says what the values are; it is left out where no run has one.
pub(crate) fn header<'r, 'a: 'r>(
    checked: &Checked,
    subject: &str,
    meaning: &str,
    runs: impl IntoIterator<Item = &'r PathRun<'a>>,
    value: impl Fn(&PathRun) -> Option<String>,
) -> Header {
    let mut message = String::new();
    let mut legend = Vec::new();
    for run in runs {
        let value = value(run);
        if value.is_some() {
            message = format!("In brackets: {meaning}.");
        }
        let brackets = value.map(|value| format!(" ({value})")).unwrap_or_default();
        legend.push(entry(&format!("{}{brackets}", path_label(run.method)), path_stroke(run.method)));
    }
    Header { heading: format!("{subject} – {}", checked.study.title), message, legend }
}

/// A length to `digits` significant digits; less than a nanometre is rounding, 0.
pub(crate) fn length(metres: f64, digits: usize) -> Option<String> {
    metres.is_finite().then(|| match metres.abs() {
        size if size < 1e-9 => "0".to_owned(),
        size if size < 1e-6 => format!("{} µm", significant(1e6 * metres, digits)),
        _ => format!("{} mm", significant(1e3 * metres, digits)),
    })
}

/// A time axis is divided into so many windows where single samples cannot be told apart.
const WINDOWS: f64 = 300.0;

/// Length of the mean of a vector in short windows of time: what a switched signal comes to.
pub(crate) fn mean_length(
    samples: &[ConditionedSample],
    time: &Range<f64>,
    vector: impl Fn(&ConditionedSample) -> [f64; 3],
) -> Vec<Point> {
    let window = |s: &ConditionedSample| ((s.t - time.start) / (time.end - time.start) * WINDOWS).floor();
    let mean = |part: &[ConditionedSample]| {
        let sum = part.iter().map(&vector).fold([0.0; 3], |sum, v| std::array::from_fn(|k| sum[k] + v[k]));
        let middle = 0.5 * (part[0].t + part[part.len() - 1].t);
        (middle, sum.iter().map(|x| x * x).sum::<f64>().sqrt() / part.len() as f64)
    };
    samples.chunk_by(|a, b| window(a) == window(b)).map(mean).collect()
}
