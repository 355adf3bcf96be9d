use proptest::prelude::{prop_assert, proptest};
use proptest::test_runner::TestCaseError;
use slideway_conditioner::bounds::frozen_band;
use slideway_conditioner::{SpeedRegulator, SpeedState};
use slideway_proofs::frozen_band::CLAIM;

use crate::support::{
    Outcome, Proportional, config, counterexample, filter_step, proportional, proven, settings, unit_joint,
};

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

/// Rounding. The measured `m` is `g f` with at most four roundings (rate, share of the limit, product, ratio), 2 eps. While
/// `u = 1` the filter adds three more to `(1 - a) m + a g <= band`; while `u = 0` it cannot raise `f`, nor then `m`, because
/// every operation is monotonic: nothing accumulates. Start and band cost three roundings each. In all less than
/// 2 (inherited) + 2 (measured) + 1.5 (filter) + 1.5 (band) = 7 eps of the band.
const SLACK: f64 = 8.0 * f64::EPSILON;

fn keeps_the_band<const N: usize>(arm: &Proportional<N>, a: f64, g: f64, place: f64) -> Result<(), TestCaseError> {
    let band = frozen_band(a, g);
    let regulator = SpeedRegulator::new(settings(arm.limits, a, g))?;
    let mut state = SpeedState::moving((place * band / g).min(1.0))?;
    for sample in 0..100 {
        let desired = arm.at(regulator.requested_rate(&state));
        let command = regulator.step(&mut state, &desired);
        prop_assert!(command.limit_ratio <= band * (1.0 + SLACK), "sample {sample}: {} > {band}", command.limit_ratio);
    }
    Ok(())
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn one_joint_keeps_the_band(arm in proportional::<1>(), a in filter_step(), g in 1.0..50.0, place in 0.0..=1.0) {
        keeps_the_band(&arm, a, g, place)?;
    }

    #[test]
    fn three_joints_keep_the_band(arm in proportional::<3>(), a in filter_step(), g in 1.0..50.0, place in 0.0..=1.0) {
        keeps_the_band(&arm, a, g, place)?;
    }
}
