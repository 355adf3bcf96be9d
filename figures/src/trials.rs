//! Figure of random trials: the measured value of each guarantee, against the size of the disturbances.

use crate::canvas::{Canvas, Drawn, Header};
use crate::error::FigureError;
use crate::facts::{entry, limit_entry};
use crate::panel::{Frame, Panel};
use crate::polyline::Point;
use crate::render::{Figure, Rendered, make_directory, render};
use crate::scale::{Axis, span};
use crate::style::{LIMIT, Stroke, WIDTH, numbered_stroke};
use plotters::backend::DrawingBackend;
use std::collections::BTreeSet;
use std::ops::Range;
use std::path::Path;

/// The trials of a campaign.
#[derive(Clone, Copy, Debug)]
pub struct TrialsStudy<'a> {
    /// Heading of the figure: the scenario, in a few words.
    pub title: &'a str,
    /// One panel for each guarantee, from top to bottom.
    pub panels: &'a [TrialsPanel<'a>],
}

/// One guarantee.
#[derive(Clone, Debug)]
pub struct TrialsPanel<'a> {
    /// Its name.
    pub name: &'a str,
    /// Unit of what is measured; empty without one.
    pub unit: &'a str,
    /// The bounds of all trials, from below and from above; empty where each trial has its own.
    pub bounds: Vec<f64>,
    /// Every trial in which it was checked.
    pub points: Vec<TrialPoint>,
}

/// One guarantee in one trial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrialPoint {
    /// Size of the disturbances, 0 to 1.
    pub size: f64,
    /// Measured value.
    pub measured: f64,
    /// Distance from the bound as a share of its size; negative where it is exceeded.
    pub margin: f64,
}

/// Draws what was measured against the size of the disturbances, the bound as a line: a panel for each guarantee. Where each
/// trial has a bound of its own the margin is drawn instead, and zero as the line.
///
/// Points that would lie on each other are drawn once. A measurement that is no number has no place and is left out.
///
/// # Errors
///
/// No panel, one without points, or files that cannot be written.
pub fn draw_trials(study: &TrialsStudy, dir: &Path) -> Result<Rendered, FigureError> {
    crate::style::register_fonts()?;
    if study.panels.is_empty() {
        return Err(FigureError::NoTraces);
    }
    if study.panels.iter().any(|panel| panel.points.is_empty()) {
        return Err(FigureError::Length { what: "trials of a guarantee", expected: 1, found: 0 });
    }
    make_directory(dir)?;
    render(&Trials(study), dir)
}

struct Trials<'a>(&'a TrialsStudy<'a>);

/// Height of a panel without the labels below, design units.
const PANEL: f64 = 300.0;
/// Points closer than this are drawn once, design units: a little less than a dot.
const CELL: f64 = 6.0;
/// Radius of a dot, design units.
const DOT: f64 = 5.0;
/// Air around points and lines, as a factor of their extent.
const AIR: f64 = 1.1;

impl TrialPoint {
    fn kept(&self) -> bool {
        self.margin >= 0.0
    }
}

impl TrialsPanel<'_> {
    fn y_label(&self) -> String {
        match (!self.bounds.is_empty(), self.unit) {
            (false, _) => "margin".to_owned(),
            (true, "" | "1") => "measured".to_owned(),
            (true, unit) => format!("measured ({unit})"),
        }
    }

    /// Where its points and lines lie: measurements with their bounds, or margins above zero.
    fn layout(&self) -> Layout {
        let margins = self.bounds.is_empty();
        let height = |p: &TrialPoint| if margins { p.margin } else { p.measured };
        let places = |kept: bool| self.points.iter().filter(move |p| p.kept() == kept).map(|p| (p.size, height(p)));
        let levels = if margins { vec![0.0] } else { self.bounds.clone() };
        let heights = self.points.iter().map(height).chain(levels.iter().copied());
        let range = widened(&span(heights));
        Layout {
            kept: apart(places(true), &range),
            violated: apart(places(false), &range),
            y: Axis::linear(&self.y_label(), range, 4),
            levels,
        }
    }

    fn draw<DB: DrawingBackend>(&self, canvas: &Canvas<DB>, bottom: f64) -> Drawn<DB> {
        let layout = self.layout();
        let size = Axis::linear("size of the disturbances (share of their range)", 0.0..1.0, 5);
        let x = if bottom > Frame::TICKS { size } else { size.unlabelled() };
        let panel = Panel::new(canvas, &Frame { title: self.name, bottom, ..Frame::LABELLED }, x, layout.y)?;
        layout.levels.iter().try_for_each(|level| panel.level(*level, &LIMIT))?;
        layout.kept.iter().try_for_each(|p| panel.dot(*p, &kept_stroke(), DOT))?;
        layout.violated.iter().try_for_each(|p| panel.dot(*p, &violated_stroke(), DOT))
    }
}

struct Layout {
    y: Axis,
    levels: Vec<f64>,
    kept: Vec<Point>,
    violated: Vec<Point>,
}

/// The points, those left out that would lie on an earlier one.
fn apart(points: impl Iterator<Item = Point>, range: &Range<f64>) -> Vec<Point> {
    let cell = |p: &Point| {
        let height = PANEL * (p.1 - range.start) / (range.end - range.start);
        [WIDTH * p.0, height].map(|place| (place / CELL).floor() as i64)
    };
    let mut taken = BTreeSet::new();
    points.filter(|p| taken.insert(cell(p))).collect()
}

fn widened(range: &Range<f64>) -> Range<f64> {
    let (middle, half) = (0.5 * (range.start + range.end), 0.5 * AIR * (range.end - range.start));
    middle - half..middle + half
}

/// Dots in the legend: squares as wide as they are long.
const DOTS: &[f64] = &[2.0 * DOT, 14.0];

fn kept_stroke() -> Stroke {
    Stroke { width: 2.0 * DOT, dashes: DOTS, ..numbered_stroke(0) }
}

fn violated_stroke() -> Stroke {
    Stroke { width: 2.0 * DOT, dashes: DOTS, ..numbered_stroke(1) }
}

impl Figure for Trials<'_> {
    const NAME: &'static str = "trials";

    fn caption(&self) -> String {
        let names: Vec<&str> = self.0.panels.iter().map(|panel| panel.name).collect();
        format!(
            "{}: what each trial measured against the size of its disturbances, a dot a trial, with the bound as a dashed line; \
             where each trial has a bound of its own, the margin as a share of the bound. From top to bottom: {}. Measurements \
             that are no numbers are not drawn.",
            self.0.title,
            names.join(", ")
        )
    }

    fn header(&self) -> Header {
        let violations = self.0.panels.iter().flat_map(|panel| &panel.points).filter(|p| !p.kept()).count();
        let checks: usize = self.0.panels.iter().map(|panel| panel.points.len()).sum();
        let mut legend = vec![entry("kept", kept_stroke())];
        if violations > 0 {
            legend.push(entry("violated", violated_stroke()));
        }
        legend.push(limit_entry("bound"));
        let message = match violations {
            0 => format!("{checks} checks, no violation."),
            violations => format!("{violations} of {checks} checks violated."),
        };
        Header { heading: format!("Trials and guarantees – {}", self.0.title), message, legend }
    }

    fn body_height(&self) -> f64 {
        PANEL * self.0.panels.len() as f64 + Frame::LABELLED.bottom - Frame::TICKS
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        for (i, panel) in self.0.panels.iter().enumerate() {
            // The lowest panel carries the labels of the horizontal axis.
            let bottom = if i + 1 < self.0.panels.len() { Frame::TICKS } else { Frame::LABELLED.bottom };
            let (_, from_here) = canvas.split_at_height(PANEL * i as f64);
            let height = (PANEL - Frame::TICKS + bottom).min(from_here.size().1);
            let (place, _) = from_here.split_at_height(height);
            panel.draw(&place, bottom)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Measured under a bound of 1.
    fn point(size: f64, measured: f64) -> TrialPoint {
        TrialPoint { size, measured, margin: 1.0 - measured }
    }

    fn panel(points: &[TrialPoint], bounds: &[f64]) -> TrialsPanel<'static> {
        TrialsPanel { name: "band", unit: "", bounds: bounds.to_vec(), points: points.to_vec() }
    }

    #[test]
    fn bounds_of_all_trials_are_lines_and_without_them_margins_are_drawn() {
        let points = [point(0.1, 0.25), point(0.9, 0.75)];
        let measured = panel(&points, &[0.0, 1.0]).layout();
        assert_eq!((measured.levels, measured.kept), (vec![0.0, 1.0], vec![(0.1, 0.25), (0.9, 0.75)]));
        let margins = panel(&points, &[]).layout();
        assert_eq!((margins.levels, margins.kept), (vec![0.0], vec![(0.1, 0.75), (0.9, 0.25)]));
    }

    #[test]
    fn violations_lie_apart_and_what_is_no_number_counts_as_one() {
        let points = [point(0.1, 0.5), point(0.9, 1.5), point(0.5, f64::NAN)];
        let layout = panel(&points, &[1.0]).layout();
        assert_eq!((layout.kept.len(), layout.violated.len()), (1, 2));
    }

    #[test]
    fn points_on_each_other_are_drawn_once() {
        let many: Vec<TrialPoint> = (0..100_000).map(|i| point(f64::from(i) / 1e5, 0.5)).collect();
        // One row of cells, each CELL of WIDTH wide.
        assert_eq!(panel(&many, &[1.0]).layout().kept.len(), (WIDTH / CELL).ceil() as usize);
    }

    #[test]
    fn a_study_without_trials_is_refused() {
        let dir = std::env::temp_dir();
        assert!(draw_trials(&TrialsStudy { title: "t", panels: &[] }, &dir).is_err());
        assert!(draw_trials(&TrialsStudy { title: "t", panels: &[panel(&[], &[])] }, &dir).is_err());
    }
}
