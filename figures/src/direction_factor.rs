//! The direction factor fdir with and without regulation (the quantity of `[G11]` Fig. 5, bottom).

use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::header;
use crate::render::Figure;
use crate::scale::{Axis, significant};
use crate::stack::{self, Layer};
use crate::study::{Checked, Run};
use crate::style::{Stroke, label, stroke};
use plotters::backend::DrawingBackend;
use slideway_lab::Method;

pub(crate) struct DirectionFactor<'a> {
    checked: &'a Checked<'a>,
    runs: Vec<&'a Run<'a>>,
}

/// Height of a panel, design units.
const PANEL: f64 = 190.0;

impl<'a> DirectionFactor<'a> {
    /// Nothing where no method preserves the direction.
    pub(crate) fn new(checked: &'a Checked<'a>) -> Option<Self> {
        let preserves = |run: &&Run| run.method.is_regulated() || run.method == Method::DirectionPreserving;
        let runs: Vec<_> = checked.runs.iter().filter(preserves).collect();
        (!runs.is_empty()).then_some(Self { checked, runs })
    }
}

/// Average over the samples in which the reference moves.
fn average(run: &Run) -> Option<String> {
    let moving = run.moving();
    let sum: f64 = moving.iter().map(|s| s.direction_factor).sum();
    (!moving.is_empty()).then(|| significant(sum / moving.len() as f64, 3))
}

impl Figure for DirectionFactor<'_> {
    const NAME: &'static str = "direction-factor";

    fn caption(&self) -> String {
        format!(
            "{}: direction factor fdir, the share of the desired joint speed that saturation lets pass; 1 means that the \
             limits do not interfere. The average is over the samples in which the reference moves.{}",
            self.checked.study.title,
            self.checked.time_remark()
        )
    }

    fn header(&self) -> Header {
        // The panels' titles take the place of the legend.
        let runs = self.runs.iter().copied();
        let header = header(self.checked, "Direction factor", "average while the reference moves", runs, average);
        Header { legend: Vec::new(), ..header }
    }

    fn body_height(&self) -> f64 {
        stack::height(self.runs.len(), PANEL)
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let x = Axis::linear("time (s)", 0.0..self.checked.end(), 7);
        let layer = |run: &&Run| Layer {
            title: average(run).map_or(label(run.method).to_owned(), |mean| format!("{} ({mean})", label(run.method))),
            y: Axis::linear("fdir", 0.0..1.08, 2),
            levels: Vec::new(),
            curves: vec![(
                run.against_time(|s| s.direction_factor),
                Stroke { width: 4.0, dashes: &[], ..stroke(run.method) },
            )],
        };
        stack::draw(canvas, &x, self.runs.iter().map(layer).collect(), PANEL)
    }
}
