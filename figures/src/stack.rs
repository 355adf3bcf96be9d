//! Panels one above the other over a common horizontal axis: curves that chatter would hide each other in one panel.

use crate::canvas::{Canvas, Drawn};
use crate::panel::{Frame, Panel};
use crate::polyline::Point;
use crate::scale::Axis;
use crate::style::Stroke;
use plotters::backend::DrawingBackend;

/// One panel of a stack.
pub(crate) struct Layer {
    pub(crate) title: String,
    pub(crate) y: Axis,
    /// Horizontal lines, under the curves.
    pub(crate) levels: Vec<(f64, Stroke)>,
    /// Curves with their horizontal coordinate in order; what comes later lies on top.
    pub(crate) curves: Vec<(Vec<Point>, Stroke)>,
}

/// Height of the panels together with the labels below, design units.
pub(crate) fn height(panels: usize, each: f64) -> f64 {
    each * panels as f64 + Frame::LABELLED.bottom - Frame::TICKS
}

/// Draws the panels, each `each` design units high without the labels of the horizontal axis.
pub(crate) fn draw<DB: DrawingBackend>(canvas: &Canvas<DB>, x: &Axis, layers: Vec<Layer>, each: f64) -> Drawn<DB> {
    let last = layers.len().saturating_sub(1);
    for (i, layer) in layers.into_iter().enumerate() {
        let bottom = if i == last { Frame::LABELLED.bottom } else { Frame::TICKS };
        let (_, from_here) = canvas.split_at_height(each * i as f64);
        let (place, _) = from_here.split_at_height(each - Frame::TICKS + bottom);
        let x = if i == last { x.clone() } else { x.unlabelled() };
        let panel = Panel::new(&place, &Frame { title: &layer.title, bottom, ..Frame::LABELLED }, x, layer.y)?;
        for (level, stroke) in &layer.levels {
            panel.level(*level, stroke)?;
        }
        for (points, stroke) in &layer.curves {
            panel.curve(points, stroke)?;
        }
    }
    Ok(())
}
