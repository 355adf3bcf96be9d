use nalgebra::{Rotation3, Translation3, Vector3};
use slideway_robot::{Pose, Twist, rotation_vector};

/// A straight line of the tool's origin with a turn about one fixed axis, both in proportion to a parameter `u` in [0, 1].
///
/// ```text
/// p(u) = p0 + u (p1 - p0),   R(u) = exp(u [φ]) R0,   φ = log(R1 R0ᵀ)
/// ```
///
/// in the base frame. The shorter turn is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolLine {
    start: Pose,
    shift: Vector3<f64>,
    turn: Vector3<f64>,
}

impl ToolLine {
    /// The line between two poses in the base frame.
    #[must_use]
    pub fn new(start: &Pose, goal: &Pose) -> Self {
        let shift = goal.translation.vector - start.translation.vector;
        Self { start: *start, shift, turn: rotation_vector(&(goal.rotation * start.rotation.inverse())) }
    }

    /// Pose at `u`.
    #[must_use]
    pub fn at(&self, u: f64) -> Pose {
        let position = self.start.translation.vector + self.shift * u;
        Pose::from_parts(Translation3::from(position), Rotation3::new(self.turn * u) * self.start.rotation)
    }

    /// Twist per unit of `u̇`: constant, m and rad, linear part first.
    #[must_use]
    pub fn direction(&self) -> Twist {
        Twist::new(self.shift.x, self.shift.y, self.shift.z, self.turn.x, self.turn.y, self.turn.z)
    }

    /// Length of the line, m.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.shift.norm()
    }

    /// Angle of the turn, rad.
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.turn.norm()
    }
}
