use super::Cubics;
use crate::{AxisLimits, AxisState};

/// Where a trapezoid begins and ends. Speeds at the ends must lie within the limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrapezoidEnds {
    /// Position at the beginning, rad or m.
    pub start: f64,
    /// Velocity there, per s.
    pub start_velocity: f64,
    /// Position at the end, rad or m.
    pub goal: f64,
    /// Velocity there, per s.
    pub goal_velocity: f64,
}

/// The fastest motion under a speed and an acceleration limit: speed up, cruise, slow down; without the cruise if the
/// distance is too short for full speed. With `d = goal - start` and the direction `σ` of the first phase,
///
/// ```text
/// σ  = sign(d - (v0 + vf) |vf - v0| / (2 A))
/// vp = σ sqrt((v0² + vf²) / 2 + σ A d),  cut at V
/// ```
///
/// Velocity continuous, acceleration jumps between `±A` and 0. Source: `[R16]`, extended to end speeds and either direction.
#[must_use]
pub fn trapezoid(ends: &TrapezoidEnds, limits: &AxisLimits) -> Cubics {
    let TrapezoidEnds { start, start_velocity: v0, goal, goal_velocity: vf } = *ends;
    let (v_max, a_max) = (limits.velocity(), limits.acceleration());
    let distance = goal - start;
    // What is covered by going from one speed to the other directly decides whether to speed up or slow down first.
    let direct = (v0 + vf) * (vf - v0).abs() / (2.0 * a_max);
    let sign = if distance >= direct { 1.0 } else { -1.0 };
    let peak = (0.5 * (v0 * v0 + vf * vf) + sign * a_max * distance).max(0.0).sqrt();
    let top = peak.min(v_max);
    let (ramp_up, ramp_down) = ((top - sign * v0) / a_max, (top - sign * vf) / a_max);
    let ramps = (2.0 * top * top - v0 * v0 - vf * vf) / (2.0 * a_max);
    let cruise = if peak > v_max { (sign * distance - ramps) / top } else { 0.0 };
    Cubics::from(AxisState { position: start, velocity: v0, acceleration: 0.0 })
        .then_with(ramp_up, sign * a_max, 0.0)
        .then_with(cruise, 0.0, 0.0)
        .then_with(ramp_down, -sign * a_max, 0.0)
}
