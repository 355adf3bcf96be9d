//! Rigid-body dynamics of a serial arm: `τ = M(q) q̈ + c(q, q̇) + g(q)`.
//!
//! Vectors are expressed in the base frame throughout. Sources: Luh, Walker and Paul 1980 (recursive Newton-Euler), Walker
//! and Orin 1982 (composite rigid bodies), Featherstone, *Rigid Body Dynamics Algorithms*, 2008.

mod coupled;
mod drive;
mod energy;
mod error;
mod link;
mod mass_matrix;
mod model_error;
mod newton_euler;

pub use drive::{Drive, DriveEffects, Friction};
pub use error::{BodyFault, DriveFault, DynamicsError};
pub use link::LinkInertia;

use crate::{JointVector, SerialArm};
use nalgebra::{SMatrix, Vector3};

/// Mass matrix, `N×N`.
pub type MassMatrix<const N: usize> = SMatrix<f64, N, N>;

/// Gravitational acceleration with the base's z axis pointing up, m/s².
pub const GRAVITY: Vector3<f64> = Vector3::new(0.0, 0.0, -9.81);

/// An arm with masses: `τ = M(q) q̈ + c(q, q̇) + g(q)`, rotor inertia and friction on request.
#[derive(Clone, Debug, PartialEq)]
pub struct Dynamics<const N: usize> {
    arm: SerialArm<N>,
    links: [LinkInertia; N],
    /// Of the arm's followers; those that are missing are massless.
    follower_links: Vec<LinkInertia>,
    drives: [Drive; N],
    effects: DriveEffects,
    gravity: Vector3<f64>,
}

impl<const N: usize> Dynamics<N> {
    /// An arm and its links, link `i` being the one that joint `i` moves, given in the frame of the joint after its motion.
    ///
    /// Gravity is [`GRAVITY`], the drives have neither inertia nor friction.
    ///
    /// # Errors
    ///
    /// A link that is no rigid body.
    pub fn new(arm: SerialArm<N>, links: [LinkInertia; N]) -> Result<Self, DynamicsError> {
        for (i, link) in links.iter().enumerate() {
            link.validate().map_err(|fault| DynamicsError::Link { link: i, fault })?;
        }
        let drives = [Drive::default(); N];
        let (follower_links, effects) = (Vec::new(), DriveEffects::default());
        Ok(Self { arm, links, follower_links, drives, effects, gravity: GRAVITY })
    }

    /// As [`Dynamics::new`], with each link given in the frame of the DH convention, the one at the end of the link.
    ///
    /// # Errors
    ///
    /// A link that is no rigid body.
    pub fn from_dh_links(arm: SerialArm<N>, links: [LinkInertia; N]) -> Result<Self, DynamicsError> {
        let links = std::array::from_fn(|i| links[i].seen_from(&arm.after_joint(i)));
        Self::new(arm, links)
    }

    /// The same arm with drives; they take part only as far as [`Dynamics::with_effects`] says.
    ///
    /// # Errors
    ///
    /// A parameter that is negative or not finite.
    pub fn with_drives(self, drives: [Drive; N]) -> Result<Self, DynamicsError> {
        for (i, drive) in drives.iter().enumerate() {
            drive.validate().map_err(|fault| DynamicsError::Drive { joint: i, fault })?;
        }
        Ok(Self { drives, ..self })
    }

    /// The same arm with the chosen effects of its drives.
    #[must_use]
    pub fn with_effects(self, effects: DriveEffects) -> Self {
        Self { effects, ..self }
    }

    /// The same arm under another gravitational acceleration, in the base frame, m/s².
    #[must_use]
    pub fn with_gravity(self, gravity: Vector3<f64>) -> Self {
        Self { gravity, ..self }
    }

    /// The arm.
    #[must_use]
    pub fn arm(&self) -> &SerialArm<N> {
        &self.arm
    }

    /// The links, each in the frame of its joint after the motion.
    #[must_use]
    pub fn links(&self) -> &[LinkInertia; N] {
        &self.links
    }

    /// The drives.
    #[must_use]
    pub fn drives(&self) -> &[Drive; N] {
        &self.drives
    }

    /// Gravitational acceleration in the base frame, m/s².
    #[must_use]
    pub fn gravity(&self) -> &Vector3<f64> {
        &self.gravity
    }

    /// The effects of the drives that take part.
    #[must_use]
    pub fn effects(&self) -> DriveEffects {
        self.effects
    }

    /// Reflected rotor inertia of a joint, zero unless it takes part.
    fn rotor(&self, joint: usize) -> f64 {
        if self.effects.rotor_inertia { self.drives[joint].reflected_inertia } else { 0.0 }
    }

    /// Torque lost to friction, zero unless it takes part.
    #[must_use]
    pub fn friction(&self, qd: &JointVector<N>) -> JointVector<N> {
        if !self.effects.friction {
            return JointVector::zeros();
        }
        JointVector::from_fn(|i, _| self.drives[i].friction.torque(qd[i]))
    }

    /// Inverse dynamics: joint torques (forces for prismatic joints) for a motion, friction and rotor inertia included as
    /// far as they take part. N·m (N).
    #[must_use]
    pub fn inverse(&self, q: &JointVector<N>, qd: &JointVector<N>, qdd: &JointVector<N>) -> JointVector<N> {
        // [N] eq 9, [R16] eq 1
        let rotors = JointVector::from_fn(|i, _| self.rotor(i) * qdd[i]);
        self.newton_euler(q, qd, qdd, &self.gravity) + rotors + self.friction(qd)
    }

    /// Torque that holds the arm against gravity, `g(q)`.
    #[must_use]
    pub fn gravity_torque(&self, q: &JointVector<N>) -> JointVector<N> {
        self.newton_euler(q, &JointVector::zeros(), &JointVector::zeros(), &self.gravity)
    }

    /// Coriolis and centrifugal torque, `c(q, q̇)`, without friction.
    #[must_use]
    pub fn coriolis_torque(&self, q: &JointVector<N>, qd: &JointVector<N>) -> JointVector<N> {
        self.newton_euler(q, qd, &JointVector::zeros(), &Vector3::zeros())
    }

    /// Forward dynamics: joint accelerations under given torques, `q̈ = M⁻¹ (τ - c - g - friction)`.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::SingularMass`] where some joint motion moves no mass, or an argument is not finite.
    pub fn forward(
        &self,
        q: &JointVector<N>,
        qd: &JointVector<N>,
        torque: &JointVector<N>,
    ) -> Result<JointVector<N>, DynamicsError> {
        let bias = self.inverse(q, qd, &JointVector::zeros());
        let factor = self.mass_matrix(q).cholesky().ok_or(DynamicsError::SingularMass)?;
        let acceleration = factor.solve(&(torque - bias));
        if acceleration.iter().all(|x| x.is_finite()) { Ok(acceleration) } else { Err(DynamicsError::SingularMass) }
    }
}
