use crate::{DhRow, Follower, Joint, JointKind, JointVector, Pose, RobotError};
use nalgebra::Vector3;

/// A chain of `N` joints from base to tool.
///
/// ```text
/// T(q) = Π_i (origin_i · motion_i(q_i)) · tool
/// ```
///
/// A standard DH table is one way to write it down, see [`SerialArm::from_dh`]. Joints that follow others take their place
/// in the product, see [`SerialArm::with_followers`]; the `N` joints are those that move on their own.
#[derive(Clone, Debug, PartialEq)]
pub struct SerialArm<const N: usize> {
    pub(crate) joints: [Joint; N],
    pub(crate) tool: Pose,
    pub(crate) dh: Option<[DhRow; N]>,
    /// In the order from base to tool.
    pub(crate) followers: Vec<Follower>,
}

/// The frames of an arm at one configuration, in the base frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkFrames<const N: usize> {
    /// Origin of each joint, m.
    pub origins: [Vector3<f64>; N],
    /// Axis of each joint, unit length.
    pub axes: [Vector3<f64>; N],
    /// Pose of the tool.
    pub tool: Pose,
    /// The configuration, from which an arm with followers finds the frames of those again.
    pub(crate) q: JointVector<N>,
}

impl<const N: usize> SerialArm<N> {
    /// A chain of joints and the tool's pose in the last link's frame.
    #[must_use]
    pub fn new(joints: [Joint; N], tool: Pose) -> Self {
        Self { joints, tool, dh: None, followers: Vec::new() }
    }

    /// An arm of revolute joints from a standard DH table.
    ///
    /// # Errors
    ///
    /// A number in the table is NaN or infinite.
    pub fn from_dh(rows: [DhRow; N]) -> Result<Self, RobotError> {
        for (joint, row) in rows.iter().enumerate() {
            if let Some((field, value)) = row.not_finite() {
                return Err(RobotError::NotFinite { joint, field, value });
            }
        }
        Ok(Self::from_finite_dh(rows))
    }

    /// As [`SerialArm::from_dh`], for tables known to be finite.
    pub(crate) fn from_finite_dh(rows: [DhRow; N]) -> Self {
        let mut before = Pose::identity();
        let joints = rows.map(|row| {
            let origin = std::mem::replace(&mut before, row.after_joint());
            Joint { origin, axis: Vector3::z_axis(), kind: JointKind::Revolute, offset: row.offset }
        });
        Self { joints, tool: before, dh: Some(rows), followers: Vec::new() }
    }

    /// The joints, from base to tool.
    #[must_use]
    pub fn joints(&self) -> &[Joint; N] {
        &self.joints
    }

    /// The DH table the arm was made from, if it was.
    #[must_use]
    pub fn dh(&self) -> Option<&[DhRow; N]> {
        self.dh.as_ref()
    }

    /// Forward kinematics: the pose of the tool in the base frame.
    #[must_use]
    pub fn forward(&self, q: &JointVector<N>) -> Pose {
        if !self.followers.is_empty() {
            return self.coupled_tool(q);
        }
        // [G11] eq 3
        self.joints
            .iter()
            .zip(q.iter())
            .fold(Pose::identity(), |pose, (joint, &q)| pose * joint.origin * joint.motion(q))
            * self.tool
    }

    /// The frame of each joint after its motion, in which the link behind it stands still, in the base frame.
    #[must_use]
    pub fn link_poses(&self, q: &JointVector<N>) -> [Pose; N] {
        if !self.followers.is_empty() {
            return self.coupled_link_poses(q);
        }
        let mut pose = Pose::identity();
        std::array::from_fn(|i| {
            pose = pose * self.joints[i].origin * self.joints[i].motion(q[i]);
            pose
        })
    }

    /// Origin of the joint or follower after joint `i`, or else the tool, in the frame of joint `i` after its motion.
    pub(crate) fn after_joint(&self, i: usize) -> Pose {
        if let Some(next) = self.followers.iter().find(|follower| follower.after == i + 1) {
            return next.joint.origin;
        }
        self.joints.get(i + 1).map_or(self.tool, |next| next.origin)
    }

    /// The tool's pose in the last link's frame.
    #[must_use]
    pub fn tool(&self) -> &Pose {
        &self.tool
    }

    /// Forward kinematics with the joint frames that the Jacobian needs.
    #[must_use]
    pub fn frames(&self, q: &JointVector<N>) -> LinkFrames<N> {
        if !self.followers.is_empty() {
            return self.coupled_frames(q);
        }
        let mut pose = Pose::identity();
        let mut origins = [Vector3::zeros(); N];
        let mut axes = [Vector3::zeros(); N];
        for (((joint, &q), origin), axis) in self.joints.iter().zip(q.iter()).zip(&mut origins).zip(&mut axes) {
            pose *= joint.origin;
            *origin = pose.translation.vector;
            *axis = pose.rotation * joint.axis.into_inner();
            pose *= joint.motion(q);
        }
        LinkFrames { origins, axes, tool: pose * self.tool, q: *q }
    }
}
