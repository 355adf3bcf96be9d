use slideway_motion::AxisState;
use slideway_proofs::curve_end::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The place after two samples of constant acceleration that end with the rates `w2` and 0, the period as the unit of time.
fn after_two(u: f64, w: f64, w2: f64) -> f64 {
    let next = AxisState { position: u, velocity: w, acceleration: w2 - w }.after(1.0, 0.0);
    AxisState { acceleration: -w2, ..next }.after(1.0, 0.0).position
}

#[test]
fn with_twice_the_rate_the_end_is_passed() -> Outcome {
    let model = counterexample(&CLAIM, "half")?;
    let (u, w, w2) = (model.value("u")?, model.value("w")?, model.value("w2")?);
    // The scripts' values have twenty digits.
    assert!(after_two(u, w, w2) >= 1.01 - 1e-12);
    assert!((after_two(u, w, 1.0 - u - 0.5 * w) - 1.0).abs() <= 1e-12);
    Ok(())
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
