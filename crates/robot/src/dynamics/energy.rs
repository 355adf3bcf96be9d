use crate::{Dynamics, JointVector};

impl<const N: usize> Dynamics<N> {
    /// Kinetic energy `½ q̇ᵀ M q̇`, J.
    #[must_use]
    pub fn kinetic_energy(&self, q: &JointVector<N>, qd: &JointVector<N>) -> f64 {
        0.5 * qd.dot(&(self.mass_matrix(q) * qd))
    }

    /// Potential energy in the field of gravity, zero with every centre of mass at the base's origin, J.
    #[must_use]
    pub fn potential_energy(&self, q: &JointVector<N>) -> f64 {
        if !self.arm.followers().is_empty() {
            return self.coupled_potential_energy(q);
        }
        let poses = self.arm.link_poses(q);
        let height = |i: usize| self.links[i].seen_from(&poses[i]).com.dot(&self.gravity);
        -(0..N).map(|i| self.links[i].mass * height(i)).sum::<f64>()
    }
}
