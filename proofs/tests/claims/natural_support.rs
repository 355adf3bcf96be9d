//! Matrices and one-joint arms for the claims about natural motion.

use nalgebra::{Matrix3, SVector, Vector3};
use slideway_robot::augmented::{Flow, NullVector};

pub(crate) use slideway_proofs::natural_world::System;
use slideway_robot::{DhRow, Dynamics, LinkInertia, SerialArm};

/// A point mass of 1 kg on a rod of 1 m, level at `q = 0`, under `gravity` m/s²: mass matrix 1, weight `gravity`.
pub(crate) fn pendulum(gravity: f64) -> Result<Dynamics<1>, Box<dyn std::error::Error>> {
    let arm = SerialArm::from_dh([DhRow { a: 1.0, alpha: 0.0, d: 0.0, offset: 0.0 }])?;
    let link = LinkInertia { mass: 1.0, com: Vector3::x(), inertia: Matrix3::zeros() };
    Ok(Dynamics::new(arm, [link])?.with_gravity(Vector3::new(0.0, -gravity, 0.0)))
}

/// A flow of one joint with null vector `n` and derivative `a`.
pub(crate) fn one_joint(n: f64, a: f64) -> Flow<1> {
    let entry = |x: f64| NullVector { joints: SVector::<f64, 1>::new(x), path: 0.0 };
    Flow { direction: entry(n), slope: entry(a) }
}
