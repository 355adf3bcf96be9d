use super::Bounds;
use crate::{AxisLimits, AxisState, Range};
use std::f64::consts::PI;

/// From rest to rest along half a cosine.
///
/// ```text
/// θ(t) = θs + d (1 - cos(π t / T)) / 2,   d = θg - θs
/// ```
///
/// Source: `[R16]`, cosine smoothing. The acceleration jumps at both ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cosine {
    start: f64,
    goal: f64,
    duration: f64,
}

impl Cosine {
    /// A cosine that takes `duration` seconds.
    #[must_use]
    pub fn new(start: f64, goal: f64, duration: f64) -> Self {
        Self { start, goal, duration }
    }

    /// The shortest duration, s: the peaks are `π |d| / (2 T)` and `π² |d| / (2 T²)`.
    #[must_use]
    pub fn shortest(start: f64, goal: f64, limits: &AxisLimits) -> f64 {
        let distance = (goal - start).abs();
        let by_velocity = PI * distance / (2.0 * limits.velocity());
        let by_acceleration = PI * (distance / (2.0 * limits.acceleration())).sqrt();
        by_velocity.max(by_acceleration)
    }

    /// Duration, s.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// State at the end.
    #[must_use]
    pub fn end(&self) -> AxisState {
        self.at(self.duration)
    }

    /// State at time `t`, that of the nearer end outside of the motion.
    #[must_use]
    pub fn at(&self, t: f64) -> AxisState {
        if !(self.duration > 0.0) {
            return AxisState::at_rest(self.goal);
        }
        let rate = PI / self.duration;
        let half = (self.goal - self.start) / 2.0;
        let angle = rate * t.clamp(0.0, self.duration);
        AxisState {
            position: self.start + half * (1.0 - angle.cos()),
            velocity: half * rate * angle.sin(),
            acceleration: half * rate * rate * angle.cos(),
        }
    }

    /// The same path, `factor` times as slow.
    #[must_use]
    pub fn stretched(&self, factor: f64) -> Self {
        Self { duration: self.duration * factor, ..*self }
    }

    /// Bounds from `from` to `to`, s. Position and acceleration are monotone, the velocity peaks half-way and its derivative
    /// is largest there.
    #[must_use]
    pub fn bounds(&self, from: f64, to: f64) -> Bounds {
        let jerk = |t: f64| if self.duration > 0.0 { -self.at(t).velocity * (PI / self.duration).powi(2) } else { 0.0 };
        let mut bounds = Bounds::of(&self.at(from), jerk(from)).with(&self.at(to), jerk(to));
        let middle = self.duration / 2.0;
        if from < middle && middle < to {
            bounds = bounds.with(&self.at(middle), jerk(middle));
        }
        // A cosine is at rest before and after: its jumps of acceleration are seen from both sides.
        if from < 0.0 || to > self.duration {
            bounds.acceleration = bounds.acceleration.hull(Range::point(0.0));
        }
        bounds
    }
}
