use super::Cubics;
use crate::{AxisLimits, AxisState};

/// A straight line in time: the velocity jumps at both ends (continuity C⁰ only). Source: `[R16]`, piecewise linear.
#[must_use]
pub fn linear(start: f64, goal: f64, duration: f64) -> Cubics {
    let velocity = if duration > 0.0 { (goal - start) / duration } else { 0.0 };
    Cubics::from(AxisState { position: start, velocity, acceleration: 0.0 }).then(duration, 0.0)
}

/// The shortest duration of a straight line, s: `|d| / v_max`.
#[must_use]
pub fn shortest_linear(start: f64, goal: f64, limits: &AxisLimits) -> f64 {
    (goal - start).abs() / limits.velocity()
}
