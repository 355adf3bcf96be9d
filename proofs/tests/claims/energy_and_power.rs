use slideway_proofs::energy_and_power::CLAIM;
use slideway_robot::JointVector;
use slideway_robot::augmented::path_torque;

use crate::natural_support::{one_joint, pendulum};
use crate::support::{Outcome, counterexample, holds, proven};

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

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
