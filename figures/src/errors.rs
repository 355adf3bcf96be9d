//! The six coordinates of the pose error (the quantities of `[G11]` Fig. 3 and Fig. 7).

use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::header;
use crate::multiples::{self, Multiple};
use crate::render::Figure;
use crate::scale::{significant, span};
use crate::study::{Checked, Run};
use plotters::backend::DrawingBackend;
use std::ops::Range;

const COORDINATES: [&str; 6] = ["x", "y", "z", "α", "β", "γ"];

pub(crate) struct Errors<'a> {
    checked: &'a Checked<'a>,
    panels: Vec<Multiple>,
}

/// A unit with the factor that converts to it.
#[derive(Clone, Copy)]
struct Unit {
    name: &'static str,
    factor: f64,
}

impl<'a> Errors<'a> {
    pub(crate) fn new(checked: &'a Checked<'a>) -> Self {
        let ranges = [range(checked, 0..3), range(checked, 3..6)];
        let units = [unit(&ranges[0], ["mm", "m"]), unit(&ranges[1], ["mrad", "rad"])];
        // Position left, orientation right, so that each column has one scale.
        let order = [0, 3, 1, 4, 2, 5];
        let panels = order.map(|i| panel(i, &ranges[i / 3], units[i / 3])).into();
        Self { checked, panels }
    }
}

/// Range of the errors in some coordinates while the references move, and of what the robots do up to the figure's end.
fn range(checked: &Checked, coordinates: Range<usize>) -> Range<f64> {
    let end = checked.end();
    let samples = checked.runs.iter().flat_map(|run| run.samples).filter(|s| s.t <= end);
    let all = span(samples.flat_map(|s| s.error[coordinates.clone()].to_vec()));
    let room = 0.06 * (all.end - all.start).max(1e-9);
    all.start.min(0.0) - room..all.end.max(0.0) + room
}

fn unit(range: &Range<f64>, [small, large]: [&'static str; 2]) -> Unit {
    let is_small = range.end.max(-range.start) < 1.0;
    if is_small { Unit { name: small, factor: 1e3 } } else { Unit { name: large, factor: 1.0 } }
}

fn panel(coordinate: usize, range: &Range<f64>, unit: Unit) -> Multiple {
    Multiple {
        title: format!("error in {}", COORDINATES[coordinate]),
        label: unit.name.to_owned(),
        range: unit.factor * range.start..unit.factor * range.end,
        levels: Vec::new(),
        value: Box::new(move |s| unit.factor * s.error[coordinate]),
    }
}

/// Root mean square of the position error up to the reference's end, m.
fn rms_position(run: &Run) -> f64 {
    let squares = run.following().iter().map(|s| s.error[..3].iter().map(|e| e * e).sum::<f64>());
    (squares.sum::<f64>() / run.following().len().max(1) as f64).sqrt()
}

impl Figure for Errors<'_> {
    const NAME: &'static str = "errors";

    fn caption(&self) -> String {
        format!(
            "{}: pose error p_ref − p, position left and Euler angles right, one scale for each column. The root mean \
             square of the position error runs up to the reference's end.{}",
            self.checked.study.title,
            self.checked.time_remark()
        )
    }

    fn header(&self) -> Header {
        let rms = |run: &Run| Some(format!("{} mm", significant(1e3 * rms_position(run), 2)));
        header(self.checked, "Pose error", "RMS position error", &self.checked.runs, rms)
    }

    fn body_height(&self) -> f64 {
        multiples::height(self.panels.len())
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        multiples::draw(self.checked, canvas, &self.panels)
    }
}
