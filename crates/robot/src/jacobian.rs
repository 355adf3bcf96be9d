use crate::{Jacobian, JointKind, JointVector, LinkFrames, SerialArm, Twist};
use nalgebra::Vector3;

impl<const N: usize> SerialArm<N> {
    /// Geometric Jacobian at a configuration: `[v; ω] = J q̇`, base frame, reference point at the tool's origin.
    ///
    /// Column of a revolute joint: `[z × (p - o); z]`; of a prismatic joint: `[z; 0]`. The column of a follower counts in that
    /// of its leader, times its ratio.
    #[must_use]
    pub fn jacobian(&self, q: &JointVector<N>) -> Jacobian<N> {
        self.jacobian_at(&self.frames(q))
    }

    /// The Jacobian from frames already computed by [`SerialArm::frames`].
    #[must_use]
    pub fn jacobian_at(&self, frames: &LinkFrames<N>) -> Jacobian<N> {
        if !self.followers.is_empty() {
            return self.coupled_jacobian(&frames.q);
        }
        let tip = frames.tool.translation.vector;
        // [G11] eq 4, [N] eq 1
        let mut jacobian = Jacobian::<N>::zeros();
        for (i, joint) in self.joints().iter().enumerate() {
            let (z, o) = (frames.axes[i], frames.origins[i]);
            let (linear, angular) = match joint.kind {
                JointKind::Revolute => (z.cross(&(tip - o)), z),
                JointKind::Prismatic => (z, Vector3::zeros()),
            };
            jacobian.fixed_view_mut::<3, 1>(0, i).copy_from(&linear);
            jacobian.fixed_view_mut::<3, 1>(3, i).copy_from(&angular);
        }
        jacobian
    }

    /// The part of the tool's acceleration that is there without joint acceleration: `J̇ q̇`, m/s² and rad/s².
    #[must_use]
    pub fn bias_acceleration(&self, q: &JointVector<N>, qd: &JointVector<N>) -> Twist {
        self.bias_acceleration_at(&self.frames(q), qd)
    }

    /// As [`SerialArm::bias_acceleration`], from frames already computed by [`SerialArm::frames`].
    #[must_use]
    pub fn bias_acceleration_at(&self, frames: &LinkFrames<N>, qd: &JointVector<N>) -> Twist {
        self.jacobian_rate_at(frames, qd) * qd
    }

    /// Rate of the Jacobian while the joints move: `J̇`, the derivative of [`SerialArm::jacobian`] along `q̇`.
    ///
    /// Differentiates each column: `ż = ω × z` with the angular velocity `ω` of the link before the joint, and
    /// `d/dt [z × (p - o)] = ż × (p - o) + z × (ṗ - ȯ)`.
    #[must_use]
    pub fn jacobian_rate(&self, q: &JointVector<N>, qd: &JointVector<N>) -> Jacobian<N> {
        self.jacobian_rate_at(&self.frames(q), qd)
    }

    /// As [`SerialArm::jacobian_rate`], from frames already computed by [`SerialArm::frames`].
    #[must_use]
    pub fn jacobian_rate_at(&self, frames: &LinkFrames<N>, qd: &JointVector<N>) -> Jacobian<N> {
        if !self.followers.is_empty() {
            return self.coupled_jacobian_rate(&frames.q, qd);
        }
        let tip = frames.tool.translation.vector;
        let tip_velocity: Vector3<f64> = (self.jacobian_at(frames) * qd).fixed_rows::<3>(0).into_owned();
        let mut rate = Jacobian::<N>::zeros();
        // Angular velocity of the link before joint i, and velocity of that joint's origin.
        let (mut omega, mut origin_velocity) = (Vector3::zeros(), Vector3::zeros());
        for (i, joint) in self.joints().iter().enumerate() {
            let (z, o) = (frames.axes[i], frames.origins[i]);
            let z_rate = omega.cross(&z);
            let (linear, angular) = match joint.kind {
                JointKind::Revolute => {
                    omega += z * qd[i];
                    (z_rate.cross(&(tip - o)) + z.cross(&(tip_velocity - origin_velocity)), z_rate)
                }
                JointKind::Prismatic => {
                    origin_velocity += z * qd[i];
                    (z_rate, Vector3::zeros())
                }
            };
            rate.fixed_view_mut::<3, 1>(0, i).copy_from(&linear);
            rate.fixed_view_mut::<3, 1>(3, i).copy_from(&angular);
            if let Some(next) = frames.origins.get(i + 1) {
                origin_velocity += omega.cross(&(next - o));
            }
        }
        rate
    }
}
