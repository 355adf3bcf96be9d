//! Small multiples: panels of equal size in two columns, with axis labels only at the outer edges.

use crate::canvas::{Canvas, Drawn};
use crate::panel::{Frame, Panel};
use crate::scale::Axis;
use crate::study::{Checked, Run};
use crate::style::{LIMIT, stroke};
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

const PANEL: f64 = 190.0;
const TIME_LABELS: f64 = 84.0;
const TICKS_ONLY: f64 = 14.0;
const LEFT: f64 = 132.0;

fn rows(panels: usize) -> usize {
    panels.div_ceil(2)
}

/// Height of so many panels, design units.
pub(crate) fn height(panels: usize) -> f64 {
    rows(panels) as f64 * (PANEL + TICKS_ONLY) + TIME_LABELS - TICKS_ONLY
}

/// Draws panels row by row.
pub(crate) fn draw<DB: DrawingBackend>(checked: &Checked, canvas: &Canvas<DB>, panels: &[Multiple]) -> Drawn<DB> {
    let mut rest = Canvas { area: canvas.area.clone(), scale: canvas.scale };
    for (row, pair) in panels.chunks(2).enumerate() {
        let is_last = row + 1 == rows(panels.len());
        // Above an empty place the panel carries the time labels itself: there is room below the last row only.
        let bottom = if is_last { TIME_LABELS } else { TICKS_ONLY };
        let (above, below) = rest.split_at_height(PANEL + bottom);
        let (left, right) = above.split_at_width(above.size().0 / 2.0);
        for (place, panel) in [left, right].iter().zip(pair) {
            draw_panel(checked, place, panel, bottom)?;
        }
        rest = below;
    }
    Ok(())
}

fn draw_panel<DB: DrawingBackend>(checked: &Checked, place: &Canvas<DB>, panel: &Multiple, bottom: f64) -> Drawn<DB> {
    let time = if bottom > TICKS_ONLY { "time (s)" } else { "" };
    let x = Axis::linear(time, 0.0..checked.end(), 4);
    let y = Axis::linear(&panel.label, panel.range.clone(), 3);
    let axes = Panel::new(place, &Frame { title: &panel.title, left: LEFT, bottom }, x, y)?;
    for &level in &panel.levels {
        axes.level(level, &LIMIT)?;
    }
    for run in &checked.runs {
        axes.curve(&run.against_time(&panel.value), &thinner(run))?;
    }
    Ok(())
}

/// Small panels want thinner lines.
fn thinner(run: &Run) -> crate::style::Stroke {
    let full = stroke(run.method);
    crate::style::Stroke { width: 0.75 * full.width, ..full }
}
