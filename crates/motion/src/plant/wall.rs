use crate::MotionError;
use crate::error::{not_negative, positive, setting};
use nalgebra::{Unit, Vector3};

/// A plane that gives way: a spring and a damper that push and never pull.
///
/// ```text
/// d = n·(p0 - p)          depth of the tool's origin in the wall, m
/// F = max(0, k d + c ḋ) n for d > 0, else 0
/// ```
///
/// It takes energy and gives at most what its spring holds: with the spring's `½ k d²` the loss `F ḋ - k d ḋ` is never negative
/// (`c ḋ²` while it pushes, `-k d ḋ` with `ḋ < 0` while the damper has lifted it off).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    point: Vector3<f64>,
    normal: Unit<Vector3<f64>>,
    stiffness: f64,
    damping: f64,
}

impl Wall {
    /// A wall through `point` (m, base frame) whose `normal` points out of it, with stiffness (N/m) and damping (N·s/m).
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`]: a stiffness that is not positive, a negative damping, a normal of no length.
    pub fn new(point: Vector3<f64>, normal: Vector3<f64>, stiffness: f64, damping: f64) -> Result<Self, MotionError> {
        positive("stiffness", stiffness)?;
        not_negative("damping", damping)?;
        positive("normal", normal.norm())?;
        setting("point", point.norm(), point.norm().is_finite())?;
        Ok(Self { point, normal: Unit::new_normalize(normal), stiffness, damping })
    }

    /// Depth of a point in the wall, m; negative outside.
    #[must_use]
    pub fn depth(&self, point: &Vector3<f64>) -> f64 {
        self.normal.dot(&(self.point - point))
    }

    /// The direction out of the wall.
    #[must_use]
    pub fn normal(&self) -> Vector3<f64> {
        self.normal.into_inner()
    }

    /// Stiffness, N/m.
    #[must_use]
    pub fn stiffness(&self) -> f64 {
        self.stiffness
    }

    /// Force on a point, N.
    #[must_use]
    pub fn force(&self, point: &Vector3<f64>, velocity: &Vector3<f64>) -> Vector3<f64> {
        let depth = self.depth(point);
        let push = self.stiffness * depth - self.damping * self.normal.dot(velocity);
        if depth > 0.0 { self.normal.into_inner() * push.max(0.0) } else { Vector3::zeros() }
    }

    /// Energy in the spring, J.
    #[must_use]
    pub fn energy(&self, point: &Vector3<f64>) -> f64 {
        let depth = self.depth(point).max(0.0);
        0.5 * self.stiffness * depth * depth
    }

    /// Power that the damper takes, W; not negative.
    #[must_use]
    pub fn loss(&self, point: &Vector3<f64>, velocity: &Vector3<f64>) -> f64 {
        let depth = self.depth(point).max(0.0);
        let inwards = -self.normal.dot(velocity);
        (self.normal.dot(&self.force(point, velocity)) - self.stiffness * depth) * inwards
    }
}
