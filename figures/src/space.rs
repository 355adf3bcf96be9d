//! Curves in space: an axonometric view and three projections, each with one scale in all directions.

use crate::canvas::{Anchor, Canvas, Drawn};
use crate::panel::{Frame, Panel};
use crate::polyline::{dash, simplify};
use crate::scale::{Axis, span};
use crate::style::{GRID, Stroke, TEXT_SIZE};
use plotters::backend::DrawingBackend;
use std::ops::Range;

const NAMES: [&str; 3] = ["x", "y", "z"];
const CELL: f64 = 500.0;

/// Wider than usual: coordinates have signs and decimals.
const FRAME: Frame<'static> = Frame { left: 146.0, ..Frame::LABELLED };

/// Height of the four views together, design units.
pub(crate) const FOUR_VIEWS: f64 = 2.0 * CELL * 0.89;

/// A box around everything drawn, m.
#[derive(Clone, Debug)]
pub(crate) struct Space([Range<f64>; 3]);

/// The view in space and, right and below, those along the third, the second and the first axis.
pub(crate) fn four_views<DB: DrawingBackend>(canvas: &Canvas<DB>) -> [Canvas<DB>; 4] {
    let (above, below) = canvas.split_at_height(FOUR_VIEWS / 2.0);
    let ((view, top), (front, side)) = (above.split_at_width(CELL), below.split_at_width(CELL));
    [view, top, front, side]
}

impl Space {
    /// Around a desired path and what is made of it, this no farther out than `reach` times the path's longest edge.
    pub(crate) fn new(path: &[[f64; 3]], made: impl Iterator<Item = [f64; 3]>, reach: f64) -> Self {
        let wanted: [Range<f64>; 3] = std::array::from_fn(|k| span(path.iter().map(|p| p[k])));
        let all = path.iter().copied().chain(made).filter(|p| p.iter().all(|v| v.is_finite()));
        let empty: [Range<f64>; 3] = std::array::from_fn(|_| f64::INFINITY..f64::NEG_INFINITY);
        let all = all.fold(empty, |r, p| std::array::from_fn(|k| r[k].start.min(p[k])..r[k].end.max(p[k])));
        let longest = wanted.iter().map(|s| s.end - s.start).fold(0.0, f64::max);
        let spans: [Range<f64>; 3] = std::array::from_fn(|k| {
            let (wanted, all, out) = (&wanted[k], &all[k], reach * longest);
            let has_path = wanted.start.is_finite() && longest > 0.0;
            if has_path { all.start.max(wanted.start - out)..all.end.min(wanted.end + out) } else { all.clone() }
        });
        // A straight path has no extent across: a fifth of the longest edge keeps the box a box.
        let longest = spans.iter().map(|s| s.end - s.start).fold(1e-6, f64::max);
        Self(spans.map(|s| around(&s, (1.1 * (s.end - s.start)).max(0.2 * longest))))
    }

    /// Ranges that a projection shows of two coordinates: both as long as the longer one.
    pub(crate) fn ranges(&self, axes: [usize; 2]) -> [Range<f64>; 2] {
        let edge = axes.map(|k| self.0[k].end - self.0[k].start).into_iter().fold(0.0, f64::max);
        axes.map(|k| around(&self.0[k], edge))
    }

    /// The extent of the box along two coordinates.
    pub(crate) fn extent(&self, axes: [usize; 2]) -> [Range<f64>; 2] {
        axes.map(|k| self.0[k].clone())
    }

    /// Length of the longest edge, m.
    pub(crate) fn longest_edge(&self) -> f64 {
        self.0.iter().map(|s| s.end - s.start).fold(0.0, f64::max)
    }

    /// Square axes for two coordinates.
    pub(crate) fn projection<DB: DrawingBackend>(&self, canvas: &Canvas<DB>, axes: [usize; 2]) -> Drawn<DB, Panel<DB>> {
        let [across, up] = self.ranges(axes);
        let axis = |k: usize, range, ticks| Axis::linear(&format!("{} (m)", NAMES[k]), range, ticks);
        // The margins of `Panel` and these add up to the same on both sides: the plot is square.
        let frame = FRAME;
        Panel::new(&square(canvas, &frame), &frame, axis(axes[0], across, 3), axis(axes[1], up, 4))
    }

    /// The box behind the curves of an axonometric view from above, the front and the right.
    pub(crate) fn frame<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        for edge in edges() {
            let corners = edge.map(|corner| self.corner(corner));
            canvas.polyline(&self.pixels(canvas, &corners), &Stroke { color: GRID, width: 2.0, dashes: &[] })?;
        }
        for (k, corner) in [[0.5, 0.0, 0.0], [1.0, 0.5, 0.0], [0.0, 0.0, 0.5]].into_iter().enumerate() {
            let at = self.pixels(canvas, &[self.corner(corner)])[0];
            let away = [(-22.0, 22.0), (22.0, 22.0), (-24.0, 0.0)][k];
            let place = (at.0 / canvas.scale + away.0, at.1 / canvas.scale + away.1);
            canvas.text(NAMES[k], TEXT_SIZE, place, Anchor::Centre)?;
        }
        Ok(())
    }

    /// A curve in the axonometric view, moved to the box's surface where it leaves the box.
    pub(crate) fn curve<DB: DrawingBackend>(
        &self,
        canvas: &Canvas<DB>,
        points: &[[f64; 3]],
        stroke: &Stroke,
    ) -> Drawn<DB> {
        let pixels = simplify(&self.pixels(canvas, &self.inside(points)), 0.4 * canvas.scale);
        let pattern: Vec<f64> = stroke.dashes.iter().map(|d| d * canvas.scale).collect();
        let dashes = dash(&pixels, &pattern, 3000.0 * canvas.scale);
        dashes.iter().try_for_each(|dash| canvas.polyline(dash, stroke))
    }

    /// The point of the box at the given shares of its edges.
    fn corner(&self, share: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|k| self.0[k].start + share[k] * (self.0[k].end - self.0[k].start))
    }

    fn inside(&self, points: &[[f64; 3]]) -> Vec<[f64; 3]> {
        let clamp = |p: &[f64; 3]| std::array::from_fn(|k| p[k].clamp(self.0[k].start, self.0[k].end));
        points.iter().map(clamp).collect()
    }

    /// Pixels of points in space.
    fn pixels<DB: DrawingBackend>(&self, canvas: &Canvas<DB>, points: &[[f64; 3]]) -> Vec<(f64, f64)> {
        // Seen from azimuth −60° and elevation 25°, as mathematical software does by default.
        let ((sa, ca), (se, ce)) = ((-60f64).to_radians().sin_cos(), 25f64.to_radians().sin_cos());
        let flat = |p: &[f64; 3]| (-sa * p[0] + ca * p[1], -se * (ca * p[0] + sa * p[1]) + ce * p[2]);
        let corners: Vec<_> = edges().iter().flatten().map(|&c| flat(&self.corner(c))).collect();
        let (across, up) = (span(corners.iter().map(|c| c.0)), span(corners.iter().map(|c| c.1)));
        let (width, height) = canvas.size();
        // Room for the names of the axes.
        let scale = ((width - 90.0) / (across.end - across.start)).min((height - 60.0) / (up.end - up.start));
        let (x0, y0) = (0.5 * (across.start + across.end), 0.5 * (up.start + up.end));
        let place = |(x, y): (f64, f64)| (0.5 * width + scale * (x - x0), 0.5 * height - scale * (y - y0));
        points.iter().map(|p| place(flat(p))).map(|(x, y)| (canvas.scale * x, canvas.scale * y)).collect()
    }
}

/// The edges of the box that are behind the curves, as shares.
fn edges() -> [[[f64; 3]; 2]; 9] {
    let (o, i) = (0.0, 1.0);
    [
        [[o, o, o], [i, o, o]],
        [[i, o, o], [i, i, o]],
        [[i, i, o], [o, i, o]],
        [[o, i, o], [o, o, o]],
        [[o, o, o], [o, o, i]],
        [[o, i, o], [o, i, i]],
        [[i, i, o], [i, i, i]],
        [[o, o, i], [o, i, i]],
        [[o, i, i], [i, i, i]],
    ]
}

/// The part of a canvas in which a framed plot is square.
fn square<DB: DrawingBackend>(canvas: &Canvas<DB>, frame: &Frame) -> Canvas<DB> {
    let (width, height) = canvas.size();
    let side = (width - Frame::EDGE - frame.left - Frame::RIGHT).min(height - frame.bottom - Frame::ABOVE);
    let (kept, _) = canvas.split_at_width(side + Frame::EDGE + frame.left + Frame::RIGHT);
    let (kept, _) = kept.split_at_height(side + frame.bottom + Frame::ABOVE);
    kept
}

/// A range of the given length with the same middle.
fn around(range: &Range<f64>, length: f64) -> Range<f64> {
    let middle = 0.5 * (range.start + range.end);
    middle - 0.5 * length..middle + 0.5 * length
}
