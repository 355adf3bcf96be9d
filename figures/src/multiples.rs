//! Small multiples: panels of equal size in two columns, with time labels only at the lower edge.

use crate::canvas::{Canvas, Drawn};
use crate::panel::{Frame, Panel};
use crate::scale::Axis;
use crate::study::Checked;
use crate::style::{LIMIT, Stroke, stroke};
use plotters::backend::DrawingBackend;
use slideway_lab::Sample;
use std::ops::Range;

/// One panel: a quantity of every run against time.
pub(crate) struct Multiple {
    pub(crate) title: String,
    pub(crate) label: String,
    pub(crate) range: Range<f64>,
    /// Levels drawn as limits.
    pub(crate) levels: Vec<f64>,
    pub(crate) value: Box<dyn Fn(&Sample) -> f64>,
}

/// Height of a panel without time labels, design units.
const PANEL: f64 = 226.0;

/// Height of so many panels, design units.
pub(crate) fn height(panels: usize) -> f64 {
    panels.div_ceil(2) as f64 * PANEL + Frame::LABELLED.bottom - Frame::TICKS
}

/// Draws panels row by row.
pub(crate) fn draw<DB: DrawingBackend>(checked: &Checked, canvas: &Canvas<DB>, panels: &[Multiple]) -> Drawn<DB> {
    place(canvas, panels.len(), |place, i, bottom| draw_panel(checked, place, &panels[i], bottom))
}

/// Lays out so many panels row by row; `panel` draws one, given its place, its number and the height of its lower labels.
pub(crate) fn place<DB: DrawingBackend>(
    canvas: &Canvas<DB>,
    panels: usize,
    panel: impl Fn(&Canvas<DB>, usize, f64) -> Drawn<DB>,
) -> Drawn<DB> {
    let half = canvas.size().0 / 2.0;
    for i in 0..panels {
        // The lowest panel of each column carries the labels of the horizontal axis.
        let bottom = if i + 2 < panels { Frame::TICKS } else { Frame::LABELLED.bottom };
        let (_, from_here) = canvas.split_at_height(PANEL * (i / 2) as f64);
        let (row, _) = from_here.split_at_height(PANEL - Frame::TICKS + bottom);
        let (left, right) = row.split_at_width(half);
        panel(if i.is_multiple_of(2) { &left } else { &right }, i, bottom)?;
    }
    Ok(())
}

fn draw_panel<DB: DrawingBackend>(checked: &Checked, place: &Canvas<DB>, panel: &Multiple, bottom: f64) -> Drawn<DB> {
    let time = Axis::linear("time (s)", 0.0..checked.end(), 4);
    let x = if bottom > Frame::TICKS { time } else { time.unlabelled() };
    let y = Axis::linear(&panel.label, panel.range.clone(), 4);
    let axes = Panel::new(place, &Frame { title: &panel.title, bottom, ..Frame::LABELLED }, x, y)?;
    for &level in &panel.levels {
        axes.level(level, &LIMIT)?;
    }
    for run in &checked.runs {
        let full = stroke(run.method);
        // Small panels want thinner lines.
        axes.curve(&run.against_time(&panel.value), &Stroke { width: 0.75 * full.width, ..full })?;
    }
    Ok(())
}
