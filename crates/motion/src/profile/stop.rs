use super::Cubics;
use super::Ramp;
use crate::{AxisLimits, AxisState};

/// The fastest way to rest, wherever that is. Limited by acceleration alone it takes `|v| / A` seconds.
///
/// Under [`Ramp::JerkLimited`], with `Δ` the speed to gain after flipping the axis such that it must speed up, from `a`:
///
/// ```text
/// ap = min(A, sqrt(J Δ + a²/2)),   phases: a -> ap at J,  hold (Δ - (2 ap² - a²)/(2 J)) / ap,  ap -> 0 at -J
/// ```
///
/// Guaranteed: if a motion within the limits could go on from `state`, then speed, acceleration and jerk stay within them.
#[must_use]
pub fn stop(state: &AxisState, limits: &AxisLimits, ramp: Ramp) -> Cubics {
    match ramp {
        Ramp::AccelerationLimited => {
            let a = limits.acceleration().copysign(-state.velocity);
            Cubics::from(*state).then_with(state.velocity.abs() / limits.acceleration(), a, 0.0)
        }
        Ramp::JerkLimited => stop_smoothly(state, limits.acceleration(), limits.jerk()),
    }
}

fn stop_smoothly(state: &AxisState, a_max: f64, j: f64) -> Cubics {
    let a = state.acceleration;
    // The speed that would be left if only the acceleration were taken away decides in which direction to push.
    let left = state.velocity + a * a.abs() / (2.0 * j);
    let sign = if left > 0.0 { -1.0 } else { 1.0 };
    let (a, gain) = (sign * a, -sign * state.velocity);
    // `max`: rounding may put the peak a hair below where the acceleration is already.
    let peak = (j * gain + 0.5 * a * a).max(0.0).sqrt().min(a_max).max(a);
    let hold = if peak > 0.0 { (gain - (2.0 * peak * peak - a * a) / (2.0 * j)) / peak } else { 0.0 };
    Cubics::from(*state).then((peak - a) / j, sign * j).then_with(hold.max(0.0), sign * peak, 0.0).then_with(
        peak / j,
        sign * peak,
        -sign * j,
    )
}
