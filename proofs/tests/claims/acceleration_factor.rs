use slideway_conditioner::acceleration::{AccelerationLimits, AccelerationState, PathKeeping};
use slideway_conditioner::{AffineSpeed, SpeedLimits};
use slideway_proofs::acceleration_box::regulator;
use slideway_proofs::acceleration_factor::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The path goes on without a joint that moves at `speed`.
fn path_is_left(speed: f64) -> Outcome {
    let limits = SpeedLimits::symmetric([1.0, 1.0])?;
    let regulator = regulator(limits, AccelerationLimits::symmetric([2.0, 2.0])?, 0.1)?;
    let mut state = AccelerationState::moving(0.5, [speed, 0.0], &limits)?;
    let command = regulator.step(&mut state, &AffineSpeed { feedback: [0.0; 2], feedforward: [0.0, 1.0] });
    assert!(matches!(command.keeping, PathKeeping::LeavesPath { .. }), "{command:?}");
    Ok(())
}

#[test]
fn a_path_that_goes_on_without_a_moving_joint_is_left() -> Outcome {
    path_is_left(-0.9)?;
    path_is_left(counterexample(&CLAIM, "reachable-ray")?.value("p")?)
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
