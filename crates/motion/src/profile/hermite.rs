use super::Cubics;
use super::phase::roots;
use crate::{AxisLimits, AxisState};
use arrayvec::ArrayVec;

/// Ends of a cubic: positions and velocities. Its duration is free.
///
/// ```text
/// a(0) = (6 d/T - 4 v0 - 2 vf)/T,   a(T) = (-6 d/T + 2 v0 + 4 vf)/T,   the acceleration linear between
/// ```
///
/// Source: `[R16]`, Hermite curve, extended to end speeds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Hermite {
    /// Position at the beginning, rad or m.
    pub start: f64,
    /// Velocity there, per s.
    pub start_velocity: f64,
    /// Position at the end, rad or m.
    pub goal: f64,
    /// Velocity there, per s.
    pub goal_velocity: f64,
}

/// Relative slack when a critical duration is put back into its own limit: a few dozen roundings.
const SLACK: f64 = 1e-12;

impl Hermite {
    /// The cubic that takes `duration` seconds.
    #[must_use]
    pub fn over(&self, duration: f64) -> Cubics {
        let start = AxisState { position: self.start, velocity: self.start_velocity, acceleration: 0.0 };
        if !(duration > 0.0) {
            return Cubics::from(start);
        }
        let slope = 6.0 * (self.goal - self.start) / duration;
        let first = (slope - 4.0 * self.start_velocity - 2.0 * self.goal_velocity) / duration;
        let last = (-slope + 2.0 * self.start_velocity + 4.0 * self.goal_velocity) / duration;
        Cubics::from(start).then_with(duration, first, (last - first) / duration)
    }

    /// True if the cubic of that duration keeps the limits.
    fn fits(&self, duration: f64, limits: &AxisLimits) -> bool {
        if !(duration > 0.0) {
            return self.start == self.goal && self.start_velocity == self.goal_velocity;
        }
        let peaks = self.over(duration).bounds(0.0, duration);
        peaks.velocity.magnitude() <= limits.velocity() * (1.0 + SLACK)
            && peaks.acceleration.magnitude() <= limits.acceleration() * (1.0 + SLACK)
    }

    /// The durations at which a limit becomes active: the left end of every interval of allowed durations is among them.
    ///
    /// With `x = 1/T` both end accelerations are quadratics in `x`; with `w = 6 d x` the extreme of the velocity meets `±V`
    /// where `w² + (4 k - 2 c) w + c² - 12 k (v0 + vf) = 0`, `k = v0 ∓ V`, `c = 4 v0 + 2 vf`.
    fn critical_durations(&self, limits: &AxisLimits) -> ArrayVec<f64, 12> {
        let (d, v0, vf) = (self.goal - self.start, self.start_velocity, self.goal_velocity);
        let c = 4.0 * v0 + 2.0 * vf;
        let mut durations = ArrayVec::new();
        for sign in [1.0, -1.0] {
            let (a, k) = (sign * limits.acceleration(), v0 - sign * limits.velocity());
            let rates = roots(6.0 * d, -c, -a).into_iter().chain(roots(-6.0 * d, 2.0 * v0 + 4.0 * vf, -a));
            let slopes = roots(1.0, 4.0 * k - 2.0 * c, c * c - 12.0 * k * (v0 + vf));
            let by_rate = rates.flatten().map(|x| 1.0 / x);
            let by_slope = slopes.into_iter().flatten().map(|w| 6.0 * d / w);
            // Two signs, three quadratics, two roots: twelve.
            durations.extend(by_rate.chain(by_slope).filter(|t| *t > 0.0 && t.is_finite()));
        }
        durations
    }
}

/// The shortest duration in which every axis can go along its cubic within its limits, s.
///
/// `None` if an end speed exceeds its limit (or a number is NaN). Otherwise one exists: long cubics are slow everywhere but at
/// their ends. From rest to rest it is `max(3 |d| / (2 V), sqrt(6 |d| / A))` of the slowest axis.
#[must_use]
pub fn shortest_common(cubics: &[Hermite], limits: &[AxisLimits]) -> Option<f64> {
    let fits = |t: f64| cubics.iter().zip(limits).all(|(cubic, limits)| cubic.fits(t, limits));
    let critical = cubics.iter().zip(limits).flat_map(|(cubic, limits)| cubic.critical_durations(limits));
    critical.chain([0.0]).filter(|&t| fits(t)).min_by(f64::total_cmp)
}
