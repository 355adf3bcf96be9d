//! Desired and followed tool paths in space and in three projections (the quantities of `[G11]` Fig. 6).

use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::{header, reference_entry};
use crate::render::Figure;
use crate::scale::significant;
use crate::space::{self, Space};
use crate::study::{Checked, Run};
use crate::style::{REFERENCE, Stroke, stroke};
use plotters::backend::DrawingBackend;

pub(crate) struct ToolPath<'a> {
    checked: &'a Checked<'a>,
    /// A box around everything drawn, m.
    space: Space,
}

impl<'a> ToolPath<'a> {
    pub(crate) fn new(checked: &'a Checked<'a>) -> Self {
        let tools = checked.runs.iter().flat_map(|run| run.tool.iter().copied());
        Self { checked, space: Space::new(checked.study.tool_path, tools, 1.0) }
    }

    fn project<DB: DrawingBackend>(&self, canvas: &Canvas<DB>, [i, j]: [usize; 2]) -> Drawn<DB> {
        let panel = self.space.projection(canvas, [i, j])?;
        let flat = |points: &[[f64; 3]]| points.iter().map(|p| (p[i], p[j])).collect::<Vec<_>>();
        panel.path(&flat(self.checked.study.tool_path), &wide())?;
        for run in &self.checked.runs {
            panel.path(&flat(run.tool), &stroke(run.method))?;
        }
        Ok(())
    }

    fn view<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        self.space.frame(canvas)?;
        self.space.curve(canvas, self.checked.study.tool_path, &wide())?;
        self.checked.runs.iter().try_for_each(|run| self.space.curve(canvas, run.tool, &stroke(run.method)))
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
        space::FOUR_VIEWS
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let [view, top, front, side] = space::four_views(canvas);
        self.view(&view)?;
        self.project(&top, [0, 1])?;
        self.project(&front, [0, 2])?;
        self.project(&side, [1, 2])
    }
}
