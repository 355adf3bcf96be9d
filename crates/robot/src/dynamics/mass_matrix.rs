use super::link::shift;
use crate::{Dynamics, JointKind, JointVector, MassMatrix};
use nalgebra::{Matrix3, Vector3};

/// A rigid body by its mass, first moment and inertia about the base's origin: what adds up when bodies are joined.
#[derive(Clone, Copy)]
struct Composite {
    mass: f64,
    first: Vector3<f64>,
    second: Matrix3<f64>,
}

impl<const N: usize> Dynamics<N> {
    /// Mass matrix by composite rigid bodies: column `j` is the momentum of everything behind joint `j` when that joint
    /// alone moves at unit speed, projected on the axes before it. Reflected rotor inertia on the diagonal if it takes part.
    #[must_use]
    pub fn mass_matrix(&self, q: &JointVector<N>) -> MassMatrix<N> {
        if !self.arm.followers().is_empty() {
            return self.coupled_mass_matrix(q);
        }
        let poses = self.arm.link_poses(q);
        // Unit twist of each joint, angular part and velocity of the point at the base's origin.
        let twists: [(Vector3<f64>, Vector3<f64>); N] = std::array::from_fn(|i| {
            let joint = &self.arm.joints()[i];
            let axis = poses[i].rotation * joint.axis.into_inner();
            match joint.kind {
                JointKind::Revolute => (axis, poses[i].translation.vector.cross(&axis)),
                JointKind::Prismatic => (Vector3::zeros(), axis),
            }
        });
        let mut matrix = MassMatrix::<N>::zeros();
        let mut body = Composite { mass: 0.0, first: Vector3::zeros(), second: Matrix3::zeros() };
        for j in (0..N).rev() {
            let link = self.links[j].seen_from(&poses[j]);
            body.mass += link.mass;
            body.first += link.com * link.mass;
            body.second += link.inertia + shift(link.mass, &link.com);
            let (omega, velocity) = twists[j];
            let linear = velocity * body.mass + omega.cross(&body.first);
            let angular = body.second * omega + body.first.cross(&velocity);
            for i in 0..=j {
                let entry = twists[i].0.dot(&angular) + twists[i].1.dot(&linear);
                (matrix[(i, j)], matrix[(j, i)]) = (entry, entry);
            }
            matrix[(j, j)] += self.rotor(j);
        }
        matrix
    }
}
