//! Times for which traps stop the reference: distributions over random seeds.

use crate::canvas::{Canvas, Drawn, Header};
use crate::error::FigureError;
use crate::facts::{entry, limit_entry};
use crate::panel::{Frame, Panel};
use crate::polyline::Point;
use crate::render::{Figure, Rendered, make_directory, render};
use crate::scale::{Axis, span};
use crate::style::{LIMIT, numbered_stroke};
use plotters::backend::DrawingBackend;
use std::path::Path;

/// Escape times of several scenarios or variants of one.
#[derive(Clone, Copy, Debug)]
pub struct EscapeStudy<'a> {
    /// Heading of the figure, in a few words.
    pub title: &'a str,
    /// Variants that are compared, one curve each.
    pub variants: &'a [EscapeVariant<'a>],
}

/// The escape times of one scenario or variant.
#[derive(Clone, Copy, Debug)]
pub struct EscapeVariant<'a> {
    /// Its name in the legend.
    pub label: &'a str,
    /// Escape times of the runs that escaped, s, in any order.
    pub escape_s: &'a [f64],
    /// Number of runs that did not escape.
    pub failures: usize,
}

/// Draws the share of runs that have escaped against time, median and 95th percentile marked.
///
/// Shares are of all runs, so failures keep a curve below 1. A quantile is the shortest time by which at least that share
/// of the runs has escaped.
///
/// # Errors
///
/// No variants, one without runs, a time that is negative or not finite, or files that cannot be written.
pub fn draw_escape_times(study: &EscapeStudy, dir: &Path) -> Result<Rendered, FigureError> {
    crate::style::register_fonts()?;
    let figure = EscapeTimes::new(study)?;
    make_directory(dir)?;
    render(&figure, dir)
}

struct EscapeTimes<'a> {
    title: &'a str,
    curves: Vec<Distribution<'a>>,
}

struct Distribution<'a> {
    label: &'a str,
    /// In order, s.
    times: Vec<f64>,
    runs: usize,
}

/// Median and 95th percentile, in percent.
const QUANTILES: [usize; 2] = [50, 95];

impl<'a> EscapeTimes<'a> {
    fn new(study: &'a EscapeStudy<'a>) -> Result<Self, FigureError> {
        if study.variants.is_empty() {
            return Err(FigureError::NoTraces);
        }
        let curves = study.variants.iter().map(Distribution::new).collect::<Result<_, _>>()?;
        Ok(Self { title: study.title, curves })
    }

    fn end(&self) -> f64 {
        let last = self.curves.iter().filter_map(|c| c.times.last()).copied().fold(0.0, f64::max);
        if last > 0.0 { 1.05 * last } else { 1.0 }
    }
}

impl<'a> Distribution<'a> {
    fn new(variant: &EscapeVariant<'a>) -> Result<Self, FigureError> {
        if let Some(index) = variant.escape_s.iter().position(|t| !(*t >= 0.0 && t.is_finite())) {
            return Err(FigureError::Value { what: "escape times", index });
        }
        let runs = variant.escape_s.len() + variant.failures;
        if runs == 0 {
            return Err(FigureError::Length { what: "runs of a variant", expected: 1, found: 0 });
        }
        let mut times = variant.escape_s.to_vec();
        times.sort_unstable_by(f64::total_cmp);
        Ok(Self { label: variant.label, times, runs })
    }

    /// Share of runs that have escaped, a step at each time.
    fn steps(&self, end: f64) -> Vec<Point> {
        let share = |count: usize| count as f64 / self.runs as f64;
        let rise = self.times.iter().enumerate().flat_map(|(i, &t)| [(t, share(i)), (t, share(i + 1))]);
        std::iter::once((0.0, 0.0)).chain(rise).chain([(end, share(self.times.len()))]).collect()
    }

    /// Shortest time by which `percent` of all runs have escaped.
    fn quantile(&self, percent: usize) -> Option<f64> {
        let rank = (percent * self.runs).div_ceil(100).max(1);
        self.times.get(rank - 1).copied()
    }
}

fn seconds(time: Option<f64>) -> String {
    time.map_or("never".to_owned(), |t| format!("{t:.2} s"))
}

impl Figure for EscapeTimes<'_> {
    const NAME: &'static str = "escape-times";

    fn caption(&self) -> String {
        let counts: Vec<String> =
            self.curves.iter().map(|c| format!("{}: {} of {}", c.label, c.times.len(), c.runs)).collect();
        format!(
            "{}: share of runs freed from the trap within the time shown, one run for each random seed. Dots mark the \
             median and the 95th percentile of all runs. Runs that escaped: {}.",
            self.title,
            counts.join(", ")
        )
    }

    fn header(&self) -> Header {
        let name = |c: &Distribution| {
            let [median, high] = QUANTILES.map(|q| seconds(c.quantile(q)));
            format!("{} ({median}, {high})", c.label)
        };
        let mut legend: Vec<_> =
            self.curves.iter().enumerate().map(|(i, c)| entry(&name(c), numbered_stroke(i))).collect();
        legend.push(limit_entry("50 % and 95 %"));
        let failed: usize = self.curves.iter().map(|c| c.runs - c.times.len()).sum();
        let fate = match failed {
            0 => "Every run escapes.".to_owned(),
            failed => format!("{failed} of {} runs stay trapped.", self.curves.iter().map(|c| c.runs).sum::<usize>()),
        };
        let message = format!("{fate} In brackets: median and 95th percentile.");
        Header { heading: format!("Escape times – {}", self.title), message, legend }
    }

    fn body_height(&self) -> f64 {
        520.0
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let x = Axis::linear("time for which the reference is stopped (s)", span([0.0, self.end()]), 7);
        let panel = Panel::new(canvas, &Frame::LABELLED, x, Axis::linear("share of runs", 0.0..1.05, 5))?;
        for percent in QUANTILES {
            panel.level(percent as f64 / 100.0, &LIMIT)?;
        }
        for (i, curve) in self.curves.iter().enumerate() {
            panel.path(&curve.steps(self.end()), &numbered_stroke(i))?;
            for (percent, time) in QUANTILES.into_iter().filter_map(|q| Some((q, curve.quantile(q)?))) {
                panel.marker((time, percent as f64 / 100.0), &numbered_stroke(i))?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_count_failures_as_never() -> Result<(), FigureError> {
        let times: Vec<f64> = (1..=9).rev().map(f64::from).collect();
        let d = Distribution::new(&EscapeVariant { label: "", escape_s: &times, failures: 1 })?;
        assert_eq!(d.quantile(50), Some(5.0));
        assert_eq!(d.quantile(90), Some(9.0));
        assert_eq!(d.quantile(95), None);
        Ok(())
    }

    #[test]
    fn steps_rise_to_the_share_that_escaped() -> Result<(), FigureError> {
        let d = Distribution::new(&EscapeVariant { label: "", escape_s: &[2.0, 1.0], failures: 2 })?;
        assert_eq!(d.steps(3.0), [(0.0, 0.0), (1.0, 0.0), (1.0, 0.25), (2.0, 0.25), (2.0, 0.5), (3.0, 0.5)]);
        Ok(())
    }
}
