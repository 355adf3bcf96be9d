use slideway_conditioner::bounds::time_bracket;
use slideway_conditioner::{Advance, SpeedLimits, SpeedRegulator, SpeedState};
use slideway_proofs::time_bracket::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven, settings};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The limit widens at once: the ratio of the next sample is below the `r = 1 - a` of a path without drift.
fn fast_drift_falls_below(a: f64, f: f64, g: f64, g_next: f64) -> Outcome {
    let mut settings = settings(SpeedLimits::symmetric([1.0])?, a, 1.0);
    settings.advance = Advance::Synchronised;
    let regulator = SpeedRegulator::new(settings)?;
    let mut state = SpeedState::moving(f)?;
    assert!(regulator.step(&mut state, &[g * f]).limit_ratio > 1.0);
    let desired = [g_next * state.factor()];
    let after = regulator.step(&mut state, &desired).limit_ratio;
    assert!(after < 1.0 - a - 0.1, "{after}");
    Ok(())
}

#[test]
fn a_limit_that_widens_faster_than_the_drift_allows_for_is_not_used() -> Outcome {
    fast_drift_falls_below(0.25, 0.5, 3.0, 1.25)?;
    let model = counterexample(&CLAIM, "slow-drift")?;
    let value = |name| model.value(name);
    fast_drift_falls_below(value("a")?, value("f")?, value("g")?, value("g_next")?)
}

#[test]
fn outside_its_hypotheses_there_is_no_bracket() {
    assert!(time_bracket(0.05, 1.5, 0.01, 0.0).is_some());
    for [a, g_min, drift, start] in [
        [1.0, 1.5, 0.01, 0.0],
        [0.05, 0.9, 0.01, 0.0],
        [0.05, 1.5, 2.0, 0.0],
        // r (1 - r) = 0.25 > a.
        [0.05, 1.0, 0.64, 0.0],
        [0.05, 1.5, f64::NAN, 0.0],
        [0.05, 1.5, 0.01, 1.1],
    ] {
        assert_eq!(time_bracket(a, g_min, drift, start), None, "{a} {g_min} {drift} {start}");
    }
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
