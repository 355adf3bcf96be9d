use super::rate::{Pace, Rate};
use super::segment::EndOf;
use super::{MotionQueue, Repeat};
use crate::error::Continuity;
use crate::profile::Ramp;
use crate::tool::ToolFault;
use crate::{AxisState, JointMotion, JointState, LimitKind, MotionError, Range};

/// Positions, velocities and accelerations closer than this count as equal: a thousandth of an encoder's step, and far above
/// rounding.
pub(super) const EQUAL: f64 = 1e-9;

/// Slack on limits of a reference that somebody else computed: rounding.
const ROUNDING: f64 = 1e-9;

impl<const N: usize, const CAPACITY: usize> MotionQueue<N, CAPACITY> {
    /// True if all limits hold under a law of the pace, from now to its end.
    pub(super) fn keeps_limits(&self, rate: &Rate) -> bool {
        rate.spans().all(|pace| self.keeps_limits_over(&pace))
    }

    fn keeps_limits_over(&self, pace: &Pace) -> bool {
        let (from, to) = (self.clock + pace.path_time.lower, self.clock + pace.path_time.upper);
        let mut begin = 0.0;
        // Twice round is further than any span of a law that is worth checking reaches.
        let rounds = if self.repeat == Repeat::Forever { 2 } else { 1 };
        for segment in (0..rounds).flat_map(|_| &self.segments) {
            if !segment.motion.runs_on_path_time() {
                // It begins at rest and takes no notice of a law of the pace.
                return true;
            }
            let end = begin + segment.motion.duration();
            if from <= end && !segment.keeps(self.limits.axes(), (from - begin).max(0.0), to - begin, pace) {
                return false;
            }
            if to <= end {
                return true;
            }
            begin = end;
        }
        // Beyond the end the joints rest; a cycle so short is refused.
        self.repeat == Repeat::Once
    }

    /// Checks that a motion keeps away from the stops.
    pub(super) fn check_motion_stops(&self, motion: &JointMotion<N>) -> Result<(), MotionError> {
        let mut profiles = motion.profiles().iter().enumerate();
        profiles.try_for_each(|(joint, profile)| self.limits.check_stops(joint, profile.peaks().position))
    }

    /// Checks speeds, accelerations and jerks of a reference that was computed elsewhere.
    pub(super) fn check_motion_limits(&self, motion: &JointMotion<N>, ramp: Option<Ramp>) -> Result<(), MotionError> {
        for (joint, (profile, limits)) in motion.profiles().iter().zip(self.limits.axes()).enumerate() {
            let peaks = profile.peaks();
            let mut checks = [
                Some((LimitKind::Velocity, peaks.velocity, limits.velocity())),
                ramp.map(|_| (LimitKind::Acceleration, peaks.acceleration, limits.acceleration())),
                (ramp == Some(Ramp::JerkLimited)).then_some((LimitKind::Jerk, peaks.jerk, limits.jerk())),
            ]
            .into_iter()
            .flatten();
            // Written such that NaN is above every limit.
            let above = checks.find(|(_, range, limit)| !(range.magnitude() <= limit * (1.0 + ROUNDING)));
            if let Some((quantity, range, limit)) = above {
                return Err(MotionError::LimitExceeded { joint, quantity, value: range.magnitude(), limit });
            }
        }
        Ok(())
    }

    /// Checks a state on a Cartesian segment before it is given out.
    pub(super) fn check_tool_state(&self, state: &JointState<N>) -> Result<(), ToolFault> {
        for (joint, axis) in self.limits.axes().iter().enumerate() {
            let AxisState { position, velocity, .. } = state.axis(joint);
            if let Err(MotionError::JointStop { joint, position, limit }) =
                self.limits.check_stops(joint, Range::point(position))
            {
                return Err(ToolFault::JointStop { joint, position, limit });
            }
            let speed = velocity.abs();
            if !(speed <= axis.velocity() * (1.0 + ROUNDING)) {
                return Err(ToolFault::TooFast { joint, speed, limit: axis.velocity() });
            }
        }
        Ok(())
    }
}

/// Checks that a motion begins where another state ends, as far as its ramp asks for.
pub(super) fn check_joint<const N: usize>(
    before: &JointState<N>,
    after: &JointState<N>,
    ramp: Option<Ramp>,
) -> Result<(), MotionError> {
    for joint in 0..N {
        let (a, b) = (before.axis(joint), after.axis(joint));
        let jumps = [
            Some((Continuity::Position, b.position - a.position)),
            ramp.map(|_| (Continuity::Velocity, b.velocity - a.velocity)),
            (ramp == Some(Ramp::JerkLimited)).then_some((Continuity::Acceleration, b.acceleration - a.acceleration)),
        ];
        if let Some((quantity, jump)) = jumps.into_iter().flatten().find(|(_, jump)| !(jump.abs() <= EQUAL)) {
            return Err(MotionError::Discontinuous { joint, quantity, jump });
        }
    }
    Ok(())
}

/// Kind of a motion's end.
pub(super) fn end_of<const N: usize>(motion: &JointMotion<N>, ramp: Option<Ramp>) -> EndOf {
    let still = check_joint(&motion.end(), &JointState::at_rest(motion.end().q), ramp).is_ok();
    if still { EndOf::Standstill } else { EndOf::PassThrough }
}
