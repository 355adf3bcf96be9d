use proptest::prelude::{Just, Strategy, any, prop_assert, prop_oneof, proptest};
use slideway_conditioner::{
    AffineSpeed, ImplicitSpeedRegulator, ParameterError, SpeedRegulator, SpeedSettings, SpeedState,
};
use slideway_proofs::factor_range::CLAIM;

use crate::support::{
    Outcome, TS, advance, config, counterexample, filter, filter_step, joints, limits, proven, saturation,
};

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

/// Numbers in [0, 1] with the ends, their neighbours and everything tiny well represented.
fn unit() -> impl Strategy<Value = f64> {
    prop_oneof![
        0.0..=1.0,
        prop_oneof![Just(0.0), Just(1.0), Just(0.5)],
        (0_u64..64).prop_map(|steps| f64::from_bits(1.0_f64.to_bits() - steps)),
        (0_u64..64).prop_map(f64::from_bits),
        (0_u64..=1.0_f64.to_bits()).prop_map(f64::from_bits),
    ]
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn the_filter_stays_in_range_to_the_last_bit(
        a in prop_oneof![filter_step(), unit().prop_filter("steps are positive", |a| a / TS > 0.0 && a / TS * TS > 0.0)],
        f in unit(),
        u in unit(),
    ) {
        // No slack: the claim is exact.
        let next = filter(a)?.next(f, u);
        prop_assert!((0.0..=1.0).contains(&next), "{next:e}");
    }

    #[test]
    fn the_regulators_stay_in_range_for_every_input(
        limits in limits::<2>(-300.0..300.0),
        a in filter_step(),
        start in unit(),
        saturation in saturation(),
        advance in advance(),
        inputs in proptest::collection::vec((joints::<2>(any::<f64>()), joints::<2>(any::<f64>())), 8),
    ) {
        let settings =
            SpeedSettings { limits, sampling_period: TS, bandwidth: a / TS, target_rate: 5.0, saturation, advance };
        let explicit = SpeedRegulator::new(settings)?;
        let implicit = ImplicitSpeedRegulator::new(settings)?;
        let (mut one, mut other) = (SpeedState::moving(start)?, SpeedState::moving(start)?);
        for (feedback, feedforward) in inputs {
            explicit.step(&mut one, &feedback);
            implicit.step(&mut other, &AffineSpeed { feedback, feedforward });
            prop_assert!((0.0..=1.0).contains(&one.factor()) && (0.0..=1.0).contains(&other.factor()));
        }
    }
}
