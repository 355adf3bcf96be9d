//! Distance to the path of the QP safety filter against the sampling period: it falls linearly.

use crate::canvas::{Canvas, Drawn, Header};
use crate::error::FigureError;
use crate::facts::{entry, reference_entry};
use crate::panel::{Frame, Panel};
use crate::polyline::Point;
use crate::render::{Figure, Rendered, make_directory, render};
use crate::scale::{Axis, significant, span};
use crate::style::{REFERENCE, numbered_stroke};
use plotters::backend::DrawingBackend;
use std::path::Path;

/// Distances of a conditioned path from the path of the QP safety filter at several sampling periods.
#[derive(Clone, Copy, Debug)]
pub struct ConvergenceStudy<'a> {
    /// Heading of the figure: scenario and method, in a few words.
    pub title: &'a str,
    /// Two points or more, in any order, at two different periods or more.
    pub points: &'a [ConvergencePoint],
}

/// The distance at one sampling period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConvergencePoint {
    /// Sampling period, s.
    pub period_s: f64,
    /// Mean distance over all samples, m.
    pub mean_distance_m: f64,
    /// Largest distance, m.
    pub max_distance_m: f64,
}

/// Draws mean and largest distance against the sampling period on logarithmic axes, each with its fitted slope.
///
/// # Errors
///
/// Fewer than two points, two equal ones only, a period or a distance that is not positive and finite, or files that
/// cannot be written.
pub fn draw_convergence(study: &ConvergenceStudy, dir: &Path) -> Result<Rendered, FigureError> {
    crate::style::register_fonts()?;
    let figure = Convergence::new(study)?;
    make_directory(dir)?;
    render(&figure, dir)
}

struct Convergence<'a> {
    study: &'a ConvergenceStudy<'a>,
    mean: Series,
    largest: Series,
}

/// Points in milliseconds and millimetres with the line fitted to their logarithms.
struct Series {
    points: Vec<Point>,
    slope: f64,
    /// Decimal logarithm at 1 ms.
    offset: f64,
}

impl Series {
    /// Least squares on decimal logarithms.
    fn new(points: Vec<Point>) -> Self {
        let count = points.len() as f64;
        let logs: Vec<Point> = points.iter().map(|p| (p.0.log10(), p.1.log10())).collect();
        let (x, y) = (logs.iter().map(|p| p.0).sum::<f64>() / count, logs.iter().map(|p| p.1).sum::<f64>() / count);
        let across: f64 = logs.iter().map(|p| (p.0 - x) * (p.0 - x)).sum();
        let along: f64 = logs.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
        let slope = along / across;
        Self { points, slope, offset: y - slope * x }
    }

    fn line(&self) -> Vec<Point> {
        let periods = span(self.points.iter().map(|p| p.0));
        [periods.start, periods.end].map(|t| (t, 10f64.powf(self.offset + self.slope * t.log10()))).to_vec()
    }
}

impl<'a> Convergence<'a> {
    fn new(study: &'a ConvergenceStudy<'a>) -> Result<Self, FigureError> {
        let is_usable = |p: &ConvergencePoint| {
            [p.period_s, p.mean_distance_m, p.max_distance_m].iter().all(|v| *v > 0.0 && v.is_finite())
        };
        if let Some(index) = study.points.iter().position(|p| !is_usable(p)) {
            return Err(FigureError::Value { what: "points of the convergence", index });
        }
        let mut points = study.points.to_vec();
        points.sort_by(|a, b| a.period_s.total_cmp(&b.period_s));
        let periods = points.chunk_by(|a, b| a.period_s == b.period_s).count();
        if periods < 2 {
            let what = "different sampling periods of the convergence";
            return Err(FigureError::Length { what, expected: 2, found: periods });
        }
        let series = |distance: fn(&ConvergencePoint) -> f64| {
            Series::new(points.iter().map(|p| (1e3 * p.period_s, 1e3 * distance(p))).collect())
        };
        Ok(Self { study, mean: series(|p| p.mean_distance_m), largest: series(|p| p.max_distance_m) })
    }
}

impl Figure for Convergence<'_> {
    const NAME: &'static str = "convergence";

    fn caption(&self) -> String {
        let finest = self.mean.points[0];
        format!(
            "{}: distance between the conditioned path and the path of the QP safety filter against the sampling period, \
             with lines fitted to the logarithms by least squares; slope 1 means that the distance falls in proportion to \
             the period. Mean distance at the shortest period, {} ms: {} mm.",
            self.study.title,
            significant(finest.0, 2),
            significant(finest.1, 2)
        )
    }

    fn header(&self) -> Header {
        let (mean, largest) = (self.mean.slope, self.largest.slope);
        let message = format!("The mean falls with slope {mean:.2}, the largest with slope {largest:.2}.");
        let legend = vec![
            entry("mean distance", numbered_stroke(0)),
            entry("largest distance", numbered_stroke(1)),
            reference_entry("fit"),
        ];
        Header { heading: format!("Distance to the QP path – {}", self.study.title), message, legend }
    }

    fn body_height(&self) -> f64 {
        560.0
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let both = || [&self.mean, &self.largest].into_iter().flat_map(|s| s.points.iter().copied().chain(s.line()));
        let x = Axis::logarithmic("sampling period (ms)", span(both().map(|p| p.0)), 9);
        let y = Axis::logarithmic("distance (mm)", span(both().map(|p| p.1)), 12);
        let panel = Panel::new(canvas, &Frame::LABELLED, x, y)?;
        for (number, series) in [&self.mean, &self.largest].into_iter().enumerate() {
            panel.path(&series.line(), &REFERENCE)?;
            panel.path(&series.points, &numbered_stroke(number))?;
            series.points.iter().try_for_each(|p| panel.marker(*p, &numbered_stroke(number)))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fit_finds_the_slope_of_a_power_law() {
        let series = Series::new([0.05, 0.2, 1.0].map(|t: f64| (t, 3.0 * t.powf(1.25))).to_vec());
        // Rounding of a few logarithms only.
        assert!((series.slope - 1.25).abs() < 1e-12);
        assert!((series.offset - 3f64.log10()).abs() < 1e-12);
    }
}
