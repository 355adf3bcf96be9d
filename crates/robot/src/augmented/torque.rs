use super::Flow;
use crate::{Dynamics, JointVector};

/// Torque along a path, split by how it depends on `b`: `τ = b² inertial + ḃ impulse + gravity`, N·m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathTorque<const N: usize> {
    /// `M (∂n/∂q̄) n̄ + c(q, n)`: accelerations and centrifugal forces at `b = 1`.
    pub inertial: JointVector<N>,
    /// `M n`: generalised momentum at `b = 1`.
    pub impulse: JointVector<N>,
    /// `g(q)`.
    pub gravity: JointVector<N>,
}

impl<const N: usize> PathTorque<N> {
    /// The torque at given `b` and `ḃ`, `[N] eq 10` with `∂n/∂q̄` multiplying `n̄`; `ḃ = 0` is eq 11.
    #[must_use]
    pub fn at(&self, b: f64, b_rate: f64) -> JointVector<N> {
        // [N] eq 10; [N] eq 11 where `b_rate` is zero.
        self.inertial * (b * b) + self.impulse * b_rate + self.gravity
    }

    /// Largest `b` at which a constant `b` asks no joint for more than `peak` (N·m) here; `None` if gravity alone does, or
    /// something is NaN. Infinite where no torque is needed.
    ///
    /// Without gravity the torque is proportional to `b²`, so the answer is `sqrt(peak / ‖inertial‖∞)`.
    #[must_use]
    pub fn largest_b(&self, peak: f64) -> Option<f64> {
        let mut square = f64::INFINITY;
        for (&inertial, &gravity) in self.inertial.iter().zip(self.gravity.iter()) {
            let room = peak - gravity * inertial.signum();
            if !(gravity.abs() <= peak) || inertial.is_nan() {
                return None;
            }
            if inertial != 0.0 {
                square = square.min(room / inertial.abs());
            }
        }
        Some(square.sqrt())
    }
}

/// The rigid bodies' torque for motion along a path (friction is not part of it, reflected rotor inertia is, if it takes
/// part in `dynamics`).
///
/// Equal to [`Dynamics::inverse`] of [`Flow::motion`] up to rounding. Claim `energy-and-power`: kinetic energy
/// `½ b² nᵀ M n` and the power of the inertial torque `b³ nᵀ inertial`.
#[must_use]
pub fn path_torque<const N: usize>(dynamics: &Dynamics<N>, q: &JointVector<N>, flow: &Flow<N>) -> PathTorque<N> {
    let mass = dynamics.mass_matrix(q);
    PathTorque {
        inertial: mass * flow.slope.joints + dynamics.coriolis_torque(q, &flow.direction.joints),
        impulse: mass * flow.direction.joints,
        gravity: dynamics.gravity_torque(q),
    }
}
