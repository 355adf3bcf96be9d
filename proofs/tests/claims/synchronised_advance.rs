use slideway_conditioner::{Advance, SpeedLimits, SpeedRegulator, SpeedState};
use slideway_proofs::synchronised_advance::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven, settings};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The rate of one sample in shares of what the limits allow, `1 / v`.
fn only_waiting_keeps_the_rate(f: f64, target_rate: f64, v: f64) -> Outcome {
    let rate = |advance| -> Result<f64, Box<dyn std::error::Error>> {
        let mut settings = settings(SpeedLimits::symmetric([1.0])?, 0.1, target_rate);
        settings.advance = advance;
        let regulator = SpeedRegulator::new(settings)?;
        let mut state = SpeedState::moving(f)?;
        let desired = [v * regulator.requested_rate(&state)];
        Ok(v * regulator.step(&mut state, &desired).path_rate)
    };
    assert!(rate(Advance::Paper)? > 1.05 && rate(Advance::Synchronised)? <= 1.0 + 4.0 * f64::EPSILON);
    Ok(())
}

#[test]
fn a_reference_that_does_not_wait_is_faster_than_the_limits_allow() -> Outcome {
    only_waiting_keeps_the_rate(0.5, 2.0, 1.5)?;
    let model = counterexample(&CLAIM, "waiting")?;
    only_waiting_keeps_the_rate(model.value("f")?, model.value("d")?, model.value("v")?)
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
