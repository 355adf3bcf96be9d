use slideway_robot::{Dynamics, InverseMethod, JointVector, Task, Twist, solve_rates};

/// Largest acceleration of the tool along a direction that the torques allow, "control bandwidth" in `[R16]`: the largest `s`
/// for which some `q̈` with `J q̈ + J̇ q̇ = s u` keeps every torque inside its limit, in the unit of `u` (m/s² for a unit force
/// direction).
///
/// The joint accelerations are those of least norm, damped by 1e-6: exact for an arm with as many joints as the task has
/// coordinates, away from singularities; a lower bound for a redundant arm. Torques are affine in `s`, so the answer is in closed
/// form. `None` if the torques cannot even hold `s = 0`, or a number is not finite. A commanded acceleration above the answer
/// will be cut: a light virtual mass on a heavy arm asks for such.
#[must_use]
pub fn acceleration_reach<const N: usize>(
    dynamics: &Dynamics<N>,
    task: Task,
    [q, qd]: [&JointVector<N>; 2],
    direction: &Twist,
    largest: &JointVector<N>,
) -> Option<f64> {
    let arm = dynamics.arm();
    let (jacobian, bias) = (arm.jacobian(q), arm.bias_acceleration(q, qd));
    let method = InverseMethod::DampedLeastSquares { damping: 1e-6 };
    let still = dynamics.inverse(q, qd, &solve_rates(method, task, &jacobian, &-bias));
    let per_unit = dynamics.mass_matrix(q) * solve_rates(method, task, &jacobian, direction);
    let mut reach = f64::INFINITY;
    for ((&still, &slope), &largest) in still.iter().zip(per_unit.iter()).zip(largest.iter()) {
        if !(still.abs() <= largest) || !slope.is_finite() {
            return None;
        }
        if slope != 0.0 {
            reach = reach.min((largest - still * slope.signum()) / slope.abs());
        }
    }
    Some(reach)
}
