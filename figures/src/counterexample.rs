//! Figure of the run that contradicts a statement: the statement as a line, the run sample by sample.

use crate::canvas::{Canvas, Drawn, Header};
use crate::error::FigureError;
use crate::facts::entry;
use crate::panel::{Frame, Panel};
use crate::polyline::Point;
use crate::render::{Figure, Rendered, make_directory, render};
use crate::scale::{Axis, span};
use crate::style::{LIMIT, numbered_stroke};
use plotters::backend::DrawingBackend;
use std::path::Path;

/// A statement and the run that contradicts it.
#[derive(Clone, Copy, Debug)]
pub struct Counterexample<'a> {
    /// Heading: the statement's name.
    pub title: &'a str,
    /// Description of the run, in a sentence.
    pub message: &'a str,
    /// Label of the vertical axis, with its unit.
    pub quantity: &'a str,
    /// Words of the statement for the legend.
    pub saying: &'a str,
    /// Number of the sample and the value that the statement gives there; values that are not numbers make gaps.
    pub said: &'a [[f64; 2]],
    /// Number of the sample and the value of the run there, two or more.
    pub found: &'a [[f64; 2]],
}

/// Draws the run, every sample marked, into `counterexample.svg` and `counterexample.png`.
///
/// # Errors
///
/// Fewer than two samples, a sample that is not finite, or files that cannot be written.
pub fn draw_counterexample(example: &Counterexample, dir: &Path) -> Result<Rendered, FigureError> {
    crate::style::register_fonts()?;
    let what = "samples of a counterexample";
    if example.found.len() < 2 {
        return Err(FigureError::Length { what, expected: 2, found: example.found.len() });
    }
    if let Some(index) = example.found.iter().position(|p| !p.iter().all(|v| v.is_finite())) {
        return Err(FigureError::Value { what, index });
    }
    make_directory(dir)?;
    render(&Checked(example), dir)
}

struct Checked<'a>(&'a Counterexample<'a>);

fn points(of: &[[f64; 2]]) -> Vec<Point> {
    of.iter().map(|p| (p[0], p[1])).collect()
}

impl Figure for Checked<'_> {
    const NAME: &'static str = "counterexample";

    fn caption(&self) -> String {
        let Counterexample { title, message, quantity, saying, .. } = self.0;
        format!(
            "{title}: {quantity}, sample by sample on the shipped code, and what is said about it ({saying}). {message}"
        )
    }

    fn header(&self) -> Header {
        Header {
            heading: self.0.title.to_owned(),
            message: self.0.message.to_owned(),
            legend: vec![entry("found", numbered_stroke(0)), entry(&format!("said: {}", self.0.saying), LIMIT)],
        }
    }

    fn body_height(&self) -> f64 {
        520.0
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let (found, said) = (points(self.0.found), points(self.0.said));
        let samples = span(found.iter().chain(&said).map(|p| p.0));
        let values = span(found.iter().chain(&said).map(|p| p.1).chain([0.0]));
        // Markers are not cut: a fortieth of the axis on the left and on the right, a tenth above.
        let aside = 0.025 * (samples.end - samples.start);
        let x = Axis::linear("sample", samples.start - aside..samples.end + aside, found.len().min(10));
        let y = Axis::linear(self.0.quantity, values.start..values.end + 0.1 * (values.end - values.start), 6);
        let panel = Panel::new(canvas, &Frame::LABELLED, x, y)?;
        panel.path(&said, &LIMIT)?;
        panel.path(&found, &numbered_stroke(0))?;
        found.iter().try_for_each(|p| panel.marker(*p, &numbered_stroke(0)))
    }
}
