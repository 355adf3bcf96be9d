//! The direction factor fdir with and without regulation (the quantity of `[G11]` Fig. 5, bottom).

use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::{header, per_run};
use crate::panel::{Frame, Panel};
use crate::render::Figure;
use crate::scale::{Axis, significant};
use crate::study::{Checked, Run};
use crate::style::stroke;
use plotters::backend::DrawingBackend;
use slideway_lab::Method;

pub(crate) struct DirectionFactor<'a> {
    checked: &'a Checked<'a>,
    runs: Vec<&'a Run<'a>>,
}

impl<'a> DirectionFactor<'a> {
    /// Nothing where no method preserves the direction.
    pub(crate) fn new(checked: &'a Checked<'a>) -> Option<Self> {
        let preserves = |run: &&Run| run.method.is_regulated() || run.method == Method::DirectionPreserving;
        let runs: Vec<_> = checked.runs.iter().filter(preserves).collect();
        (!runs.is_empty()).then_some(Self { checked, runs })
    }
}

impl Figure for DirectionFactor<'_> {
    const NAME: &'static str = "direction-factor";

    fn caption(&self) -> String {
        format!(
            "{}: direction factor fdir, the share of the desired joint speed that saturation lets pass; 1 means that the \
             limits do not interfere.{}",
            self.checked.study.title,
            self.checked.remark()
        )
    }

    fn header(&self) -> Header {
        let least = |run: &Run| run.moving().iter().map(|s| s.direction_factor).reduce(f64::min);
        let list = per_run(self.runs.iter().copied(), |run| least(run).map(|f| significant(f, 3)));
        let message = if list.is_empty() { String::new() } else { format!("Least while the reference moves: {list}.") };
        header(self.checked, message, None, self.runs.iter().copied())
    }

    fn body_height(&self) -> f64 {
        480.0
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let x = Axis::linear("time (s)", 0.0..self.checked.end(), 7);
        let y = Axis::linear("direction factor fdir", 0.0..1.05, 5);
        let panel = Panel::new(canvas, &Frame::LABELLED, x, y)?;
        for run in &self.runs {
            panel.curve(&run.against_time(|s| s.direction_factor), &stroke(run.method))?;
        }
        Ok(())
    }
}
