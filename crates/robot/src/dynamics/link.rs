use crate::{BodyFault, Pose};
use nalgebra::{Matrix3, Vector3};

/// Mass, centre of mass and inertia of a link.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LinkInertia {
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass in the link's frame, m.
    pub com: Vector3<f64>,
    /// Inertia about the centre of mass, axes of the link's frame, kg m².
    pub inertia: Matrix3<f64>,
}

impl LinkInertia {
    /// The same link seen from another frame, `frame` being the pose of the present one in it.
    #[must_use]
    pub fn seen_from(&self, frame: &Pose) -> Self {
        let rotation = frame.rotation.matrix();
        Self {
            mass: self.mass,
            com: rotation * self.com + frame.translation.vector,
            inertia: rotation * self.inertia * rotation.transpose(),
        }
    }

    /// Two bodies moving as one, both given in the same frame (parallel-axis theorem).
    #[must_use]
    pub fn joined(&self, other: &Self) -> Self {
        let mass = self.mass + other.mass;
        if !(mass > 0.0) {
            // Two massless bodies have no centre of mass: any point serves.
            return Self { mass, com: self.com, inertia: self.inertia + other.inertia };
        }
        let com = (self.com * self.mass + other.com * other.mass) / mass;
        let about = |body: &Self| body.inertia + shift(body.mass, &(body.com - com));
        Self { mass, com, inertia: about(self) + about(other) }
    }

    /// True if there is nothing to accelerate: neither mass nor inertia.
    #[must_use]
    pub fn is_massless(&self) -> bool {
        self.mass == 0.0 && self.inertia.iter().all(|&x| x == 0.0)
    }

    /// Checks what every rigid body fulfils, short of the triangle inequality, which published parameters break by rounding.
    ///
    /// # Errors
    ///
    /// The first condition that fails.
    pub fn validate(&self) -> Result<(), BodyFault> {
        if !(self.mass >= 0.0 && self.mass.is_finite()) {
            return Err(BodyFault::Mass(self.mass));
        }
        if !self.com.iter().chain(self.inertia.iter()).all(|x| x.is_finite()) {
            return Err(BodyFault::NotFinite);
        }
        let size = self.inertia.norm();
        if !((self.inertia - self.inertia.transpose()).norm() <= SLACK * size) {
            return Err(BodyFault::NotSymmetric);
        }
        let smallest = self.inertia.symmetric_eigenvalues().min();
        if smallest >= -SLACK * size { Ok(()) } else { Err(BodyFault::NegativeMoment(smallest)) }
    }
}

/// Relative slack on an inertia matrix: descriptions are typed with a handful of digits, a thin rod has a principal moment of 0.
const SLACK: f64 = 1e-6;

/// Inertia of a point mass at an offset: `m (d·d I - d dᵀ)`.
pub(crate) fn shift(mass: f64, offset: &Vector3<f64>) -> Matrix3<f64> {
    (Matrix3::from_diagonal_element(offset.norm_squared()) - offset * offset.transpose()) * mass
}
