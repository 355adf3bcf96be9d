use super::walk::check;
use super::{ToolCurve, ToolFault, ToolKinematics, ToolLimits};
use crate::profile::{Cubics, Ramp, TrapezoidEnds, bounded_jerk, trapezoid};
use crate::{AxisLimits, JointState, MotionError, MotionLimits};
use slideway_robot::JointVector;

/// Windows along a motion, each with its own bounds of joint speeds and accelerations.
const WINDOWS: usize = 16;

/// Samples of the check in each window.
const SAMPLES: usize = 16;

/// Room left below the joints' limits for what happens between the samples of the check.
const HEADROOM: f64 = 1.02;

/// A checked Cartesian motion from rest to rest, its speed a profile laid down before it begins.
#[derive(Clone, Copy, Debug)]
pub struct ToolMotion<const N: usize> {
    curve: ToolCurve,
    /// `u` over time.
    law: Cubics,
    ramp: Ramp,
    start: JointVector<N>,
    end: JointVector<N>,
    /// Largest joint speeds and accelerations in each window of time, by samples, with headroom.
    bounds: [(JointVector<N>, JointVector<N>); WINDOWS],
}

impl<const N: usize> ToolMotion<N> {
    /// Plans a motion along a curve that begins where the joints put the tool, and follows it once with the inverse kinematics: at
    /// 256 places it must have a solution, continuous from the start, away from singularities and stops. `None` if the curve has
    /// no extent.
    ///
    /// Where a joint would exceed its speed or acceleration the whole law is slowed down until it does not, with two per cent
    /// to spare for what lies between the samples. The jerk of the joints is not checked.
    ///
    /// # Errors
    ///
    /// [`MotionError::Tool`] with the place along the curve, and the cause.
    pub fn plan(
        kinematics: &ToolKinematics<N>,
        limits: &MotionLimits<N>,
        start: &JointVector<N>,
        curve: &ToolCurve,
        tool: &ToolLimits,
    ) -> Result<Option<Self>, MotionError> {
        let Some(along) = tool.along(curve) else { return Ok(None) };
        let law = profile(&along?, tool.ramp);
        let bounds = [(JointVector::zeros(), JointVector::zeros()); WINDOWS];
        let mut motion = Self { curve: *curve, law, ramp: tool.ramp, start: *start, end: *start, bounds };
        motion.walk(kinematics, limits)?;
        let stretch = motion.needed_stretch(limits);
        if stretch > 1.0 {
            motion.law = motion.law.stretched(stretch);
            for (speed, acceleration) in &mut motion.bounds {
                *speed /= stretch;
                *acceleration /= stretch * stretch;
            }
        }
        Ok(Some(motion))
    }

    /// Follows the curve, checks it and fills in the bounds and the end.
    fn walk(&mut self, kinematics: &ToolKinematics<N>, limits: &MotionLimits<N>) -> Result<(), MotionError> {
        let step = self.law.duration() / (WINDOWS * SAMPLES) as f64;
        let mut before = JointState::at_rest(self.start);
        for sample in 0..=WINDOWS * SAMPLES {
            let time = step * sample as f64;
            let state = self.follow(kinematics, time, &before.q).map_err(|f| self.fault(time, f))?;
            check(limits, &before, &state, step).map_err(|f| self.fault(time, f))?;
            // An edge between two windows belongs to both.
            for window in [sample / SAMPLES, sample.saturating_sub(1) / SAMPLES] {
                if let Some((speed, acceleration)) = self.bounds.get_mut(window) {
                    *speed = speed.sup(&(state.qd.abs() * HEADROOM));
                    *acceleration = acceleration.sup(&(state.qdd.abs() * (HEADROOM * HEADROOM)));
                }
            }
            before = state;
        }
        self.end = before.q;
        Ok(())
    }

    /// Factor by which the law has to be slower for the joints to keep their limits, at least 1.
    fn needed_stretch(&self, limits: &MotionLimits<N>) -> f64 {
        let mut stretch = 1.0_f64;
        for (speed, acceleration) in &self.bounds {
            for (joint, axis) in limits.axes().iter().enumerate() {
                stretch = stretch.max(speed[joint] / axis.velocity());
                stretch = stretch.max((acceleration[joint] / axis.acceleration()).sqrt());
            }
        }
        stretch
    }

    /// The joint state at time `t`, s, from a joint position close by.
    ///
    /// # Errors
    ///
    /// As [`ToolKinematics::follow`].
    pub fn follow(
        &self,
        kinematics: &ToolKinematics<N>,
        t: f64,
        seed: &JointVector<N>,
    ) -> Result<JointState<N>, ToolFault> {
        let u = self.law.at(t);
        let place = self.curve.at(u.position);
        let (twist, acceleration) = place.motion(u.velocity, u.acceleration);
        kinematics.follow(&place.pose, &twist, &acceleration, seed)
    }

    /// The place of a fault.
    pub(crate) fn fault(&self, t: f64, cause: ToolFault) -> MotionError {
        self.curve.fault(self.law.at(t).position, cause)
    }

    /// Largest joint speed and acceleration of `joint` while time covers `[from, to]`, by samples, with two and four per cent
    /// of room.
    #[must_use]
    pub fn bounds(&self, joint: usize, from: f64, to: f64) -> (f64, f64) {
        let width = self.law.duration() / WINDOWS as f64;
        let windows = self.bounds.iter().enumerate().filter(|(k, _)| {
            let begin = *k as f64 * width;
            from <= begin + width && to >= begin
        });
        windows.fold((0.0, 0.0), |(v, a), (_, (speed, acceleration))| (v.max(speed[joint]), a.max(acceleration[joint])))
    }

    /// The curve.
    #[must_use]
    pub fn curve(&self) -> &ToolCurve {
        &self.curve
    }

    /// The profile of `u`.
    #[must_use]
    pub fn law(&self) -> &Cubics {
        &self.law
    }

    /// Bound on changes of speed that the law keeps.
    #[must_use]
    pub fn ramp(&self) -> Ramp {
        self.ramp
    }

    /// Joint position at the beginning.
    #[must_use]
    pub fn start(&self) -> &JointVector<N> {
        &self.start
    }

    /// Joint position at the end.
    #[must_use]
    pub fn end(&self) -> &JointVector<N> {
        &self.end
    }
}

/// The fastest profile of `u` from rest to rest.
fn profile(limits: &AxisLimits, ramp: Ramp) -> Cubics {
    match ramp {
        Ramp::JerkLimited => bounded_jerk(0.0, 1.0, limits),
        Ramp::AccelerationLimited => {
            let ends = TrapezoidEnds { start: 0.0, start_velocity: 0.0, goal: 1.0, goal_velocity: 0.0 };
            trapezoid(&ends, limits)
        }
    }
}
