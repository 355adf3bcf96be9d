use super::rate::Rate;
use super::segment::{Motion, Segment};
use super::{MotionQueue, Repeat};
use crate::tool::{Advanced, RegulatedMotion};
use crate::{JointState, MotionError};

/// Segments whose speed is decided sample by sample.
impl<const N: usize, const CAPACITY: usize> MotionQueue<N, CAPACITY> {
    /// The present segment, if it is such a one.
    pub(super) fn regulated(&self) -> Option<&RegulatedMotion<N>> {
        match &self.segments.front()?.motion {
            Motion::Regulated(motion) => Some(motion),
            Motion::Joint(_) | Motion::Tool(_) => None,
        }
    }

    pub(super) fn is_regulated(&self) -> bool {
        self.regulated().is_some()
    }

    /// Advances such a segment, and what follows it in the same sample.
    pub(super) fn advance_regulated(&mut self, dt: f64) -> Result<JointState<N>, MotionError> {
        // It begins and ends at rest: the law of a change of pace ends with it.
        self.rate = Rate::constant(self.rate.wanted);
        let kinematics = self.tool.as_ref().ok_or(MotionError::NoTool)?;
        let Some(motion) = self.regulated() else { return Ok(self.present) };
        if self.rate.wanted == 0.0 && motion.is_resting() && self.present.is_at_rest() {
            return Ok(self.present);
        }
        match motion.advanced(kinematics, dt, self.rate.wanted)? {
            Advanced::Moving { state, set_point } => {
                self.check_tool_state(&set_point).map_err(|cause| motion.fault(cause))?;
                if let Some(Segment { motion: Motion::Regulated(motion), .. }) = self.segments.front_mut() {
                    motion.take(state);
                }
                self.present = set_point;
                Ok(set_point)
            }
            Advanced::Ended { left } => {
                self.leave_regulated();
                // A brake on the path goes no further than a way-point at rest.
                if left > 0.0 && self.rate.wanted > 0.0 { self.advance(left) } else { Ok(self.present) }
            }
        }
    }

    fn leave_regulated(&mut self) {
        let Some(mut past) = self.segments.pop_front() else { return };
        self.present = JointState::at_rest(past.motion.end());
        if let (Repeat::Forever, Motion::Regulated(motion)) = (self.repeat, &mut past.motion) {
            motion.begin_anew();
            self.segments.push_back(past);
        }
    }
}
