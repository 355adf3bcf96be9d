use crate::limits::joint_bounds::JointBounds;
use slideway_robot::Dynamics;

/// Limits of a joint's drive.
#[derive(Clone, Debug)]
pub struct TorqueLimits<const N: usize> {
    /// The robot's dynamics, with the effects that count.
    pub dynamics: Dynamics<N>,
    /// Bounds on the drive torque, Nm (N for joints that slide).
    pub bounds: JointBounds<N>,
}

/// Limits of the tool's point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ToolLimits {
    /// Largest speed, m/s.
    pub speed: Option<f64>,
    /// Largest acceleration, m/s².
    pub acceleration: Option<f64>,
}
