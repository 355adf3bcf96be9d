use slideway_conditioner::{AffineSpeed, ImplicitSpeedRegulator, SpeedLimits, SpeedState};
use slideway_proofs::never_slower::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven, settings};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The first sample from rest, with a limit of 1 rad/s.
fn rising_filter_is_slower(v: f64, target: f64, a: f64, natural: f64) -> Outcome {
    let regulator = ImplicitSpeedRegulator::new(settings(SpeedLimits::symmetric([1.0])?, a, target))?;
    let desired = AffineSpeed { feedback: [0.0], feedforward: [v * target] };
    let rate = regulator.step(&mut SpeedState::at_rest(), &desired).path_rate;
    // The solver's decimals are cut at 1e-20.
    assert!(natural * v <= 1.0 + 1e-15 && natural <= target + 1e-15);
    assert!(rate < natural - 0.05, "{rate} {natural}");
    Ok(())
}

#[test]
fn while_the_filter_rises_natural_motion_is_faster() -> Outcome {
    rising_filter_is_slower(0.5, 4.0, 0.125, 1.5)?;
    let model = counterexample(&CLAIM, "settled-filter")?;
    let value = |name| model.value(name);
    rising_filter_is_slower(value("v")?, value("d")?, value("a")?, value("s")?)
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
