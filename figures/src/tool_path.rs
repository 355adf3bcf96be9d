//! Desired and followed tool paths in space and in three projections (the quantities of `[G11]` Fig. 6).

use crate::canvas::{Anchor, Canvas, Drawn, Header};
use crate::facts::{header, reference_entry};
use crate::panel::{Frame, Panel};
use crate::render::Figure;
use crate::scale::{Axis, significant, span};
use crate::study::{Checked, Run};
use crate::style::{GRID, REFERENCE, Stroke, TEXT_SIZE, stroke};
use plotters::backend::DrawingBackend;
use std::ops::Range;

const NAMES: [&str; 3] = ["x", "y", "z"];
const CELL: f64 = 500.0;

pub(crate) struct ToolPath<'a> {
    checked: &'a Checked<'a>,
    /// A box around everything drawn, m.
    space: [Range<f64>; 3],
}

impl<'a> ToolPath<'a> {
    pub(crate) fn new(checked: &'a Checked<'a>) -> Self {
        Self { checked, space: space(checked) }
    }

    fn project<DB: DrawingBackend>(&self, canvas: &Canvas<DB>, [i, j]: [usize; 2]) -> Drawn<DB> {
        // Both axes of a view have the same scale.
        let edge = [i, j].map(|k| self.space[k].end - self.space[k].start).into_iter().fold(0.0, f64::max);
        let axis = |k: usize| Axis::linear(&format!("{} (m)", NAMES[k]), around(&self.space[k], edge), 4);
        // The margins of `Panel` and these add up to the same on both sides: the plot is square.
        let frame = Frame::LABELLED;
        let panel = Panel::new(&square(canvas, &frame), &frame, axis(i), axis(j))?;
        let flat = |points: &[[f64; 3]]| points.iter().map(|p| (p[i], p[j])).collect::<Vec<_>>();
        panel.path(&flat(self.checked.study.tool_path), &wide())?;
        for run in &self.checked.runs {
            panel.path(&flat(run.tool), &stroke(run.method))?;
        }
        Ok(())
    }

    /// An axonometric view from above, the front and the right.
    fn view<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let lines = |points: &[[f64; 3]]| self.spatial(canvas, points);
        for edge in edges() {
            let corners = edge.map(|corner| self.corner(corner));
            canvas.polyline(&lines(&corners), &Stroke { color: GRID, width: 2.0, dashes: &[] })?;
        }
        for (k, corner) in [[0.5, 0.0, 0.0], [1.0, 0.5, 0.0], [0.0, 0.0, 0.5]].into_iter().enumerate() {
            let at = lines(&[self.corner(corner)])[0];
            let away = [(-22.0, 22.0), (22.0, 22.0), (-24.0, 0.0)][k];
            let place = (at.0 / canvas.scale + away.0, at.1 / canvas.scale + away.1);
            canvas.text(NAMES[k], TEXT_SIZE, place, Anchor::Centre)?;
        }
        let draw = |points: &[[f64; 3]], stroke: &Stroke| -> Drawn<DB> {
            let pixels = crate::polyline::simplify(&lines(points), 0.4 * canvas.scale);
            let pattern: Vec<f64> = stroke.dashes.iter().map(|d| d * canvas.scale).collect();
            let dashes = crate::polyline::dash(&pixels, &pattern, 3000.0 * canvas.scale);
            dashes.iter().try_for_each(|dash| canvas.polyline(dash, stroke))
        };
        draw(self.checked.study.tool_path, &wide())?;
        self.checked.runs.iter().try_for_each(|run| draw(&self.inside(run.tool), &stroke(run.method)))
    }

    /// The point of the box at the given shares of its edges.
    fn corner(&self, share: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|k| self.space[k].start + share[k] * (self.space[k].end - self.space[k].start))
    }

    /// The points moved to the box's surface where they leave it.
    fn inside(&self, points: &[[f64; 3]]) -> Vec<[f64; 3]> {
        let clamp = |p: &[f64; 3]| std::array::from_fn(|k| p[k].clamp(self.space[k].start, self.space[k].end));
        points.iter().map(clamp).collect()
    }

    /// Pixels of points in space.
    fn spatial<DB: DrawingBackend>(&self, canvas: &Canvas<DB>, points: &[[f64; 3]]) -> Vec<(f64, f64)> {
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

    /// Largest distance from the desired path in the second half of the run up to the reference's end, m.
    fn off_path(&self, run: &Run) -> Option<f64> {
        let following = run.following().len();
        let path = self.checked.study.tool_path;
        let half = &run.tool[following / 2..following];
        let step = (half.len() / 500).max(1);
        half.iter().step_by(step).map(|p| distance(p, path)).reduce(f64::max).filter(|d| d.is_finite())
    }
}

fn wide() -> Stroke {
    Stroke { width: 12.0, ..REFERENCE }
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

/// Distance from a polyline, m.
fn distance(p: &[f64; 3], path: &[[f64; 3]]) -> f64 {
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let minus = |a: &[f64; 3], b: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|k| a[k] - b[k]) };
    let to_segment = |w: &[[f64; 3]]| {
        let (along, from) = (minus(&w[1], &w[0]), minus(p, &w[0]));
        let length2 = dot(along, along);
        let s = if length2 > 0.0 { (dot(along, from) / length2).clamp(0.0, 1.0) } else { 0.0 };
        let off: [f64; 3] = std::array::from_fn(|k| from[k] - s * along[k]);
        dot(off, off).sqrt()
    };
    path.windows(2).map(to_segment).fold(f64::INFINITY, f64::min)
}

/// A box around the desired path and the tools, these no farther out than the desired path is long.
fn space(checked: &Checked) -> [Range<f64>; 3] {
    let tools = || checked.runs.iter().flat_map(|run| run.tool);
    let path = checked.study.tool_path;
    let spans: [Range<f64>; 3] = std::array::from_fn(|k| {
        let wanted = span(path.iter().map(|p| p[k]));
        let all = span(path.iter().chain(tools()).map(|p| p[k]));
        let longest = (0..3).map(|k| span(path.iter().map(|p| p[k]))).map(|s| s.end - s.start).fold(0.0, f64::max);
        let has_path = wanted.start.is_finite() && longest > 0.0;
        if has_path { all.start.max(wanted.start - longest)..all.end.min(wanted.end + longest) } else { all }
    });
    // A straight path has no extent across: a fifth of the longest edge keeps the box a box.
    let longest = spans.iter().map(|s| s.end - s.start).fold(1e-6, f64::max);
    spans.map(|s| around(&s, (1.1 * (s.end - s.start)).max(0.2 * longest)))
}

impl Figure for ToolPath<'_> {
    const NAME: &'static str = "tool-path";

    fn caption(&self) -> String {
        format!(
            "{}: desired tool path (broad line) and the paths followed, in space and in three projections, each with \
             one scale in all directions. The distance from the path is the largest in the second half of each run, at 500 or more of its samples (all, if fewer).{}",
            self.checked.study.title,
            self.checked.remark()
        )
    }

    fn header(&self) -> Header {
        let off = |run: &Run| self.off_path(run).map(|d| format!("{} mm", significant(1e3 * d, 2)));
        let meaning = "largest distance from the path in the second half";
        let mut header = header(self.checked, "Tool path", meaning, &self.checked.runs, off);
        header.legend.insert(0, reference_entry("desired"));
        header
    }

    fn body_height(&self) -> f64 {
        2.0 * CELL * 0.89
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let (above, below) = canvas.split_at_height(self.body_height() / 2.0);
        let (view, top) = above.split_at_width(CELL);
        let (front, side) = below.split_at_width(CELL);
        self.view(&view)?;
        self.project(&top, [0, 1])?;
        self.project(&front, [0, 2])?;
        self.project(&side, [1, 2])
    }
}
