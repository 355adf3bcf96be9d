//! `σ_i` over time: who keeps the constraints, and who comes how near (the quantities of `[G12]` Fig. 4, 6, 8, 10).

use super::facts::{header, length};
use super::study::{Checked, PathRun, Unit, roomy};
use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::{entry, limit_entry};
use crate::polyline::Point;
use crate::render::Figure;
use crate::scale::Axis;
use crate::stack::{self, Layer};
use crate::style::{LIMIT, REFERENCE, path_label, path_stroke};
use plotters::backend::DrawingBackend;
use slideway_conditioner::path::{Constraint, Motion};
use slideway_lab::conditioning::PathMethod;
use std::ops::Range;

pub(crate) struct Sigma<'a>(pub(crate) &'a Checked<'a>);

const PANEL: f64 = 235.0;
/// A close-up shows less than this share of the whole range.
const CLOSE: f64 = 0.2;

impl Sigma<'_> {
    /// The run whose clock the reference's own `σ` is drawn on.
    fn clock(&self) -> &PathRun<'_> {
        // A study has at least one run.
        self.0.conditioners().next().unwrap_or(&self.0.runs[0])
    }

    /// Values of `σ_i` over time that the reference alone would have.
    fn unconditioned(&self, i: usize) -> Vec<Point> {
        let constraint = &self.0.study.problem.constraints[i];
        let sigma = |time, position| constraint.sample(&Motion { time, position, velocity: [0.0; 3] }).value;
        self.clock().samples.iter().map(|s| (s.t, sigma(s.t, s.reference))).collect()
    }

    fn range(&self, i: usize) -> Range<f64> {
        let reference = self.unconditioned(i);
        roomy(self.0.shown().map(|s| s.sigma[i]).chain(reference.iter().map(|p| p.1)))
    }

    /// A range around zero that shows how near the methods come, if that is little of the whole.
    fn close_up(&self, i: usize) -> Option<Range<f64>> {
        // A potential field keeps its distance.
        let runs = self.0.runs.iter().filter(|run| run.method != PathMethod::PotentialField);
        let nearest = runs.map(|run| run.summary.max_sigma_m[i]).filter(|s| s.is_finite());
        let whole = self.range(i);
        let length = whole.end - whole.start;
        // Those that stay far away do not decide what is near.
        let near: Vec<f64> = nearest.filter(|s| s.abs() < 0.25 * CLOSE * length).collect();
        let most = near.iter().map(|s| s.abs()).fold(0.0, f64::max).max(1e-3 * length);
        let close = -4.0 * most..2.0 * most;
        (!near.is_empty() && close.end - close.start < CLOSE * length).then_some(close)
    }

    fn layer(&self, i: usize, title: String, range: &Range<f64>) -> Layer {
        let unit = Unit::of(range);
        let broad = (scaled(&self.unconditioned(i), unit.factor), REFERENCE);
        let curve = |run: &PathRun| (run.against_time(unit.apply(|s| s.sigma[i])), path_stroke(run.method));
        Layer {
            title,
            y: Axis::linear(unit.name, unit.scale(range), 4),
            levels: vec![(0.0, LIMIT)],
            curves: std::iter::once(broad).chain(self.0.runs.iter().map(curve)).collect(),
        }
    }

    fn layers(&self) -> Vec<Layer> {
        let of_constraint = |i: usize| {
            let name = self.0.name(i);
            let close = self.close_up(i).map(|range| self.layer(i, format!("σ of {name}, close to the limit"), &range));
            std::iter::once(self.layer(i, format!("σ of {name}"), &self.range(i))).chain(close)
        };
        (0..self.0.constraints()).flat_map(of_constraint).collect()
    }

    fn panels(&self) -> usize {
        (0..self.0.constraints()).map(|i| 1 + usize::from(self.close_up(i).is_some())).sum()
    }
}

fn scaled(points: &[Point], factor: f64) -> Vec<Point> {
    points.iter().map(|p| (p.0, factor * p.1)).collect()
}

impl Figure for Sigma<'_> {
    const NAME: &'static str = "sigma";

    fn caption(&self) -> String {
        let clock = if self.0.has_trap() {
            format!(", on the clock of {}", path_label(self.clock().method))
        } else {
            String::new()
        };
        format!(
            "{}: constraint functions σ over time, allowed where they are negative; the broad line is what the reference \
             alone would do{clock}. Largest values are over the whole run and all constraints.{}",
            self.0.study.title,
            self.0.time_remark()
        )
    }

    fn header(&self) -> Header {
        let worst =
            |run: &PathRun| length(run.summary.max_sigma_m.iter().copied().fold(f64::NEG_INFINITY, f64::max), 2);
        let meaning = "largest σ; a constraint is broken where it is positive";
        let mut header = header(self.0, "Constraints", meaning, &self.0.runs, worst);
        header.legend.insert(0, entry("reference alone", REFERENCE));
        header.legend.push(limit_entry("limit"));
        header
    }

    fn body_height(&self) -> f64 {
        stack::height(self.panels(), PANEL)
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        stack::draw(canvas, &Axis::linear("time (s)", 0.0..self.0.end(), 7), self.layers(), PANEL)
    }
}
