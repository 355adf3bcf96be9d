use slideway_conditioner::{AffineSpeed, ImplicitSpeedRegulator, SpeedLimits, SpeedState};
use slideway_proofs::implicit_band::CLAIM;

use crate::support::{Outcome, ROUNDOFF, counterexample, holds, proven, settings};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The feedback part alone asks for more than the joint can: the reference stands still and the command is saturated.
fn band_is_left(feedback: f64, feedforward: f64) -> Outcome {
    let limits = SpeedLimits::symmetric([1.0])?;
    let regulator = ImplicitSpeedRegulator::new(settings(limits, 0.1, 1.0))?;
    let mut state = SpeedState::moving(0.5)?;
    let desired = AffineSpeed { feedback: [feedback], feedforward: [feedforward] };
    let command = regulator.step(&mut state, &desired);
    assert!(command.limit_ratio > 1.05 && limits.contain(&command.joint_speed), "{command:?}");
    assert_eq!((command.factor, command.path_rate), (0.0, 0.0));
    Ok(())
}

#[test]
fn feedback_outside_the_limits_leaves_the_band() -> Outcome {
    band_is_left(2.0, -9.0)?;
    let model = counterexample(&CLAIM, "feedback-inside")?;
    band_is_left(model.value("A")?, model.value("B")?)
}

#[test]
fn very_asymmetric_limits_are_exceeded_by_more_than_four_units_in_the_last_place() -> Outcome {
    let limits = SpeedLimits::new([-1000.0], [1.0])?;
    let regulator = ImplicitSpeedRegulator::new(settings(limits, 1.0, 1.0))?;
    let desired = AffineSpeed { feedback: [-988.2], feedforward: [7769.6] };
    let command = regulator.step(&mut SpeedState::at_rest(), &desired);
    let excess = command.limit_ratio - 1.0;
    assert!(excess > 500.0 * f64::EPSILON, "{excess:e}");
    assert!(excess <= ROUNDOFF * (2.0 + 3.0 * 1001.0) && limits.contain(&command.joint_speed));
    Ok(())
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
