use slideway_conditioner::acceleration::{AccelerationState, Recovery};
use slideway_conditioner::{AffineSpeed, SpeedLimits};
use slideway_proofs::acceleration_recovery::{CLAIM, regulator};

use crate::support::{Outcome, TS, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The error after one sample of `Kp Ts = 1` from the previous command `p = Kp e_before`.
fn passes_the_reference(deceleration: f64, p: f64) -> Outcome {
    let regulator = regulator(1.0, [deceleration, 1.0], Recovery::AsDemanded)?;
    let mut state = AccelerationState::moving(0.0, [p], &SpeedLimits::symmetric([1.0])?)?;
    // e_before = p / Kp = Ts p, all of which the previous command covers.
    let error = 0.0;
    let command = regulator.step(&mut state, &AffineSpeed { feedback: [error], feedforward: [0.0] });
    assert!(error - TS * command.joint_speed[0] < -2e-4, "{command:?}");
    Ok(())
}

#[test]
fn a_gain_beyond_deceleration_over_speed_passes_the_reference() -> Outcome {
    passes_the_reference(2.0, 0.9)?;
    let model = counterexample(&CLAIM, "moderate-gain")?;
    passes_the_reference(model.value("D")?, model.value("p")?)
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
