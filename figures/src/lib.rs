//! Comparisons in pictures: one function draws every figure of a study of speed laws or of path conditioning, as SVG and as
//! PNG, from the same drawing code and with a bundled font; more draw what sweeps and windows give.
//!
//! Figures are [`WIDTH`](Rendered::width) 1000 px wide, meant for a column of 8.5 cm. The SVG uses `#FFFFFF` for the
//! background, `#1A1A1A` for text, axes and limits and `#D9D9D9` for the grid, so that a page can restyle them.

// Pixels are small whole numbers, samples far fewer than 2^52.
#![allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, clippy::cast_sign_loss)]

mod canvas;
mod chart;
mod chattering;
mod conditioning;
mod convergence;
mod counterexample;
mod courses;
mod direction_factor;
mod error;
mod errors;
mod escape_times;
mod facts;
mod joint_speeds;
mod look_ahead;
mod mean_speed;
mod multiples;
mod panel;
mod path_rate;
mod polyline;
mod render;
mod scale;
mod space;
mod stack;
mod study;
mod style;
mod tool_path;
mod trials;

pub use chart::{Chart, ChartCurve, ChartPanel, ChartRole, ChartScales, draw_chart};
pub use conditioning::{ConditioningStudy, PhiBand, draw_conditioning_study};
pub use convergence::{ConvergencePoint, ConvergenceStudy, draw_convergence};
pub use counterexample::{Counterexample, draw_counterexample};
pub use courses::{
    CourseLaw, CourseStudy, ModelErrorOfLaw, ModelErrorStudy, NamedCourse, draw_courses, draw_model_error,
};
pub use error::FigureError;
pub use escape_times::{EscapeStudy, EscapeVariant, draw_escape_times};
pub use look_ahead::{LookAheadPoint, LookAheadStudy, draw_look_ahead};
pub use mean_speed::{MeanSpeedLine, MeanSpeedStudy, draw_mean_speed};
pub use render::Rendered;
pub use study::{Optimum, SpeedStudy};
pub use trials::{TrialPoint, TrialsPanel, TrialsStudy, draw_trials};

use render::render;
use std::path::Path;
use study::Checked;

/// Draws every figure of a study into the directory `dir`, which is made if missing.
///
/// A figure that the traces have nothing for is left out: the direction factor and the chattering belong to methods that
/// preserve the direction and that are regulated.
///
/// # Errors
///
/// A study that cannot be drawn (no traces, an empty one, one that is not finite from its first sample, lists of unequal
/// length, limits that do not enclose zero), or files that cannot be written. A trace that stops being finite later is
/// drawn up to there, and its captions say so.
pub fn draw_speed_study(study: &SpeedStudy, dir: &Path) -> Result<Vec<Rendered>, FigureError> {
    style::register_fonts()?;
    let checked = Checked::new(study)?;
    render::make_directory(dir)?;
    let mut rendered = vec![
        render(&path_rate::PathRate(&checked), dir)?,
        render(&path_rate::PathRateOverTime(&checked), dir)?,
        render(&joint_speeds::JointSpeeds::new(&checked), dir)?,
        render(&errors::Errors::new(&checked), dir)?,
        render(&tool_path::ToolPath::new(&checked), dir)?,
    ];
    if let Some(figure) = direction_factor::DirectionFactor::new(&checked) {
        rendered.push(render(&figure, dir)?);
    }
    if let Some(figure) = chattering::Chattering::new(&checked) {
        rendered.push(render(&figure, dir)?);
    }
    Ok(rendered)
}
