use slideway_motion::JointState;
use slideway_proofs::computed_torque::{CLAIM, feedback, reached};
use slideway_robot::JointVector;

use crate::natural_support::pendulum;
use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// A mass that the model has wrong by a share accelerates by that share too much.
fn acceleration_is_missed(share: f64, wanted: f64) -> Outcome {
    let arm = pendulum(0.0)?;
    let model = arm.with_mass_errors(&[share])?;
    let zero = JointVector::<1>::zeros();
    let desired = JointState { q: zero, qd: zero, qdd: JointVector::from([wanted]) };
    let acceleration = reached(&arm, model, feedback(1.0, 1.0)?, &desired, [&zero, &zero])?[0];
    assert!(acceleration - wanted >= 0.04, "{acceleration}");
    Ok(())
}

#[test]
fn a_wrong_mass_misses_the_acceleration() -> Outcome {
    acceleration_is_missed(0.1, 1.0)?;
    let model = counterexample(&CLAIM, "exact-model")?;
    acceleration_is_missed(model.value("s")?, model.value("a")?)
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
