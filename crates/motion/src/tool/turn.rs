use nalgebra::{Rotation3, Vector3};

/// A turn of the tool about one fixed axis in proportion to `u`: `R(u) = exp(u [φ]) R0`, base frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolTurn {
    start: Rotation3<f64>,
    vector: Vector3<f64>,
}

impl ToolTurn {
    /// From an orientation, by a rotation vector `φ`, rad.
    #[must_use]
    pub fn new(start: Rotation3<f64>, vector: Vector3<f64>) -> Self {
        Self { start, vector }
    }

    /// Orientation at `u`.
    #[must_use]
    pub fn at(&self, u: f64) -> Rotation3<f64> {
        Rotation3::new(self.vector * u) * self.start
    }

    /// Angular velocity at unit `u̇`, rad: constant.
    #[must_use]
    pub fn velocity(&self) -> Vector3<f64> {
        self.vector
    }

    /// Its angle, rad.
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.vector.norm()
    }
}
