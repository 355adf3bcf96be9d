use super::MotionQueue;
use super::segment::{EndOf, Motion, Segment};
use crate::MotionError;
use crate::tool::{ToolLimits, ToolMotion};
use slideway_robot::Pose;

impl<const N: usize, const CAPACITY: usize> MotionQueue<N, CAPACITY> {
    /// Appends a straight line of the tool from the queue's end to a pose in the base frame, from rest to rest.
    ///
    /// The whole line is followed once by inverse kinematics before anything is queued, see [`ToolMotion::plan`].
    ///
    /// # Errors
    ///
    /// [`MotionError::NoTool`] unless the queue was given an arm; [`MotionError::Tool`] naming place and cause; a full or a
    /// cyclic queue.
    pub fn move_tool_to(&mut self, goal: &Pose, limits: &ToolLimits) -> Result<(), MotionError> {
        let kinematics = self.tool.as_ref().ok_or(MotionError::NoTool)?;
        if !goal.to_homogeneous().iter().all(|x| x.is_finite()) {
            return Err(MotionError::PoseNotFinite);
        }
        let Some(motion) = ToolMotion::plan(kinematics, &self.limits, &self.end(), goal, limits)? else {
            return Ok(());
        };
        let ramp = Some(motion.ramp());
        self.append(&[Segment { motion: Motion::Tool(motion), ramp, end: EndOf::Standstill, go_to: None }])
    }
}
