use proptest::prelude::{prop_assert, proptest};
use proptest::strategy::Strategy;
use slideway_conditioner::{AffineSpeed, ImplicitSpeedRegulator, SpeedLimits, SpeedState};
use slideway_proofs::implicit_band::CLAIM;

use crate::support::{
    Outcome, ROUNDOFF, config, counterexample, filter, filter_step, joints, limits, proven, settings,
};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The feedback part alone asks for more than the joint can: the reference stands still and the command is saturated.
fn band_is_left(feedback: f64, feedforward: f64) -> Outcome {
    let limits = SpeedLimits::symmetric([1.0])?;
    let regulator = ImplicitSpeedRegulator::new(settings(limits, 0.1, 1.0))?;
    let mut state = SpeedState::moving(0.5)?;
    let desired = AffineSpeed { feedback: [feedback], feedforward: [feedforward] };
    let command = regulator.step(&mut state, &desired);
    assert!(command.limit_ratio > 1.05 && limits.contain(&command.joint_speed), "{command:?}");
    assert_eq!((command.factor, command.path_rate), (0.0, 0.0));
    Ok(())
}

#[test]
fn feedback_outside_the_limits_leaves_the_band() -> Outcome {
    band_is_left(2.0, -9.0)?;
    let model = counterexample(&CLAIM, "feedback-inside")?;
    band_is_left(model.value("A")?, model.value("B")?)
}

#[test]
fn very_asymmetric_limits_are_exceeded_by_more_than_four_units_in_the_last_place() -> Outcome {
    let limits = SpeedLimits::new([-1000.0], [1.0])?;
    let regulator = ImplicitSpeedRegulator::new(settings(limits, 1.0, 1.0))?;
    let desired = AffineSpeed { feedback: [-988.2], feedforward: [7769.6] };
    let command = regulator.step(&mut SpeedState::at_rest(), &desired);
    let excess = command.limit_ratio - 1.0;
    assert!(excess > 500.0 * f64::EPSILON, "{excess:e}");
    assert!(excess <= ROUNDOFF * (2.0 + 3.0 * 1001.0) && limits.contain(&command.joint_speed));
    Ok(())
}

/// Limits with a feedback part inside them and a feedforward of up to a thousand limits.
#[derive(Clone, Copy, Debug)]
struct Inside {
    limits: SpeedLimits<3>,
    desired: AffineSpeed<3>,
}

fn inside() -> impl Strategy<Value = Inside> {
    (limits::<3>(-3.0..3.0), joints::<3>(0.0..=1.0), joints::<3>(-1.0..1.0), -3.0..3.0).prop_map(
        |(limits, places, shares, exponent)| {
            let (mut feedback, mut feedforward) = (places, shares);
            for (((a, b), &lo), &up) in
                feedback.iter_mut().zip(&mut feedforward).zip(limits.lower()).zip(limits.upper())
            {
                // Rounding may not put it outside.
                *a = (lo + *a * (up - lo)).max(lo).min(up);
                *b *= up.max(-lo) * 10f64.powf(exponent);
            }
            Inside { limits, desired: AffineSpeed { feedback, feedforward } }
        },
    )
}

/// The largest ratio of one joint's two limits.
fn asymmetry(limits: &SpeedLimits<3>) -> f64 {
    let ratios = limits.lower().iter().zip(limits.upper()).map(|(lo, up)| (lo / up).abs().max((up / lo).abs()));
    ratios.fold(1.0, f64::max)
}

/// `e (2 + 3 (1 + κ))`, derived in [`slideway_proofs::implicit_band`]; a thousandth covers the products of roundings.
fn slack(limits: &SpeedLimits<3>) -> f64 {
    1.001 * ROUNDOFF * (2.0 + 3.0 * (1.0 + asymmetry(limits)))
}

/// The upper limits, in both directions.
fn symmetric_to_upper(limits: &SpeedLimits<3>) -> Option<SpeedLimits<3>> {
    SpeedLimits::symmetric(*limits.upper()).ok()
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn feedback_inside_the_limits_keeps_the_whole_inside(case in inside(), a in filter_step(), start in 0.0..=1.0) {
        let regulator = ImplicitSpeedRegulator::new(settings(case.limits, a, 5.0))?;
        let mut state = SpeedState::moving(start)?;
        let command = regulator.step(&mut state, &case.desired);
        // m - 1 is exact near 1.
        prop_assert!(command.limit_ratio - 1.0 <= slack(&case.limits), "{:e}", command.limit_ratio - 1.0);
        // Exact: the factor is the smaller of the filter's output and f*.
        let risen = filter(a)?.next(start, 1.0);
        prop_assert!(command.factor == state.factor() && command.factor <= risen);
        // Not needlessly slow: a factor below the filter's uses a limit fully, to the same rounding.
        if command.factor < risen.min(1.0) {
            prop_assert!(1.0 - command.limit_ratio <= slack(&case.limits), "{:e}", 1.0 - command.limit_ratio);
        }
    }

    #[test]
    fn symmetric_limits_are_kept_to_four_units_in_the_last_place(case in inside(), a in filter_step(), start in 0.0..=1.0) {
        let Some(limits) = symmetric_to_upper(&case.limits) else { return Ok(()) };
        let mut desired = case.desired;
        for ((v, &lo), &up) in desired.feedback.iter_mut().zip(limits.lower()).zip(limits.upper()) {
            *v = v.max(lo).min(up);
        }
        let regulator = ImplicitSpeedRegulator::new(settings(limits, a, 5.0))?;
        let command = regulator.step(&mut SpeedState::moving(start)?, &desired);
        prop_assert!(command.limit_ratio - 1.0 <= 4.0 * f64::EPSILON, "{:e}", command.limit_ratio - 1.0);
    }
}
