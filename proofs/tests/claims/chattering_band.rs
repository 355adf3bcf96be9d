use slideway_conditioner::SpeedState;
use slideway_conditioner::bounds::{chattering_bound, chattering_estimate};
use slideway_proofs::chattering_band::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven, unit_joint};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// Two samples at zero error; eq 23 takes the feedforward of the second.
fn estimate_is_exceeded(a: f64, f: f64, feedforward: f64, next: f64) -> Outcome {
    let regulator = unit_joint(a, 1.0)?;
    let mut state = SpeedState::moving(f)?;
    let before = f * feedforward;
    regulator.step(&mut state, &[before]);
    let after = state.factor() * next;
    assert!((after - before).abs() > chattering_estimate(next, a, 1.0) + 0.05, "{before} {after}");
    let change = state.factor() - f;
    assert!((after - before).abs() <= chattering_bound(next, change, f * (next - feedforward)) + 1e-15);
    Ok(())
}

#[test]
fn eq_23_is_no_bound_where_the_path_drifts() -> Outcome {
    estimate_is_exceeded(0.5, 0.5, 3.0, 1.0)?;
    let model = counterexample(&CLAIM, "drift-term")?;
    estimate_is_exceeded(model.value("a")?, model.value("f")?, model.value("B")?, model.value("B_next")?)
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
