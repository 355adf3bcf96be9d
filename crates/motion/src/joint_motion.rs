use crate::profile::{Bounds, Profile, Ramp, stop};
use crate::{AxisLimits, JointState};

/// A profile for each joint, on one clock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointMotion<const N: usize> {
    profiles: [Profile; N],
    duration: f64,
}

impl<const N: usize> JointMotion<N> {
    /// Lasts as long as its longest profile; joints that arrive earlier wait.
    #[must_use]
    pub fn new(profiles: [Profile; N]) -> Self {
        let duration = profiles.iter().map(Profile::duration).fold(0.0, f64::max);
        Self { profiles, duration }
    }

    /// Slows each profile down until it takes as long as the slowest. Velocity, acceleration and jerk only fall.
    #[must_use]
    pub fn stretched_to_slowest(profiles: [Profile; N]) -> Self {
        let duration = profiles.iter().map(Profile::duration).fold(0.0, f64::max);
        let stretched = profiles.map(|p| {
            // Below one only by rounding; a joint that does not move has no duration to stretch.
            let factor = duration / p.duration();
            if factor > 1.0 && factor.is_finite() { p.stretched(factor) } else { p }
        });
        Self { profiles: stretched, duration }
    }

    /// Maximal braking: every joint comes to rest as soon as it can, which leaves the path.
    #[must_use]
    pub fn braking(state: &JointState<N>, limits: &[AxisLimits; N], ramp: Ramp) -> Self {
        Self::new(std::array::from_fn(|i| Profile::Cubics(stop(&state.axis(i), &limits[i], ramp))))
    }

    /// The joints' profiles.
    #[must_use]
    pub fn profiles(&self) -> &[Profile; N] {
        &self.profiles
    }

    /// Duration, s.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// State at time `t`, s.
    #[must_use]
    pub fn at(&self, t: f64) -> JointState<N> {
        let axes: [_; N] = std::array::from_fn(|i| {
            let mut axis = self.profiles[i].at(t);
            if t > self.profiles[i].duration() {
                // Waiting for the others: the acceleration of the last phase is over.
                axis.acceleration = 0.0;
            }
            axis
        });
        JointState::from_axes(&axes)
    }

    /// State at the end, in the limit from before it.
    #[must_use]
    pub fn end(&self) -> JointState<N> {
        let axes: [_; N] = std::array::from_fn(|i| self.profiles[i].end());
        JointState::from_axes(&axes)
    }

    /// Bounds of joint `joint` from `from` to `to`, s.
    #[must_use]
    pub fn bounds(&self, joint: usize, from: f64, to: f64) -> Bounds {
        self.profiles[joint].bounds(from, to)
    }
}
