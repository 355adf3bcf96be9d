use slideway_motion::control::task_space::{Impedance, ToolReference};
use slideway_proofs::impedance_passivity::CLAIM;
use slideway_robot::JointVector;

use crate::natural_support::pendulum;
use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The level pendulum in zero-gravity mode with another weight gains kinetic energy at `v (gm - g)` though nobody pushes.
fn energy_comes_from_nowhere([v, g, gm]: [f64; 3]) -> Outcome {
    let (arm, free) = (pendulum(g)?, Impedance::zero_gravity(pendulum(gm)?, JointVector::from_element(f64::INFINITY))?);
    let (q, qd) = (JointVector::<1>::zeros(), JointVector::from([v]));
    let torque = free.step(&ToolReference::at_rest(arm.arm().forward(&q)), &q, &qd).torque;
    let rate = qd.dot(&(arm.mass_matrix(&q) * arm.forward(&q, &qd, &torque)?));
    assert!(rate >= 0.04, "{rate}");
    Ok(())
}

#[test]
fn a_weight_that_is_not_the_arms_puts_energy_in() -> Outcome {
    energy_comes_from_nowhere([0.5, 0.5, 1.0])?;
    let model = counterexample(&CLAIM, "exact-weight")?;
    energy_comes_from_nowhere([model.value("v")?, model.value("g")?, model.value("gm")?])
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
