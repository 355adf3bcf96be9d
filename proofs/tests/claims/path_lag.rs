use slideway_conditioner::path::PathQuantity;
use slideway_conditioner::{ParameterError, PathConditioner};
use slideway_proofs::path_lag::CLAIM;

use crate::path_support::{implicit, settings};
use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// `e = exp(-T / K)`, and the conditioner's verdict on that `K`.
fn memory_of_a_negative_approach_is_refused(e: f64, sigma: f64, mean: f64, m: f64) {
    assert!(sigma <= m && mean <= m && e * sigma + (1.0 - e) * mean > m + 0.04);
    let mut settings = settings::<1>(implicit());
    settings.approach = [-settings.sampling_period / e.ln()];
    let refused = PathConditioner::<3, 1>::new(settings);
    let quantity = PathQuantity::Approach(0);
    assert_eq!(refused, Err(ParameterError::Path { quantity, value: settings.approach[0] }));
}

#[test]
fn without_a_positive_approach_time_it_is_no_lag_and_the_conditioner_refuses_it() -> Outcome {
    memory_of_a_negative_approach_is_refused(1.5, 0.0, -1.0, 0.0);
    let model = counterexample(&CLAIM, "approach")?;
    let value = |name| model.value(name);
    memory_of_a_negative_approach_is_refused(value("e")?, value("sigma")?, value("mean")?, value("m")?);
    Ok(())
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
