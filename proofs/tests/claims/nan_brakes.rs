use proptest::prelude::{Just, Strategy, any, prop_assert, prop_assert_eq, prop_oneof, proptest};
use slideway_conditioner::{
    AffineSpeed, ImplicitSpeedRegulator, ParameterError, SpeedCommand, SpeedLimits, SpeedRegulator, SpeedSettings,
    SpeedState,
};
use slideway_proofs::nan_brakes::CLAIM;

use crate::support::{Outcome, TS, advance, config, counterexample, filter_step, joints, limits, proven, saturation};

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

fn stands_still(command: &SpeedCommand<3>) -> bool {
    command.joint_speed == [0.0; 3] && command.path_rate == 0.0
}

fn not_finite() -> impl Strategy<Value = f64> {
    prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(f64::NEG_INFINITY)]
}

fn speeds() -> impl Strategy<Value = [f64; 3]> {
    prop_oneof![joints::<3>(any::<f64>()), joints::<3>(-1.0..1.0)]
}

proptest! {
    #![proptest_config(config())]

    // The explicit claims are exact. The implicit u is 1 - f' / a with f' = f + a (1 - f) >= a, whose three roundings and
    // the quotient's can leave it 2 eps above 0.
    #[test]
    fn an_input_that_is_not_finite_brakes(
        limits in limits::<3>(-3.0..3.0),
        a in filter_step(),
        start in 0.0..=1.0,
        saturation in saturation(),
        advance in advance(),
        feedback in speeds(),
        feedforward in speeds(),
        bad in not_finite(),
        place in 0_usize..6,
    ) {
        let settings =
            SpeedSettings { limits, sampling_period: TS, bandwidth: a / TS, target_rate: 5.0, saturation, advance };
        let mut speeds = [feedback, feedforward];
        if let Some(speed) = speeds.as_flattened_mut().get_mut(place) {
            *speed = bad;
        }
        let [feedback, feedforward] = speeds;

        let mut state = SpeedState::moving(start)?;
        let command = ImplicitSpeedRegulator::new(settings)?.step(&mut state, &AffineSpeed { feedback, feedforward });
        prop_assert!(stands_still(&command) && command.switch <= 2.0 * f64::EPSILON, "{command:?}");
        prop_assert_eq!(state.factor(), 0.0);

        let desired = if place < 3 { feedback } else { feedforward };
        let mut state = SpeedState::moving(start)?;
        let command = SpeedRegulator::new(settings)?.step(&mut state, &desired);
        prop_assert!(stands_still(&command) && command.switch == 0.0, "{command:?}");
        prop_assert!(state.factor() <= start);
    }
}
