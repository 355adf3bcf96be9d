use super::MotionQueue;
use super::segment::{EndOf, Motion, Segment};
use crate::MotionError;
use crate::profile::Ramp;
use crate::tool::{RegulatedMotion, SpeedLaw, ToolCurve, ToolLimits, ToolLine, ToolMotion};
use slideway_robot::{Pose, rotation_vector};

/// Largest distance of a curve's beginning from the tool, m and rad: the one that counts as equal in the queue.
const AT_START: f64 = super::check::EQUAL;

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
        if !goal.to_homogeneous().iter().all(|x| x.is_finite()) {
            return self.tool_pose().and(Err(MotionError::PoseNotFinite));
        }
        let line = ToolLine::new(&self.tool_pose()?, goal);
        self.move_tool_along(&ToolCurve::Line(line), &SpeedLaw::Profile(*limits))
    }

    /// Where the tool is at the queue's end, base frame.
    ///
    /// # Errors
    ///
    /// [`MotionError::NoTool`] unless the queue was given an arm.
    pub fn tool_pose(&self) -> Result<Pose, MotionError> {
        let kinematics = self.tool.as_ref().ok_or(MotionError::NoTool)?;
        Ok(kinematics.arm().forward(&self.end()))
    }

    /// Appends a curve of the tool that begins at the queue's end, from rest to rest, under a speed law.
    ///
    /// The whole curve is followed once by inverse kinematics before anything is queued. Under a profile its pace is that of path
    /// time, like that of joint segments. Under a law that decides sample by sample the pace scales the rate asked for: a
    /// brake on the path takes the least time that the joints' limits allow on the curve, and stays on it.
    ///
    /// # Errors
    ///
    /// As [`MotionQueue::move_tool_to`]; [`MotionError::NotAtStart`]; what the law refuses.
    pub fn move_tool_along(&mut self, curve: &ToolCurve, law: &SpeedLaw) -> Result<(), MotionError> {
        self.check_start(curve)?;
        let kinematics = self.tool.as_ref().ok_or(MotionError::NoTool)?;
        let (limits, start) = (&self.limits, self.end());
        let planned = match law {
            SpeedLaw::Profile(tool) => ToolMotion::plan(kinematics, limits, &start, curve, tool)?
                .map(|motion| (Some(motion.ramp()), Motion::Tool(motion))),
            SpeedLaw::SlidingMode(law) => {
                RegulatedMotion::sliding_mode(kinematics, limits, &start, curve, law)?.map(regulated)
            }
            SpeedLaw::Natural(law) => RegulatedMotion::natural(kinematics, limits, &start, curve, law)?.map(regulated),
        };
        let Some((ramp, motion)) = planned else { return Ok(()) };
        self.append(&[Segment { motion, ramp, end: EndOf::Standstill, go_to: None }])
    }

    fn check_start(&self, curve: &ToolCurve) -> Result<(), MotionError> {
        let (tool, start) = (self.tool_pose()?, curve.at(0.0).pose);
        let distance = (start.translation.vector - tool.translation.vector).norm();
        let angle = rotation_vector(&(start.rotation * tool.rotation.inverse())).norm();
        if distance <= AT_START && angle <= AT_START {
            Ok(())
        } else {
            Err(MotionError::NotAtStart { distance, angle })
        }
    }
}

fn regulated<const N: usize>(motion: RegulatedMotion<N>) -> (Option<Ramp>, Motion<N>) {
    (Some(Ramp::AccelerationLimited), Motion::Regulated(motion))
}
