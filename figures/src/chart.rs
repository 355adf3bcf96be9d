//! Panels one above the other, each with axes of its own: the figure of a study.

use crate::canvas::{Canvas, Drawn, Header};
use crate::error::FigureError;
use crate::facts::entry;
use crate::panel::{Frame, Panel};
use crate::polyline::Point;
use crate::render::{Figure, Rendered, make_directory, render};
use crate::scale::{Axis, span};
use crate::style::{LIMIT, REFERENCE, Stroke, WIDTH, numbered_stroke};
use plotters::backend::DrawingBackend;
use std::ops::Range;
use std::path::Path;

/// A chart: its heading, its sentence and its panels.
#[derive(Clone, Debug)]
pub struct Chart<'a> {
    /// Heading.
    pub title: &'a str,
    /// Findings, in a sentence or two.
    pub message: &'a str,
    /// From top to bottom, one or more.
    pub panels: Vec<ChartPanel<'a>>,
}

/// Axes with curves in them.
#[derive(Clone, Debug)]
pub struct ChartPanel<'a> {
    /// Heading: the quantities that it shows.
    pub title: &'a str,
    /// Label of the horizontal axis.
    pub x: &'a str,
    /// Label of the vertical axis.
    pub y: &'a str,
    /// Scales of the axes.
    pub scales: ChartScales,
    /// Curves. What comes later lies on top; a name stands for the same line style in all panels.
    pub curves: Vec<ChartCurve<'a>>,
    /// Horizontal lines with their names.
    pub levels: Vec<(&'a str, f64)>,
}

/// Scaling of a panel's axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChartScales {
    /// Each fills its side.
    Filling,
    /// The same length means the same amount on both.
    Equal,
}

/// A curve of any shape.
#[derive(Clone, Copy, Debug)]
pub struct ChartCurve<'a> {
    /// Its name in the legend.
    pub name: &'a str,
    /// Role: reference or result.
    pub role: ChartRole,
    /// Its points; values that are not numbers make gaps.
    pub points: &'a [[f64; 2]],
}

/// Role of a curve; the same for all curves of a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChartRole {
    /// A course to be followed: broad and pale.
    Reference,
    /// A course that came about.
    Result,
}

/// Draws a chart into `chart.svg` and `chart.png`.
///
/// # Errors
///
/// A chart without panels, a panel without a finite point, or files that cannot be written.
pub fn draw_chart(chart: &Chart, dir: &Path) -> Result<Rendered, FigureError> {
    crate::style::register_fonts()?;
    let figure = Checked::new(chart)?;
    make_directory(dir)?;
    render(&figure, dir)
}

struct Checked<'a> {
    chart: &'a Chart<'a>,
    /// Distinct names of curves in the order of their first appearance.
    names: Vec<(&'a str, ChartRole)>,
}

/// Height of one panel with its labels, design units.
const HEIGHT: f64 = 460.0;
/// Heights between which a panel with equal scales is as high as its curves ask for.
const EQUAL: (f64, f64) = (HEIGHT, 760.0);
/// Height of a panel's title and labels.
const AROUND: f64 = Frame::LABELLED.bottom + 50.0;
/// Width of the axes.
const WIDE: f64 = WIDTH - Frame::LABELLED.left - Frame::EDGE - Frame::RIGHT;
/// Air around curves, as a factor of their extent.
const AIR: f64 = 1.08;

impl<'a> Checked<'a> {
    fn new(chart: &'a Chart<'a>) -> Result<Self, FigureError> {
        if chart.panels.is_empty() {
            return Err(FigureError::Length { what: "panels of a chart", expected: 1, found: 0 });
        }
        let is_drawable = |panel: &ChartPanel| panel.points().any(|p| p.0.is_finite() && p.1.is_finite());
        if let Some(index) = chart.panels.iter().position(|panel| !is_drawable(panel)) {
            return Err(FigureError::Value { what: "panels of a chart", index });
        }
        let mut names: Vec<(&str, ChartRole)> = Vec::new();
        for curve in chart.panels.iter().flat_map(|panel| &panel.curves) {
            if !names.iter().any(|(name, _)| *name == curve.name) {
                names.push((curve.name, curve.role));
            }
        }
        Ok(Self { chart, names })
    }

    fn stroke(&self, name: &str) -> Stroke {
        let results = self.names.iter().filter(|(_, role)| *role == ChartRole::Result);
        results.map(|(n, _)| *n).position(|n| n == name).map_or(REFERENCE, numbered_stroke)
    }
}

impl ChartPanel<'_> {
    fn points(&self) -> impl Iterator<Item = Point> + '_ {
        self.curves.iter().flat_map(|curve| curve.points.iter().map(|p| (p[0], p[1])))
    }

    fn height(&self) -> f64 {
        let [x, y] = self.extent();
        match self.scales {
            ChartScales::Filling => HEIGHT,
            ChartScales::Equal => {
                let width = (x.end - x.start).max(f64::MIN_POSITIVE);
                (AROUND + WIDE * (y.end - y.start) / width).clamp(EQUAL.0, EQUAL.1)
            }
        }
    }

    /// Ranges that the curves and lines cover, of x and of y.
    fn extent(&self) -> [Range<f64>; 2] {
        let finite = || self.points().filter(|p| p.0.is_finite() && p.1.is_finite());
        [span(finite().map(|p| p.0)), span(finite().map(|p| p.1).chain(self.levels.iter().map(|l| l.1)))]
    }

    /// Ranges of both axes with a little air around the curves and lines.
    fn ranges(&self) -> [Range<f64>; 2] {
        let [x, y] = self.extent();
        match self.scales {
            ChartScales::Filling => [x, widened(&y, AIR)],
            ChartScales::Equal => {
                let height = self.height() - AROUND;
                let unit = (AIR * (x.end - x.start) / WIDE).max(AIR * (y.end - y.start) / height);
                [around(&x, unit * WIDE), around(&y, unit * height)]
            }
        }
    }

    fn draw<DB: DrawingBackend>(&self, canvas: &Canvas<DB>, figure: &Checked) -> Drawn<DB> {
        let [x, y] = self.ranges();
        let frame = Frame { title: self.title, ..Frame::LABELLED };
        let panel = Panel::new(canvas, &frame, Axis::linear(self.x, x, 8), Axis::linear(self.y, y, 5))?;
        for (_, value) in &self.levels {
            panel.level(*value, &LIMIT)?;
        }
        for curve in &self.curves {
            let points: Vec<Point> = curve.points.iter().map(|p| (p[0], p[1])).collect();
            panel.path(&points, &figure.stroke(curve.name))?;
        }
        Ok(())
    }
}

fn around(range: &Range<f64>, length: f64) -> Range<f64> {
    let middle = 0.5 * (range.start + range.end);
    middle - 0.5 * length..middle + 0.5 * length
}

fn widened(range: &Range<f64>, factor: f64) -> Range<f64> {
    around(range, factor * (range.end - range.start))
}

impl Figure for Checked<'_> {
    const NAME: &'static str = "chart";

    fn caption(&self) -> String {
        let panels: Vec<&str> = self.chart.panels.iter().map(|panel| panel.title).collect();
        format!("{}. From top to bottom: {}. {}", self.chart.title, panels.join("; "), self.chart.message)
    }

    fn header(&self) -> Header {
        let mut legend: Vec<_> = self.names.iter().map(|(name, _)| entry(name, self.stroke(name))).collect();
        let mut levels: Vec<&str> = Vec::new();
        for (name, _) in self.chart.panels.iter().flat_map(|panel| &panel.levels) {
            if !levels.contains(name) {
                levels.push(name);
                legend.push(entry(name, LIMIT));
            }
        }
        Header { heading: self.chart.title.to_owned(), message: self.chart.message.to_owned(), legend }
    }

    fn body_height(&self) -> f64 {
        self.chart.panels.iter().map(ChartPanel::height).sum()
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let mut top = 0.0;
        for panel in &self.chart.panels {
            let (_, from_here) = canvas.split_at_height(top);
            // The last panel may be a pixel short of its height by rounding.
            let height = panel.height().min(from_here.size().1);
            let (place, _) = from_here.split_at_height(height);
            panel.draw(&place, self)?;
            top += panel.height();
        }
        Ok(())
    }
}
