use proptest::prelude::{Just, prop_assert, prop_oneof, proptest};
use proptest::strategy::Strategy;
use slideway_conditioner::bounds::{chattering_bound, chattering_estimate};
use slideway_conditioner::{AffineSpeed, SpeedLimits, SpeedRegulator, SpeedState};
use slideway_proofs::chattering_band::CLAIM;

use crate::support::{Outcome, TS, config, counterexample, filter_step, joints, proven, settings, unit_joint};

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

fn sized() -> impl Strategy<Value = f64> + Clone {
    (prop_oneof![Just(1.0), Just(-1.0), Just(0.0)], -3.0..3.0)
        .prop_map(|(sign, exponent): (f64, f64)| sign * 10f64.powf(exponent))
}

fn affine() -> impl Strategy<Value = AffineSpeed<2>> {
    (joints::<2>(sized()), joints::<2>(sized()))
        .prop_map(|(feedback, feedforward)| AffineSpeed { feedback, feedforward })
}

proptest! {
    #![proptest_config(config())]

    // Rounding, with S = |A| + |A'| + |B| + |B'|. Left: two products and two sums, 2 S roundoffs; the filter, 3 |B'|; the
    // difference, S. Right, at most 2 S: seven operations, none deeper than five, 10 S. Less than 16 S roundoffs = 8 eps S.
    #[test]
    fn the_change_of_a_desired_speed_keeps_the_bound(
        upper in joints::<2>(0.01..10.0),
        lower in joints::<2>(-10.0..-0.01),
        a in filter_step(),
        start in 0.0..=1.0,
        one in affine(),
        two in affine(),
    ) {
        let regulator = SpeedRegulator::new(settings(SpeedLimits::new(lower, upper)?, a, 1.0))?;
        let mut state = SpeedState::moving(start)?;
        let before = one.at(start);
        let command = regulator.step(&mut state, &before);
        let after = two.at(state.factor());
        for joint in 0..2 {
            let (fb, ff) = (one.feedback[joint], one.feedforward[joint]);
            let (fb_next, ff_next) = (two.feedback[joint], two.feedforward[joint]);
            let drift = start * (ff_next - ff).abs() + (fb_next - fb).abs();
            let bound = chattering_bound(ff_next, a * (command.switch - start), drift);
            let slack = 8.0 * f64::EPSILON * (fb.abs() + fb_next.abs() + ff.abs() + ff_next.abs());
            prop_assert!((after[joint] - before[joint]).abs() <= bound + slack);
        }
    }

    // On the path, zero error: v(λ) = c sin(w λ + p), sup |dv/dλ| = |c w|. Rounding: the sine's argument is off by three
    // roundings of itself and of w λ, at both samples; the rest as above with S = 2 |c| λ̇d.
    #[test]
    fn along_a_path_the_drift_is_the_derivative_times_the_way(
        size in 0.01..10.0,
        frequency in 0.1..500.0,
        phase in 0.0..6.0,
        a in filter_step(),
        start in 0.0..=1.0,
        target_rate in 0.5..20.0,
    ) {
        let regulator = unit_joint(a, target_rate)?;
        let mut state = SpeedState::moving(start)?;
        let joint_rate = |place: f64| -> f64 { size * f64::sin(frequency * place + phase) };
        let mut place = 0.0;
        for _ in 0..30 {
            let (factor, before) = (state.factor(), joint_rate(place) * regulator.requested_rate(&state));
            let command = regulator.step(&mut state, &[before]);
            place += TS * command.path_rate;
            let after = joint_rate(place) * regulator.requested_rate(&state);
            let drift = TS * command.path_rate * command.path_rate * size * frequency;
            let bound = chattering_bound(joint_rate(place) * target_rate, a * (command.switch - factor), drift);
            let slack = f64::EPSILON * size * target_rate * (16.0 + 3.0 * (2.0 * frequency * place + phase));
            prop_assert!((after - before).abs() <= bound + slack, "{before} {after} {bound}");
        }
    }
}
