use super::{SpeedLaw, ToolFault, ToolKinematics, ToolLimits, ToolLine};
use crate::profile::Ramp;
use crate::{JointState, MotionError, MotionLimits, Range};
use slideway_robot::{JointVector, Pose};

/// Windows along a motion, each with its own bounds of joint speeds and accelerations.
const WINDOWS: usize = 16;

/// Samples of the check in each window.
const SAMPLES: usize = 16;

/// Room left below the joints' limits for what happens between the samples of the check.
const HEADROOM: f64 = 1.02;

/// A checked Cartesian motion from rest to rest.
#[derive(Clone, Copy, Debug)]
pub struct ToolMotion<const N: usize> {
    line: ToolLine,
    law: SpeedLaw,
    ramp: Ramp,
    start: JointVector<N>,
    end: JointVector<N>,
    /// Largest joint speeds and accelerations in each window of time, by samples, with headroom.
    bounds: [(JointVector<N>, JointVector<N>); WINDOWS],
}

impl<const N: usize> ToolMotion<N> {
    /// Plans a straight line of the tool from where the joints are to a pose, and follows it once with the inverse kinematics:
    /// at 256 places it must have a solution, continuous from the start, away from singularities and stops. `None` if the tool
    /// is there already.
    ///
    /// Where a joint would exceed its speed or acceleration the whole law is slowed down until it does not, with two per cent
    /// to spare for what lies between the samples. The jerk of the joints is not checked.
    ///
    /// # Errors
    ///
    /// [`MotionError::Tool`] with the place along the line, and the cause.
    pub fn plan(
        kinematics: &ToolKinematics<N>,
        limits: &MotionLimits<N>,
        start: &JointVector<N>,
        goal: &Pose,
        tool: &ToolLimits,
    ) -> Result<Option<Self>, MotionError> {
        let line = ToolLine::new(&kinematics.arm().forward(start), goal);
        let Some(along) = tool.along(&line) else { return Ok(None) };
        let law = SpeedLaw::profile(&along?, tool.ramp);
        let bounds = [(JointVector::zeros(), JointVector::zeros()); WINDOWS];
        let mut motion = Self { line, law, ramp: tool.ramp, start: *start, end: *start, bounds };
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

    /// Follows the line, checks it and fills in the bounds and the end.
    fn walk(&mut self, kinematics: &ToolKinematics<N>, limits: &MotionLimits<N>) -> Result<(), MotionError> {
        let step = self.law.duration() / (WINDOWS * SAMPLES) as f64;
        let mut before = JointState::at_rest(self.start);
        for sample in 0..=WINDOWS * SAMPLES {
            let time = step * sample as f64;
            let state = self.follow(kinematics, time, &before.q).map_err(|f| self.fault(time, f))?;
            self.check(limits, &before, &state, step).map_err(|f| self.fault(time, f))?;
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

    fn check(
        &self,
        limits: &MotionLimits<N>,
        before: &JointState<N>,
        state: &JointState<N>,
        step: f64,
    ) -> Result<(), ToolFault> {
        for (joint, axis) in limits.axes().iter().enumerate() {
            let (was, is) = (before.axis(joint), state.axis(joint));
            if let Err(MotionError::JointStop { joint, position, limit }) =
                limits.check_stops(joint, Range::point(is.position))
            {
                return Err(ToolFault::JointStop { joint, position, limit });
            }
            let jump = is.position - was.position;
            // Speed changes little from sample to sample; another solution is far away.
            let expected = 2.0 * step * was.velocity.abs().max(is.velocity.abs()) + step * axis.velocity();
            if !(jump.abs() <= expected) {
                return Err(ToolFault::BranchChange { joint, jump });
            }
        }
        Ok(())
    }

    /// How much slower the law has to be for the joints to keep their limits.
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
        let direction = self.line.direction();
        kinematics.follow(&self.line.at(u.position), &(direction * u.velocity), &(direction * u.acceleration), seed)
    }

    /// The place of a fault.
    pub(crate) fn fault(&self, t: f64, cause: ToolFault) -> MotionError {
        let share = self.law.at(t).position;
        let place = self.line.at(share).translation.vector;
        MotionError::Tool { share, place: [place.x, place.y, place.z], cause: Box::new(cause) }
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

    /// The line.
    #[must_use]
    pub fn line(&self) -> &ToolLine {
        &self.line
    }

    /// The speed law.
    #[must_use]
    pub fn law(&self) -> &SpeedLaw {
        &self.law
    }

    /// What the law keeps.
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
