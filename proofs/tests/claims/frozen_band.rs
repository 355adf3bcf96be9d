use slideway_conditioner::SpeedState;
use slideway_conditioner::bounds::frozen_band;
use slideway_proofs::frozen_band::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven, unit_joint};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// One sample at overspeed `g`, the next at `next`, with the target rate 1: the desired speed is then `g f`.
fn band_is_left_by_drift(a: f64, g: f64, next: f64, f: f64) -> Outcome {
    let regulator = unit_joint(a, 1.0)?;
    let mut state = SpeedState::moving(f)?;
    let before = regulator.step(&mut state, &[g * f]).limit_ratio;
    let desired = [next * state.factor()];
    let after = regulator.step(&mut state, &desired).limit_ratio;
    assert!(before <= 1.0 && after > frozen_band(a, g.max(next)) + 0.05, "{before} {after}");
    Ok(())
}

#[test]
fn a_path_that_is_not_frozen_leaves_the_band() -> Outcome {
    band_is_left_by_drift(0.125, 2.0, 3.0, 0.375)?;
    let model = counterexample(&CLAIM, "frozen-path")?;
    band_is_left_by_drift(model.value("a")?, model.value("g")?, model.value("g_next")?, model.value("f")?)
}

fn band_is_left_by_error(a: f64, g: f64, e: f64, f: f64) -> Outcome {
    let regulator = unit_joint(a, g)?;
    let mut state = SpeedState::moving(f)?;
    let desired = [e + regulator.requested_rate(&state)];
    let before = regulator.step(&mut state, &desired).limit_ratio;
    let desired = [e + regulator.requested_rate(&state)];
    let after = regulator.step(&mut state, &desired).limit_ratio;
    assert!(before <= 1.0 && after > frozen_band(a, g) + 0.05, "{before} {after}");
    Ok(())
}

#[test]
fn a_tracking_error_leaves_the_band() -> Outcome {
    band_is_left_by_error(0.75, 2.0, 0.25, 0.25)?;
    let model = counterexample(&CLAIM, "zero-error")?;
    band_is_left_by_error(model.value("a")?, model.value("g")?, model.value("e")?, model.value("f")?)
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
