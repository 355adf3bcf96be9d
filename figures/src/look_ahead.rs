//! Gain by looking ahead: time over the optimum's, against the length of the window.

use crate::canvas::{Canvas, Drawn, Header};
use crate::error::FigureError;
use crate::facts::{entry, reference_entry};
use crate::panel::{Frame, Panel};
use crate::polyline::Point;
use crate::render::{Figure, Rendered, make_directory, render};
use crate::scale::{Axis, significant, span};
use crate::style::{REFERENCE, stroke};
use plotters::backend::DrawingBackend;
use slideway_lab::Method;
use std::path::Path;

/// Runs of the look-ahead with windows of several lengths.
#[derive(Clone, Copy, Debug)]
pub struct LookAheadStudy<'a> {
    /// Heading of the figure: the scenario, in a few words.
    pub title: &'a str,
    /// Two points or more, in any order, of two different lengths or more.
    pub points: &'a [LookAheadPoint],
}

/// The run with one window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LookAheadPoint {
    /// Length of the window as a share of the path.
    pub share: f64,
    /// From the start of motion to the robot's arrival, over the optimum under the same limits.
    pub ratio: f64,
}

/// Draws the time ratio against the window's length (logarithmic).
///
/// # Errors
///
/// Fewer than two different lengths, a length or a ratio that is not positive and finite, or files that cannot be written.
pub fn draw_look_ahead(study: &LookAheadStudy, dir: &Path) -> Result<Rendered, FigureError> {
    crate::style::register_fonts()?;
    let figure = LookAhead::new(study)?;
    make_directory(dir)?;
    render(&figure, dir)
}

struct LookAhead<'a> {
    title: &'a str,
    /// Share of the path in percent, time over the optimum's.
    points: Vec<Point>,
}

impl<'a> LookAhead<'a> {
    fn new(study: &LookAheadStudy<'a>) -> Result<Self, FigureError> {
        let is_usable = |p: &LookAheadPoint| [p.share, p.ratio].iter().all(|v| *v > 0.0 && v.is_finite());
        if let Some(index) = study.points.iter().position(|p| !is_usable(p)) {
            return Err(FigureError::Value { what: "points of the look-ahead", index });
        }
        let mut points: Vec<Point> = study.points.iter().map(|p| (100.0 * p.share, p.ratio)).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let lengths = points.chunk_by(|a, b| a.0 == b.0).count();
        if lengths < 2 {
            let what = "different windows of the look-ahead";
            return Err(FigureError::Length { what, expected: 2, found: lengths });
        }
        Ok(Self { title: study.title, points })
    }
}

impl Figure for LookAhead<'_> {
    const NAME: &'static str = "look-ahead";

    fn caption(&self) -> String {
        let (shortest, longest) = (self.points[0], self.points[self.points.len() - 1]);
        format!(
            "{}: time from the start of motion to the arrival at rest, over the optimum under the same speed and acceleration \
             limits, against the length of the window that the regulator sees ahead. {} times the optimum with {} % of the path in \
             sight, {} times with {} %.",
            self.title,
            significant(shortest.1, 4),
            significant(shortest.0, 2),
            significant(longest.1, 4),
            significant(longest.0, 3)
        )
    }

    fn header(&self) -> Header {
        let best = self.points.iter().map(|p| p.1).fold(f64::INFINITY, f64::min);
        // The shortest window whose time is within one per cent of the best one.
        let enough = self.points.iter().find(|p| p.1 <= 1.01 * best).map_or(f64::NAN, |p| p.0);
        let message = format!("{} % of the path in sight comes within 1 % of the best time.", significant(enough, 2));
        let legend =
            vec![entry("look-ahead", stroke(Method::AccelerationLookAhead)), reference_entry("optimum, T = T*")];
        Header { heading: format!("What looking ahead buys – {}", self.title), message, legend }
    }

    fn body_height(&self) -> f64 {
        560.0
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let lengths = span(self.points.iter().map(|p| p.0));
        let x = Axis::logarithmic("window (% of the path)", lengths.clone(), 9);
        let y = Axis::linear("T / T*", span(self.points.iter().map(|p| p.1).chain([1.0])), 6);
        let panel = Panel::new(canvas, &Frame::LABELLED, x, y)?;
        panel.path(&[(lengths.start, 1.0), (lengths.end, 1.0)], &REFERENCE)?;
        let style = stroke(Method::AccelerationLookAhead);
        panel.path(&self.points, &style)?;
        self.points.iter().try_for_each(|p| panel.marker(*p, &style))
    }
}
