//! Mean speed of the tool against the joint-speed limit, all laws: the summary of a comparison.

use crate::canvas::{Canvas, Drawn, Header};
use crate::courses::CourseLaw;
use crate::error::FigureError;
use crate::facts::entry;
use crate::panel::{Frame, Panel};
use crate::polyline::Point;
use crate::render::{Figure, Rendered, make_directory, render};
use crate::scale::{Axis, largest, significant};
use crate::style::label;
use plotters::backend::DrawingBackend;
use std::path::Path;

/// Mean speeds under several joint-speed limits.
#[derive(Clone, Copy, Debug)]
pub struct MeanSpeedStudy<'a> {
    /// Heading of the figure: the scenario, in a few words.
    pub title: &'a str,
    /// One line for each law; what comes later lies on top.
    pub lines: &'a [MeanSpeedLine],
}

/// One law under several limits.
#[derive(Clone, Debug, PartialEq)]
pub struct MeanSpeedLine {
    /// The law.
    pub law: CourseLaw,
    /// Largest joint speed allowed (rad/s) and mean speed of the tool on the path (m/s), in the order of the limits.
    pub points: Vec<(f64, f64)>,
}

/// Draws mean speed against the peak joint speed allowed.
///
/// # Errors
///
/// No line, one with fewer than two points, a value that is not positive and finite, or files that cannot be written.
pub fn draw_mean_speed(study: &MeanSpeedStudy, dir: &Path) -> Result<Rendered, FigureError> {
    crate::style::register_fonts()?;
    if study.lines.is_empty() {
        return Err(FigureError::NoTraces);
    }
    for line in study.lines {
        let found = line.points.len();
        if found < 2 {
            return Err(FigureError::Length { what: "points of a mean speed", expected: 2, found });
        }
        if let Some(index) = line.points.iter().position(|p| ![p.0, p.1].iter().all(|v| *v > 0.0 && v.is_finite())) {
            return Err(FigureError::Value { what: "points of a mean speed", index });
        }
    }
    make_directory(dir)?;
    render(&MeanSpeed(study), dir)
}

struct MeanSpeed<'a>(&'a MeanSpeedStudy<'a>);

impl MeanSpeedLine {
    /// Mean speed over peak joint speed, at the last limit, m/rad.
    fn slope(&self) -> f64 {
        self.points.last().map_or(f64::NAN, |p| p.1 / p.0)
    }
}

impl Figure for MeanSpeed<'_> {
    const NAME: &'static str = "laws-mean-speed";

    fn caption(&self) -> String {
        format!(
            "{}: mean speed of the tool on the path against the largest joint speed allowed. Constant speed, natural motion and \
             the optimum are proportional to the limit; the sliding mode, its target rate scaled with the limits and its bandwidth left as it is, follows the optimum. A \
             point above the optimum means that the robot left the path, which the optimum may not.",
            self.0.title
        )
    }

    fn header(&self) -> Header {
        let best = self.0.lines.iter().find(|l| l.law == CourseLaw::Optimum).map(MeanSpeedLine::slope);
        let share = |line: &MeanSpeedLine| best.map(|b| format!(" ({})", significant(line.slope() / b, 3)));
        let name = |line: &MeanSpeedLine| match line.law {
            CourseLaw::Optimum => "optimum".to_owned(),
            CourseLaw::Method(method) => format!("{}{}", label(method), share(line).unwrap_or_default()),
        };
        Header {
            heading: format!("Mean speed and joint-speed limit – {}", self.0.title),
            message: if best.is_some() {
                "In brackets: share of the optimum's mean speed at the largest limit.".into()
            } else {
                String::new()
            },
            legend: self.0.lines.iter().map(|line| entry(&name(line), line.law.stroke())).collect(),
        }
    }

    fn body_height(&self) -> f64 {
        560.0
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let points = || self.0.lines.iter().flat_map(|l| l.points.iter().copied());
        let x = Axis::linear("largest joint speed allowed (rad/s)", 0.0..1.05 * largest(points().map(|p| p.0)), 7);
        let y = Axis::linear("mean tool speed (m/s)", 0.0..1.06 * largest(points().map(|p| p.1)), 6);
        let panel = Panel::new(canvas, &Frame::LABELLED, x, y)?;
        for line in self.0.lines {
            let points: Vec<Point> = line.points.clone();
            panel.path(&points, &line.law.stroke())?;
            points.iter().try_for_each(|p| panel.marker(*p, &line.law.stroke()))?;
        }
        Ok(())
    }
}
