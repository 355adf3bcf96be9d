//! Reference, conditioned paths and obstacles in space and in three projections (the quantities of `[G12]` Fig. 3, 5, 7, 9).

use super::boundary::Boundary;
use super::facts::{header, length};
use super::study::{Checked, PathRun};
use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::{entry, reference_entry};
use crate::render::Figure;
use crate::space::{FOUR_VIEWS, Space, four_views};
use crate::style::{HATCH, INK, REFERENCE, Stroke, path_stroke};
use plotters::backend::DrawingBackend;
use slideway_lab::conditioning::ConditionedSample;

pub(crate) struct ConditionedPath<'a> {
    checked: &'a Checked<'a>,
    reference: Vec<[f64; 3]>,
    boundaries: Vec<Boundary<'a>>,
    space: Space,
}

const VIEWS: [[usize; 2]; 3] = [[0, 1], [0, 2], [1, 2]];
const BOUNDARY: Stroke = Stroke { color: INK, width: 3.0, dashes: &[] };
/// A method that flies off is shown up to so many lengths of the reference away from it.
const REACH: f64 = 5.0;

impl<'a> ConditionedPath<'a> {
    pub(crate) fn new(checked: &'a Checked<'a>) -> Self {
        let problem = checked.study.problem;
        let clock = |i: i32| problem.reference.duration() * f64::from(i) / 500.0;
        let reference: Vec<_> = (0..=500).map(|i| problem.reference.at(clock(i), clock(i), 1.0).position).collect();
        let made = checked.runs.iter().flat_map(|run| run.samples).map(|s| s.position);
        let space = Space::new(&reference, made, REACH);
        let boundaries = problem.constraints.iter().map(|c| Boundary::new(problem, c)).collect();
        Self { checked, reference, boundaries, space }
    }

    fn project<DB: DrawingBackend>(&self, canvas: &Canvas<DB>, axes: [usize; 2]) -> Drawn<DB> {
        let panel = self.space.projection(canvas, axes)?;
        let flat = |points: &[[f64; 3]]| points.iter().map(|p| (p[axes[0]], p[axes[1]])).collect::<Vec<_>>();
        for (i, boundary) in self.boundaries.iter().enumerate() {
            let slice = boundary.slice(axes, self.space.ranges(axes));
            let contour = slice.contour();
            // A cut that lies wholly on the forbidden side says nothing about where the paths may go.
            if contour.is_empty() {
                continue;
            }
            for [a, b] in slice.hatching(if i.is_multiple_of(2) { 1.0 } else { -1.0 }) {
                panel.path(&[(a[0], a[1]), (b[0], b[1])], &HATCH)?;
            }
            for curve in contour {
                panel.path(&curve.iter().map(|p| (p[0], p[1])).collect::<Vec<_>>(), &BOUNDARY)?;
            }
        }
        panel.path(&flat(&self.reference), &wide())?;
        for run in &self.checked.runs {
            self.pieces(run).iter().try_for_each(|piece| panel.path(&flat(piece), &stroke(run)))?;
        }
        Ok(())
    }

    fn view<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        self.space.frame(canvas)?;
        for (boundary, axes) in self.boundaries.iter().flat_map(|b| VIEWS.map(|axes| (b, axes))) {
            let slice = boundary.slice(axes, self.space.extent(axes));
            for curve in slice.contour() {
                let curve: Vec<_> = curve.iter().map(|p| slice.in_space(*p)).collect();
                self.space.curve(canvas, &curve, &Stroke { width: 2.0, ..BOUNDARY })?;
            }
        }
        self.space.curve(canvas, &self.reference, &wide())?;
        for run in &self.checked.runs {
            self.pieces(run).iter().try_for_each(|piece| self.space.curve(canvas, piece, &stroke(run)))?;
        }
        Ok(())
    }

    /// A run's path, cut where it jumps, as a projection does from one side of an obstacle to the other.
    fn pieces(&self, run: &PathRun) -> Vec<Vec<[f64; 3]>> {
        let distance = |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
        // Far more than the reference moves, and far enough to be seen.
        let visible = 0.02 * self.space.longest_edge();
        let is_near = |a: &ConditionedSample, b: &ConditionedSample| {
            distance(&a.position, &b.position) < 10.0 * distance(&a.reference, &b.reference) + visible
        };
        run.samples.chunk_by(is_near).map(|piece| piece.iter().map(|s| s.position).collect()).collect()
    }
}

fn wide() -> Stroke {
    Stroke { width: 14.0, ..REFERENCE }
}

/// Thinner than over time: the views are small.
fn stroke(run: &PathRun) -> Stroke {
    let full = path_stroke(run.method);
    Stroke { width: 0.8 * full.width, ..full }
}

impl Figure for ConditionedPath<'_> {
    const NAME: &'static str = "conditioned-path";

    fn caption(&self) -> String {
        format!(
            "{}: reference (broad line) and the paths made of it, in space and in three projections, each with one scale in \
             all directions. Thin lines: the boundaries σ = 0 of the constraints, each cut through the point at which the \
             reference is deepest in what it forbids, and at that time; hatched: forbidden in that cut. A path that jumps is \
             interrupted there.{}",
            self.checked.study.title,
            self.checked.remark()
        )
    }

    fn header(&self) -> Header {
        let mean = |run: &PathRun| length(run.summary.mean_deviation_m, 3);
        let meaning = "mean distance from the reference";
        let mut header = header(self.checked, "Conditioned path", meaning, &self.checked.runs, mean);
        header.legend.insert(0, reference_entry("reference"));
        header.legend.push(entry("boundary", BOUNDARY));
        header
    }

    fn body_height(&self) -> f64 {
        FOUR_VIEWS
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let [view, flat @ ..] = four_views(canvas);
        self.view(&view)?;
        flat.iter().zip(VIEWS).try_for_each(|(canvas, axes)| self.project(canvas, axes))
    }
}
