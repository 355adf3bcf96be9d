use super::{Body, Placed};
use crate::{Jacobian, JointKind, JointVector, LinkFrames, Pose, SerialArm};
use nalgebra::Vector3;

impl<const N: usize> SerialArm<N> {
    pub(crate) fn coupled_tool(&self, q: &JointVector<N>) -> Pose {
        tool(self, &self.placed(q))
    }

    pub(crate) fn coupled_link_poses(&self, q: &JointVector<N>) -> [Pose; N] {
        let mut poses = [Pose::identity(); N];
        for placed in self.placed(q) {
            if let Body::Own(i) = placed.body {
                poses[i] = placed.pose;
            }
        }
        poses
    }

    pub(crate) fn coupled_frames(&self, q: &JointVector<N>) -> LinkFrames<N> {
        let chain = self.placed(q);
        let mut frames =
            LinkFrames { origins: [Vector3::zeros(); N], axes: [Vector3::zeros(); N], tool: tool(self, &chain), q: *q };
        for placed in &chain {
            if let Body::Own(i) = placed.body {
                frames.axes[i] = placed.axis;
                // A slide's origin is where it sits, not where it has moved its link.
                frames.origins[i] = placed.origin() - self.joints[i].slid(&placed.axis, q[i]);
            }
        }
        frames
    }

    /// `J S`: the columns of all joints, summed by coordinate.
    pub(crate) fn coupled_jacobian(&self, q: &JointVector<N>) -> Jacobian<N> {
        let chain = self.placed(q);
        let tip = tool(self, &chain).translation.vector;
        let mut jacobian = Jacobian::<N>::zeros();
        for placed in &chain {
            let (linear, angular) = match placed.kind {
                JointKind::Revolute => (placed.axis.cross(&(tip - placed.origin())), placed.axis),
                JointKind::Prismatic => (placed.axis, Vector3::zeros()),
            };
            add(&mut jacobian, placed, &linear, &angular);
        }
        jacobian
    }

    /// `J̇ S`: as without followers, each joint at its own speed.
    pub(crate) fn coupled_jacobian_rate(&self, q: &JointVector<N>, qd: &JointVector<N>) -> Jacobian<N> {
        let chain = self.placed(q);
        let tip = tool(self, &chain).translation.vector;
        let tip_velocity: Vector3<f64> = (self.coupled_jacobian(q) * qd).fixed_rows::<3>(0).into_owned();
        let mut rate = Jacobian::<N>::zeros();
        // Angular velocity of the link before the joint, and velocity of the origin of that link.
        let (mut omega, mut velocity, mut before) = (Vector3::zeros(), Vector3::zeros(), Vector3::zeros());
        for placed in &chain {
            let speed = placed.ratio * qd[placed.coordinate];
            let (z, o) = (placed.axis, placed.origin());
            let z_rate = omega.cross(&z);
            velocity += omega.cross(&(o - before));
            let (linear, angular) = match placed.kind {
                JointKind::Revolute => {
                    omega += z * speed;
                    (z_rate.cross(&(tip - o)) + z.cross(&(tip_velocity - velocity)), z_rate)
                }
                JointKind::Prismatic => {
                    velocity += z * speed;
                    (z_rate, Vector3::zeros())
                }
            };
            before = o;
            add(&mut rate, placed, &linear, &angular);
        }
        rate
    }
}

fn tool<const N: usize>(arm: &SerialArm<N>, chain: &[Placed]) -> Pose {
    chain.last().map_or_else(Pose::identity, |last| last.pose) * arm.tool
}

fn add<const N: usize>(matrix: &mut Jacobian<N>, placed: &Placed, linear: &Vector3<f64>, angular: &Vector3<f64>) {
    for row in 0..3 {
        matrix[(row, placed.coordinate)] += placed.ratio * linear[row];
        matrix[(row + 3, placed.coordinate)] += placed.ratio * angular[row];
    }
}

impl crate::Joint {
    /// By how much a slide has moved its link from where it sits, in the frame of the axis given.
    fn slid(&self, axis: &Vector3<f64>, q: f64) -> Vector3<f64> {
        match self.kind {
            JointKind::Revolute => Vector3::zeros(),
            JointKind::Prismatic => axis * (q + self.offset),
        }
    }
}
