use slideway_robot::{JointVector, Pose, SerialArm, Twist, rotation_vector};

/// Where the tool is and how it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolState {
    /// Pose.
    pub pose: Pose,
    /// Velocity (m/s) and angular velocity (rad/s).
    pub twist: Twist,
}

impl ToolState {
    /// The tool of an arm.
    #[must_use]
    pub fn of<const N: usize>(arm: &SerialArm<N>, q: &JointVector<N>, qd: &JointVector<N>) -> Self {
        let frames = arm.frames(q);
        Self { pose: frames.tool, twist: arm.jacobian_at(&frames) * qd }
    }
}

/// Where the tool is to be, and how it is to move there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolReference {
    /// Pose.
    pub pose: Pose,
    /// Velocity (m/s) and angular velocity (rad/s).
    pub twist: Twist,
    /// Their time derivatives.
    pub acceleration: Twist,
}

impl ToolReference {
    /// A pose to rest in.
    #[must_use]
    pub fn at_rest(pose: Pose) -> Self {
        Self { pose, twist: Twist::zeros(), acceleration: Twist::zeros() }
    }
}

/// From an actual pose to a desired one: the way of the origin (m), and the rotation vector of `R_d Rᵀ` (rad, at most half a turn;
/// at half a turn its sign is arbitrary).
#[must_use]
pub fn pose_error(desired: &Pose, actual: &Pose) -> Twist {
    let way = desired.translation.vector - actual.translation.vector;
    let turn = rotation_vector(&(desired.rotation * actual.rotation.inverse()));
    Twist::new(way.x, way.y, way.z, turn.x, turn.y, turn.z)
}
