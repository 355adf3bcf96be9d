use crate::problem::Problem;
use nalgebra::Vector6;
use slideway_robot::{EulerAngles, JointVector, Twist, euler, solve_rates};

/// What the kinematic controller asks for at one instant, split at the path rate.
///
/// ```text
/// q̇d = feedback + λ̇ · path_speed
/// feedback   = Inv(J) Kp (p_ref - p)          A in the implicit form
/// path_speed = Inv(J) f'(λ)                   v; B = v λ̇d
/// ```
///
/// `[G11] Fig. 1` with a proportional position controller. `Inv` is linear for a fixed configuration, so the split is
/// exact. Euler rates pass through `E(α, β)`: the analytic Jacobian, which does not exist at `β = π/2`, is never formed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Demand<const N: usize> {
    /// `p_ref - p`, m and rad; coordinates outside the task are zero.
    pub error: Vector6<f64>,
    /// Euler triple of the tool.
    pub euler: EulerAngles,
    /// Joint speed with the reference standing still, rad/s.
    pub feedback: JointVector<N>,
    /// Joint speed per unit of path rate.
    pub path_speed: JointVector<N>,
}

impl<const N: usize> Demand<N> {
    /// The desired joint speed at a path rate.
    #[must_use]
    pub fn at(&self, path_rate: f64) -> JointVector<N> {
        self.feedback + self.path_speed * path_rate
    }
}

impl<const N: usize> Problem<N> {
    /// Evaluates the controller at a configuration and path parameter; `euler` is the triple one sample earlier.
    #[must_use]
    pub fn demand(&self, q: &JointVector<N>, euler: &EulerAngles, lambda: f64) -> Demand<N> {
        let frames = self.arm.frames(q);
        let jacobian = self.arm.jacobian_at(&frames);
        let euler = euler::nearest(&frames.tool.rotation, euler);
        let reference = self.path.at(lambda);
        let position = frames.tool.translation.vector;
        let pose = Vector6::new(position.x, position.y, position.z, euler.x, euler.y, euler.z);
        let error = reference.coordinates - pose;
        let map = |rates: &Vector6<f64>| twist(rates, &euler);
        Demand {
            error: self.task.select(&error),
            euler,
            feedback: solve_rates(self.inverse, self.task, &jacobian, &map(&(error * self.control.gain))),
            path_speed: solve_rates(self.inverse, self.task, &jacobian, &map(&reference.first)),
        }
    }
}

/// Linear velocity and angular velocity from coordinate rates `[ẋ ẏ ż α̇ β̇ γ̇]`.
pub(crate) fn twist(rates: &Vector6<f64>, euler: &EulerAngles) -> Twist {
    let angular = euler::rate_map(euler) * rates.fixed_rows::<3>(3);
    Twist::new(rates[0], rates[1], rates[2], angular.x, angular.y, angular.z)
}
