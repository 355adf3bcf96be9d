//! Arms with joints that follow others.
//!
//! With the positions of all joints as `p = S q + p0`, `S` constant, velocities are `S q̇` and accelerations `S q̈`: the
//! Jacobian is `J S`, its rate `J̇ S`, the torque `Sᵀ τ` and the mass matrix `Sᵀ M S`, of the chain of all joints.

mod follower;
mod kinematics;
mod with_followers;

pub use follower::Follower;

use crate::{JointKind, JointVector, Pose, SerialArm};
use nalgebra::Vector3;

/// A joint of the chain at one configuration, in the base frame.
pub(crate) struct Placed {
    /// The joint of the arm that moves it, and its motion per motion of that.
    pub(crate) coordinate: usize,
    pub(crate) ratio: f64,
    pub(crate) body: Body,
    pub(crate) kind: JointKind,
    pub(crate) axis: Vector3<f64>,
    /// Pose after the motion, the frame of the link behind the joint.
    pub(crate) pose: Pose,
}

/// The link behind a joint of the chain.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Body {
    /// That of one of the arm's own joints.
    Own(usize),
    /// That of a follower.
    Follower(usize),
}

impl Placed {
    pub(crate) fn origin(&self) -> Vector3<f64> {
        self.pose.translation.vector
    }
}

impl<const N: usize> SerialArm<N> {
    /// All joints from base to tool, followers too.
    pub(crate) fn placed(&self, q: &JointVector<N>) -> Vec<Placed> {
        let mut pose = Pose::identity();
        let mut placed = Vec::with_capacity(N + self.followers.len());
        for i in 0..=N {
            for (at, follower) in self.followers.iter().enumerate().filter(|(_, f)| f.after == i) {
                let position = follower.ratio * q[follower.leader];
                pose = pose * follower.joint.origin * follower.joint.motion(position);
                let (coordinate, ratio) = (follower.leader, follower.ratio);
                let axis = pose.rotation * follower.joint.axis.into_inner();
                let (body, kind) = (Body::Follower(at), follower.joint.kind);
                placed.push(Placed { coordinate, ratio, body, kind, axis, pose });
            }
            if let Some(joint) = self.joints.get(i) {
                pose = pose * joint.origin * joint.motion(q[i]);
                let axis = pose.rotation * joint.axis.into_inner();
                placed.push(Placed { coordinate: i, ratio: 1.0, body: Body::Own(i), kind: joint.kind, axis, pose });
            }
        }
        placed
    }
}
