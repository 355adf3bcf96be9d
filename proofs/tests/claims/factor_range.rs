use slideway_conditioner::ParameterError;
use slideway_proofs::factor_range::CLAIM;

use crate::support::{Outcome, counterexample, filter, holds, proven};

#[test]
fn negation_has_no_model_over_reals_and_over_doubles() -> Outcome {
    proven(&CLAIM)
}

/// The law itself with a step the filter refuses, and the refusal.
fn leaves_the_range_with_step(a: f64, f: f64, u: f64) -> Outcome {
    assert!((0.0..=1.0).contains(&f) && (0.0..=1.0).contains(&u));
    assert!(!(0.0..=1.0).contains(&(f + a * (u - f))));
    assert_eq!(filter(a), Err(ParameterError::FilterStep { step: a }));
    Ok(())
}

#[test]
fn a_step_above_one_leaves_the_range_and_is_refused() -> Outcome {
    leaves_the_range_with_step(3.0, 0.5, 0.0)?;
    let model = counterexample(&CLAIM, "step-at-most-one")?;
    leaves_the_range_with_step(model.value("a")?, model.value("f")?, model.value("u")?)
}

fn leaves_the_range_with_input(a: f64, f: f64, u: f64) -> Outcome {
    assert!((0.0..=1.0).contains(&f) && !(0.0..=1.0).contains(&u));
    assert!(!(0.0..=1.0).contains(&filter(a)?.next(f, u)));
    Ok(())
}

#[test]
fn an_input_outside_zero_and_one_leaves_the_range() -> Outcome {
    leaves_the_range_with_input(0.5, 0.5, -2.0)?;
    let model = counterexample(&CLAIM, "input-in-range")?;
    leaves_the_range_with_input(model.value("a")?, model.value("f")?, model.value("u")?)
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
