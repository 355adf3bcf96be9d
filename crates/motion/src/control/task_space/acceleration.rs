use super::{ToolGains, ToolReference, ToolState, pose_error};
use slideway_robot::Twist;

/// Acceleration of the tool that makes its error linear: `ẍ = ẍd + Kp e + Kd ė`, the error from actual to desired.
///
/// Under [`OperationalSpace`](super::OperationalSpace) with an exact model each axis of the tool's position obeys
/// `ë + Kd ė + Kp e = 0` by itself; with the same gains for all axes a step is answered along a straight line. Rotations do so to
/// first order in their error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolFeedback {
    /// `Kp`, 1/s².
    pub proportional: ToolGains,
    /// `Kd`, 1/s.
    pub derivative: ToolGains,
}

impl ToolFeedback {
    /// The acceleration for a reference, m/s² and rad/s².
    #[must_use]
    pub fn acceleration(&self, desired: &ToolReference, actual: &ToolState) -> Twist {
        let error = pose_error(&desired.pose, &actual.pose);
        let rate = desired.twist - actual.twist;
        // [R16] eq 2
        desired.acceleration + self.proportional.times(&error) + self.derivative.times(&rate)
    }
}
