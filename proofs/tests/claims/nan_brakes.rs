use slideway_conditioner::{ParameterError, SpeedLimits};
use slideway_proofs::nan_brakes::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model_over_doubles() -> Outcome {
    proven(&CLAIM)
}

/// "Neither below nor above" takes it for a speed inside; the shipped comparison does not.
fn unordered_comparison_releases(speed: f64) -> Outcome {
    let limits = SpeedLimits::symmetric([1.0])?;
    let below = speed < -1.0;
    let above = speed > 1.0;
    assert!(!speed.is_finite() && !below && !above);
    assert!(!limits.contain(&[speed]));
    Ok(())
}

#[test]
fn a_comparison_that_nan_passes_would_release() -> Outcome {
    unordered_comparison_releases(f64::NAN)?;
    unordered_comparison_releases(counterexample(&CLAIM, "ordered-comparison")?.value("speed")?)
}

/// The limits contain a speed that is not finite, and are refused.
fn limits_that_contain_are_refused(lower: f64, upper: f64, speed: f64) {
    assert!(!speed.is_finite() && lower <= speed && speed <= upper);
    let refused = SpeedLimits::new([lower], [upper]);
    assert!(matches!(refused, Err(ParameterError::LowerLimit { .. } | ParameterError::UpperLimit { .. })));
}

#[test]
fn infinite_limits_would_release_an_infinite_speed_and_are_refused() -> Outcome {
    limits_that_contain_are_refused(f64::NEG_INFINITY, 1.0, f64::NEG_INFINITY);
    let model = counterexample(&CLAIM, "finite-limits")?;
    limits_that_contain_are_refused(model.value("lower")?, model.value("upper")?, model.value("speed")?);
    Ok(())
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
