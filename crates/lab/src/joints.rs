use slideway_robot::{JointKind, JointVector, SerialArm};

/// Most joints that an experiment supports.
pub const MAX_JOINTS: usize = 7;

/// Units of what a joint does: one that turns counts in rad and N·m, one that slides in m and N.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct JointUnits {
    /// Of its position.
    pub position: &'static str,
    /// Of its speed.
    pub speed: &'static str,
    /// Of its torque or force.
    pub load: &'static str,
}

impl JointUnits {
    /// Of a joint that turns.
    pub const TURNING: Self = Self { position: "rad", speed: "rad/s", load: "N·m" };

    /// Of a joint that slides.
    pub const SLIDING: Self = Self { position: "m", speed: "m/s", load: "N" };

    /// Of the joints of an arm; entries beyond them are those of joints that turn.
    pub(crate) fn of<const N: usize>(arm: &SerialArm<N>) -> [Self; MAX_JOINTS] {
        let mut units = [Self::TURNING; MAX_JOINTS];
        for (unit, joint) in units.iter_mut().zip(arm.joints()) {
            *unit = match joint.kind {
                JointKind::Revolute => Self::TURNING,
                JointKind::Prismatic => Self::SLIDING,
            };
        }
        units
    }
}

/// Joint values in an array of every number of joints.
pub(crate) fn pad<const N: usize>(values: &JointVector<N>) -> [f64; MAX_JOINTS] {
    let mut padded = [0.0; MAX_JOINTS];
    for (slot, value) in padded.iter_mut().zip(values.iter()) {
        *slot = *value;
    }
    padded
}
