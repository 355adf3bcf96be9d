use crate::{Dynamics, JointKind, JointVector};
use nalgebra::Vector3;

/// Motion of a link: angular velocity and acceleration, and linear acceleration of its frame's origin.
#[derive(Clone, Copy)]
pub(super) struct LinkMotion {
    pub(super) omega: Vector3<f64>,
    pub(super) alpha: Vector3<f64>,
    pub(super) acceleration: Vector3<f64>,
}

impl LinkMotion {
    /// Acceleration of a point fixed to the link at `offset` from the origin: `a + α × r + ω × (ω × r)`.
    pub(super) fn at(&self, offset: &Vector3<f64>) -> Vector3<f64> {
        self.acceleration + self.alpha.cross(offset) + self.omega.cross(&self.omega.cross(offset))
    }
}

impl<const N: usize> Dynamics<N> {
    /// Recursive Newton-Euler: torques of the rigid bodies alone for a motion under a gravitational acceleration.
    ///
    /// Gravity enters as an upward acceleration of the base. Outward, the motion of each link; inward, the force and the
    /// moment through each joint:
    ///
    /// ```text
    /// f_i = f_{i+1} + m a_c
    /// n_i = n_{i+1} + (p_{i+1} - p_i) × f_{i+1} + (c - p_i) × m a_c + I α + ω × I ω
    /// τ_i = z·n_i (revolute),  z·f_i (prismatic)
    /// ```
    pub(super) fn newton_euler(
        &self,
        q: &JointVector<N>,
        qd: &JointVector<N>,
        qdd: &JointVector<N>,
        gravity: &Vector3<f64>,
    ) -> JointVector<N> {
        if !self.arm.followers().is_empty() {
            return self.coupled_newton_euler(q, qd, qdd, gravity);
        }
        let poses = self.arm.link_poses(q);
        let mut motion = LinkMotion { omega: Vector3::zeros(), alpha: Vector3::zeros(), acceleration: -gravity };
        let mut before = Vector3::zeros();
        let mut force = [Vector3::zeros(); N];
        let mut moment = [Vector3::zeros(); N];
        for (i, (joint, pose)) in self.arm.joints().iter().zip(&poses).enumerate() {
            let axis = pose.rotation * joint.axis.into_inner();
            let origin = pose.translation.vector;
            motion = outward(&motion, &(origin - before), &axis, joint.kind, [qd[i], qdd[i]]);
            before = origin;
            let link = self.links[i];
            let inertia = pose.rotation.matrix() * link.inertia * pose.rotation.matrix().transpose();
            let arm = pose.rotation * link.com;
            force[i] = motion.at(&arm) * link.mass;
            let spin = inertia * motion.omega;
            moment[i] = arm.cross(&force[i]) + inertia * motion.alpha + motion.omega.cross(&spin);
        }
        let mut torque = JointVector::zeros();
        let (mut f, mut n, mut after) = (Vector3::zeros(), Vector3::zeros(), Vector3::zeros());
        for (i, (joint, pose)) in self.arm.joints().iter().zip(&poses).enumerate().rev() {
            let origin = pose.translation.vector;
            n += moment[i] + (after - origin).cross(&f);
            f += force[i];
            after = origin;
            let axis = pose.rotation * joint.axis.into_inner();
            torque[i] = match joint.kind {
                JointKind::Revolute => axis.dot(&n),
                JointKind::Prismatic => axis.dot(&f),
            };
        }
        torque
    }
}

/// The motion of the link behind a joint, from that of the link before it; `offset` leads from origin to origin.
pub(super) fn outward(
    before: &LinkMotion,
    offset: &Vector3<f64>,
    axis: &Vector3<f64>,
    kind: JointKind,
    [speed, acceleration]: [f64; 2],
) -> LinkMotion {
    let carried = before.at(offset);
    match kind {
        JointKind::Revolute => LinkMotion {
            omega: before.omega + axis * speed,
            alpha: before.alpha + axis * acceleration + before.omega.cross(axis) * speed,
            acceleration: carried,
        },
        JointKind::Prismatic => LinkMotion {
            omega: before.omega,
            alpha: before.alpha,
            acceleration: carried + axis * acceleration + before.omega.cross(axis) * (2.0 * speed),
        },
    }
}
