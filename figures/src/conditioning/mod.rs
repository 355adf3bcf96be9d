//! Figures of path conditioning.

mod boundary;
mod conditioned_path;
mod deviation;
mod facts;
mod phi;
mod push;
mod sigma;
mod study;
mod trap;

pub use study::{ConditioningStudy, PhiBand};

use crate::error::FigureError;
use crate::render::{Rendered, render};
use std::path::Path;
use study::Checked;

/// Draws every figure of a path-conditioning study into the directory `dir`, which is made if missing.
///
/// A figure that the traces have nothing for is left out: `φ` belongs to methods with a velocity, pace and walk to runs
/// that a trap stopped.
///
/// # Errors
///
/// A study that cannot be drawn (no traces, an empty one, one that is not finite from its first sample, one with other
/// constraints than the problem, a band for no constraint or without extent), or files that cannot be written. A trace
/// that stops being finite later is drawn up to there, and its captions say so.
pub fn draw_conditioning_study(study: &ConditioningStudy, dir: &Path) -> Result<Vec<Rendered>, FigureError> {
    crate::style::register_fonts()?;
    let checked = Checked::new(study)?;
    crate::render::make_directory(dir)?;
    let mut rendered = vec![
        render(&conditioned_path::ConditionedPath::new(&checked), dir)?,
        render(&sigma::Sigma(&checked), dir)?,
        render(&deviation::Deviation(&checked), dir)?,
        render(&push::Push(&checked), dir)?,
    ];
    if let Some(figure) = phi::Phi::new(&checked) {
        rendered.push(render(&figure, dir)?);
    }
    if let Some(figure) = trap::Trap::new(&checked) {
        rendered.push(render(&figure, dir)?);
    }
    Ok(rendered)
}
