use slideway_conditioner::acceleration::{AccelerationLimits, AccelerationState};
use slideway_conditioner::{AffineSpeed, SpeedLimits};
use slideway_proofs::acceleration_box::{CLAIM, regulator};

use crate::support::{Outcome, TS, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// A state made under wider speed limits: the narrower ones are kept at once, the acceleration limit cannot be.
fn acceleration_is_exceeded(before: f64) -> Outcome {
    let regulator = regulator(SpeedLimits::symmetric([1.0])?, AccelerationLimits::symmetric([2.0])?, 0.1)?;
    let mut state = AccelerationState::moving(0.0, [before], &SpeedLimits::symmetric([3.0])?)?;
    let command = regulator.step(&mut state, &AffineSpeed { feedback: [0.0], feedforward: [0.0] });
    let [speed] = command.joint_speed;
    assert!(speed.abs() <= 1.0 && (speed - before).abs() >= 4.0 * TS, "{speed} after {before}");
    Ok(())
}

#[test]
fn a_previous_command_beyond_the_speed_limits_exceeds_the_acceleration() -> Outcome {
    acceleration_is_exceeded(2.5)?;
    acceleration_is_exceeded(counterexample(&CLAIM, "previous-inside")?.value("p")?)
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
