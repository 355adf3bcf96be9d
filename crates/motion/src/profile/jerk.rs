use super::Cubics;
use crate::{AxisLimits, AxisState};

/// The fastest motion from rest to rest under limits of speed, acceleration and jerk, in four to seven phases.
///
/// With the distance `D`, ramps of jerk of length `tj`, constant acceleration for `ta`, cruise for `tc`:
///
/// ```text
/// full speed:                 tj = min(A/J, sqrt(V/J)),  ta = V/(J tj) - tj,  tc = D/V - (2 tj + ta)
/// full acceleration only:     tj = A/J,  ta = (sqrt(tj² + 4 D/A) - 3 tj) / 2,  tc = 0
/// neither:                    tj = (D / (2 J))^(1/3),  ta = tc = 0
/// ```
///
/// Only square and cube roots. Source: `[R16]`, bounded jerk; the formulas are derived here from the areas under the
/// acceleration.
#[must_use]
pub fn bounded_jerk(start: f64, goal: f64, limits: &AxisLimits) -> Cubics {
    let (v, a, j) = (limits.velocity(), limits.acceleration(), limits.jerk());
    let distance = (goal - start).abs();
    let sign = if goal >= start { 1.0 } else { -1.0 };
    let (ramp, hold, cruise) = times(distance, v, a, j);
    let jerk = sign * j;
    Cubics::from(AxisState::at_rest(start))
        .then(ramp, jerk)
        .then_with(hold, jerk * ramp, 0.0)
        .then_with(ramp, jerk * ramp, -jerk)
        .then_with(cruise, 0.0, 0.0)
        .then_with(ramp, 0.0, -jerk)
        .then_with(hold, -jerk * ramp, 0.0)
        .then_with(ramp, -jerk * ramp, jerk)
}

/// `(tj, ta, tc)` as above.
fn times(distance: f64, v: f64, a: f64, j: f64) -> (f64, f64, f64) {
    let (ramp, hold) = if v * j > a * a { (a / j, v / a - a / j) } else { ((v / j).sqrt(), 0.0) };
    let speeding_up = 2.0 * ramp + hold;
    if distance >= v * speeding_up {
        return (ramp, hold, distance / v - speeding_up);
    }
    let ramp = a / j;
    let hold = 0.5 * ((ramp * ramp + 4.0 * distance / a).sqrt() - 3.0 * ramp);
    if hold >= 0.0 { (ramp, hold, 0.0) } else { ((distance / (2.0 * j)).cbrt(), 0.0, 0.0) }
}
