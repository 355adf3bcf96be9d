use nalgebra::Vector3;
use proptest::prelude::{prop_assert, proptest};
use slideway_proofs::energy_and_power::CLAIM;
use slideway_robot::augmented::{PathTangent, SingularityConsistent, SpeedFactor, path_torque};
use slideway_robot::models::puma560_dynamics;
use slideway_robot::{JointVector, Task, Twist};

use crate::natural_support::{one_joint, pendulum};
use crate::support::{Outcome, config, counterexample, joints, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// Power of the level pendulum at `b` and `k b`; without the hypothesis the second is short of `k³` times the first.
fn power_is_not_cubic([n, a]: [f64; 2], gravity: f64, b_rate: f64, [b, k]: [f64; 2]) -> Outcome {
    let arm = pendulum(gravity)?;
    let flow = one_joint(n, a);
    let torque = path_torque(&arm, &JointVector::<1>::zeros(), &flow);
    let power = |b: f64| torque.at(b, b_rate).dot(&flow.motion(b, b_rate).joint_speed);
    assert!(power(k * b) <= k.powi(3) * power(b) - 0.04, "{} {}", power(k * b), power(b));
    Ok(())
}

#[test]
fn motors_that_carry_the_weight_have_a_part_of_power_linear_in_b() -> Outcome {
    power_is_not_cubic([1.0, 0.0], 1.0, 0.0, [0.5, 2.0])?;
    let model = counterexample(&CLAIM, "balanced-gravity")?;
    let value = |name| model.value(name);
    power_is_not_cubic([value("n")?, value("a")?], value("g")?, 0.0, [value("b")?, value("k")?])
}

#[test]
fn changing_b_has_a_part_of_power_linear_in_b() -> Outcome {
    power_is_not_cubic([1.0, 0.0], 0.0, 1.0, [0.5, 2.0])?;
    let model = counterexample(&CLAIM, "constant-b")?;
    let value = |name| model.value(name);
    power_is_not_cubic([value("n")?, value("a")?], 0.0, value("rate")?, [value("b")?, value("k")?])
}

proptest! {
    #![proptest_config(config())]

    // The PUMA-560 without gravity, by its own energy and inverse dynamics. Roundings: some hundred of 1e-16 in each torque,
    // of the sizes that cancel in it, which are no larger than accelerations times the mass matrix and centrifugal torques.
    #[test]
    fn energy_goes_with_the_square_and_power_with_the_cube(
        q in joints::<6>(-3.1..3.1),
        twist in joints::<6>(-1.0..1.0),
        slope in joints::<6>(-1.0..1.0),
        b in 0.1..3.0_f64,
        k in 0.1..10.0_f64,
    ) {
        let arm = puma560_dynamics()?.with_gravity(Vector3::zeros());
        let q = JointVector::from(q);
        let inversion = SingularityConsistent::new(Task::Pose, SpeedFactor::Determinant, 6)?;
        let flow = inversion.flow(arm.arm(), &q, &PathTangent { twist: Twist::from(twist), slope: Twist::from(slope) });
        let energy = |b: f64| arm.kinetic_energy(&q, &flow.motion(b, 0.0).joint_speed);
        prop_assert!((energy(k * b) - k * k * energy(b)).abs() <= 1e-12 * k * k * energy(b));
        let power = |b: f64| {
            let motion = flow.motion(b, 0.0);
            arm.inverse(&q, &motion.joint_speed, &motion.joint_acceleration).dot(&motion.joint_speed)
        };
        let mass = arm.mass_matrix(&q).norm();
        let speed = flow.direction.joints.norm() * b;
        let size = k.powi(3) * speed * mass * (flow.slope.joints.norm() * b * b + speed * speed);
        prop_assert!((power(k * b) - k.powi(3) * power(b)).abs() <= 1e-12 * size, "{} {}", power(b), size);
    }
}
