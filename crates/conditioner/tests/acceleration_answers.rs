//! The acceleration-limited regulator against answers worked out by hand.

use proptest::prelude::*;
use slideway_conditioner::acceleration::{
    AccelerationLimits, AccelerationRegulator, AccelerationSettings, AccelerationState, PathKeeping, Recovery,
};
use slideway_conditioner::{AffineSpeed, ParameterError, SpeedLimits};

const TS: f64 = 1e-3;
const TARGET: f64 = 5.0;

/// Speed limits of `speed`; accelerations between `lower` and `upper`.
fn settings<const N: usize>(
    speed: f64,
    lower: [f64; N],
    upper: [f64; N],
    bandwidth: f64,
) -> Result<AccelerationSettings<N>, ParameterError> {
    Ok(AccelerationSettings {
        speed_limits: SpeedLimits::symmetric([speed; N])?,
        acceleration_limits: AccelerationLimits::new(lower, upper)?,
        sampling_period: TS,
        bandwidth,
        target_rate: TARGET,
        recovery: Recovery::AsDemanded,
    })
}

#[test]
fn acceleration_limits_are_those_given_and_others_are_refused_with_joint_and_value() -> Result<(), ParameterError> {
    let limits = AccelerationLimits::new([-1.5, -2.5], [3.5, 4.5])?;
    assert_eq!((limits.lower(), limits.upper()), (&[-1.5, -2.5], &[3.5, 4.5]));
    assert_eq!(AccelerationLimits::symmetric([2.0, 3.0])?, AccelerationLimits::new([-2.0, -3.0], [2.0, 3.0])?);
    for value in [0.0, -1.0, f64::INFINITY] {
        let refused = Some(ParameterError::UpperAcceleration { joint: 1, value });
        assert_eq!(AccelerationLimits::symmetric([1.0, value]).err(), refused);
        assert_eq!(AccelerationLimits::new([-1.0; 2], [1.0, value]).err(), refused);
        let refused = Some(ParameterError::LowerAcceleration { joint: 1, value: -value });
        assert_eq!(AccelerationLimits::new([-1.0, -value], [1.0; 2]).err(), refused);
    }
    assert!(AccelerationLimits::symmetric([f64::NAN]).is_err());
    assert!(
        AccelerationLimits::new([f64::NAN], [1.0]).is_err() && AccelerationLimits::new([-1.0], [f64::NAN]).is_err()
    );
    Ok(())
}

#[test]
fn a_run_begins_with_any_factor_and_speed_inside_their_limits_and_no_others() -> Result<(), ParameterError> {
    let limits = SpeedLimits::new([-1.0, -2.0], [3.0, 4.0])?;
    for (factor, speed) in [(0.0, [-1.0, 4.0]), (1.0, [3.0, -2.0]), (0.25, [0.5, 0.0])] {
        let state = AccelerationState::moving(factor, speed, &limits)?;
        assert_eq!((state.factor(), *state.joint_speed()), (factor, speed));
    }
    for factor in [-0.1, 1.1, f64::INFINITY] {
        let refused = AccelerationState::moving(factor, [0.0; 2], &limits).err();
        assert_eq!(refused, Some(ParameterError::Factor(factor)));
    }
    for value in [-2.1, 4.1, f64::INFINITY] {
        let refused = AccelerationState::moving(0.5, [0.0, value], &limits).err();
        assert_eq!(refused, Some(ParameterError::Speed { joint: 1, value }));
    }
    assert!(AccelerationState::moving(f64::NAN, [0.0; 2], &limits).is_err());
    assert!(AccelerationState::moving(0.5, [f64::NAN, 0.0], &limits).is_err());
    Ok(())
}

#[test]
fn settings_out_of_range_are_refused_with_their_value() -> Result<(), ParameterError> {
    let good = settings::<1>(1.0, [-2.0], [2.0], 50.0)?;
    let refused = |settings| AccelerationRegulator::new(settings).err();
    for bad in [0.0, -1.0, f64::INFINITY] {
        let target_rate = AccelerationSettings { target_rate: bad, ..good };
        assert_eq!(refused(target_rate), Some(ParameterError::TargetRate(bad)));
        let period = AccelerationSettings { sampling_period: bad, ..good };
        assert_eq!(refused(period), Some(ParameterError::SamplingPeriod(bad)));
        let bandwidth = AccelerationSettings { bandwidth: bad, ..good };
        assert_eq!(refused(bandwidth), Some(ParameterError::Bandwidth(bad)));
        let recovery = AccelerationSettings { recovery: Recovery::Braking { gain: bad }, ..good };
        assert_eq!(refused(recovery), Some(ParameterError::Gain(bad)));
    }
    let half = AccelerationSettings { recovery: Recovery::Braking { gain: 500.0 }, ..good };
    assert_eq!(refused(half), None);
    assert_eq!(AccelerationRegulator::new(good)?.target_rate(), TARGET);
    Ok(())
}

#[test]
fn a_sample_reports_rate_demand_factor_and_the_switch_that_leads_to_it() -> Result<(), ParameterError> {
    let settings = settings::<1>(1.0, [-2.0], [2.0], 50.0)?;
    let regulator = AccelerationRegulator::new(settings)?;
    // The filter step is 0.05: from 0.5 the factor may rise to 0.525. The speed may rise from 0.5 to 0.502.
    for (feedforward, factor, switch, speed) in [
        (0.95, 0.525, 1.0, 0.49875), // the filter decides
        (1.0, 0.502, 0.54, 0.502),   // the acceleration limit does: 0.95 · 0.5 + 0.05 · 0.54
    ] {
        let mut state = AccelerationState::moving(0.5, [0.5], &settings.speed_limits)?;
        let command = regulator.step(&mut state, &AffineSpeed { feedback: [0.0], feedforward: [feedforward] });
        // Numbers up to 3 after some roundings; the switch divides by 0.05.
        let is_near = |value: f64, by_hand: f64| (value - by_hand).abs() < 1e-13;
        assert!(is_near(command.factor, factor) && is_near(command.path_rate, TARGET * factor), "{command:?}");
        assert!(is_near(command.switch, switch) && is_near(command.desired[0], speed), "{command:?}");
        assert!(is_near(command.joint_speed[0], speed) && command.keeping == PathKeeping::OnPath, "{command:?}");
        assert_eq!((state.factor(), *state.joint_speed()), (command.factor, command.joint_speed));
    }
    Ok(())
}

#[test]
fn the_path_rate_is_at_most_the_ceiling_on_the_path_and_off_it() -> Result<(), ParameterError> {
    // Limits far away: only filter (to 0.8) and ceiling count.
    let free = settings::<1>(10.0, [-1e5], [1e5], 500.0)?;
    let rate = |ceiling| -> Result<f64, ParameterError> {
        let mut state = AccelerationState::moving(0.6, [0.6], &free.speed_limits)?;
        let demand = AffineSpeed { feedback: [0.0], feedforward: [1.0] };
        Ok(AccelerationRegulator::new(free)?.step_below(&mut state, &demand, ceiling).path_rate)
    };
    for (ceiling, expected) in
        [(2.0, 2.0), (3.5, 3.5), (4.5, 4.0), (9.0, 4.0), (0.0, 0.0), (-1.0, 0.0), (f64::NAN, 0.0)]
    {
        assert!((rate(ceiling)? - expected).abs() < 1e-14, "ceiling {ceiling}");
    }
    // Joint at 1 that loses at most 0.002: half its speed is out of reach, the less so the faster; the reference does not speed up.
    let bound = settings::<1>(1.0, [-2.0], [2.0], 500.0)?;
    for (ceiling, expected) in [(2.0, 2.0), (5.0, 3.0), (f64::NAN, 0.0)] {
        let mut state = AccelerationState::moving(0.6, [1.0], &bound.speed_limits)?;
        let demand = AffineSpeed { feedback: [0.0], feedforward: [0.5] };
        let command = AccelerationRegulator::new(bound)?.step_below(&mut state, &demand, ceiling);
        assert!((command.path_rate - expected).abs() < 1e-14, "ceiling {ceiling}: {command:?}");
        assert!(matches!(command.keeping, PathKeeping::LeavesPath { .. }));
    }
    Ok(())
}

#[test]
fn braking_feedback_is_the_speed_from_which_each_joint_can_brake_in_the_direction_asked_for()
-> Result<(), ParameterError> {
    let gain = 100.0;
    let recovery = Recovery::Braking { gain };
    let settings = AccelerationSettings { recovery, ..settings::<2>(1.0, [-2.0, -3.0], [4.0, 5.0], 50.0)? };
    let regulator = AccelerationRegulator::new(settings)?;
    // `w` at a deceleration, and `φ(x)` beyond it.
    let linear = |deceleration: f64| (1.0 - gain * TS) * deceleration / gain;
    let slowed = |x: f64, deceleration: f64| (linear(deceleration) * (2.0 * x - linear(deceleration))).sqrt() / x;
    for (feedback, share) in [
        ([1.0, 0.0], slowed(1.0, 2.0)),
        ([-1.0, 0.0], slowed(1.0, 4.0)),
        ([0.0, 0.3], slowed(0.3, 3.0)),
        ([0.0, -0.3], slowed(0.3, 5.0)),
        ([0.1, -0.9], slowed(0.9, 5.0)), // joint 2 brakes from less of what is asked
        ([0.5, -0.1], slowed(0.5, 2.0)), // joint 1 does
        ([0.018, -0.045], 1.0),          // both from as much as is asked
        ([0.0, 0.0], 1.0),
    ] {
        let mut state = AccelerationState::at_rest();
        let command = regulator.step(&mut state, &AffineSpeed { feedback, feedforward: [0.0; 2] });
        for (desired, asked) in command.desired.iter().zip(feedback) {
            assert!((desired - share * asked).abs() <= 4.0 * f64::EPSILON * asked.abs(), "{feedback:?}: {command:?}");
        }
    }
    // Twice this demand overflows. Its share of 1e-310 has fourteen digits left.
    let mut state = AccelerationState::at_rest();
    let command = regulator.step(&mut state, &AffineSpeed { feedback: [1e308, 0.0], feedforward: [0.0; 2] });
    let braked = (2.0 * linear(2.0)).sqrt() * 1e154;
    assert!((command.desired[0] - braked).abs() <= 1e-13 * braked, "{command:?}");
    Ok(())
}

#[test]
fn off_the_path_joints_exceed_in_proportion_to_what_they_can_change_in_a_sample() -> Result<(), ParameterError> {
    let settings = settings::<2>(10.0, [-1.0, -2.0], [3.0, 10.0], 50.0)?;
    let mut state = AccelerationState::moving(1.0, [0.0; 2], &settings.speed_limits)?;
    // Joint 1 exceeds 0.003 by 0.997 - f, joint 2 exceeds 0.01 by 0.49 + f: per range of 4 and of 12 the same at 8 f = 5.982 - 0.98.
    let demand = AffineSpeed { feedback: [1.0, 0.5], feedforward: [-1.0, 1.0] };
    let command = AccelerationRegulator::new(settings)?.step(&mut state, &demand);
    let factor = 5.002 / 8.0;
    assert!((command.factor - factor).abs() < 1e-14, "{command:?}");
    let is_larger_excess = |excess: f64| (excess - (0.49 + factor)).abs() < 1e-14;
    assert!(matches!(command.keeping, PathKeeping::LeavesPath { excess } if is_larger_excess(excess)), "{command:?}");
    Ok(())
}

/// Demands whose terms are many times as large or small as the speed that they leave.
fn terms() -> impl Strategy<Value = ([f64; 3], [f64; 3], f64, f64)> {
    let joints = || proptest::array::uniform3(-1.0..1.0);
    let left = prop_oneof![Just(0.0), Just(1e-5), Just(1.0)];
    (joints(), joints(), 0.0..1.0, -3.0..3.0, left, any::<bool>()).prop_map(
        |(rest, feedforward, near, decade, left, is_fed_back)| {
            let scale = 10.0_f64.powf(decade);
            let of = |joint: usize| if is_fed_back { left * rest[joint] - near * feedforward[joint] } else { 0.0 };
            (core::array::from_fn(|joint| scale * of(joint)), feedforward.map(|b| scale * b), near, scale)
        },
    )
}

proptest! {
    /// The reachable speeds lie around the demand at some factor, so that it can be met whatever the rounding of its terms.
    #[test]
    fn a_demand_within_reach_is_on_the_path_however_large_or_small_its_terms(
        (feedback, feedforward, near, scale) in terms(),
        shift in proptest::array::uniform3(-0.999..0.999),
        before in 0.0..=1.0,
    ) {
        let desired = AffineSpeed { feedback, feedforward };
        // A change of speed of 1e-4 of the scale: a thousandth of it is far above the rounding of 1e-16.
        let change = 1e-4 * scale;
        let settings = settings::<3>(10.0 * scale, [-change / TS; 3], [change / TS; 3], 1.0 / TS)?;
        let at = desired.at(near);
        let speed = core::array::from_fn(|joint| at[joint] + change * shift[joint]);
        let mut state = AccelerationState::moving(before, speed, &settings.speed_limits)?;
        let command = AccelerationRegulator::new(settings)?.step(&mut state, &desired);
        prop_assert_eq!(command.keeping, PathKeeping::OnPath, "{:?}", command);
    }
}

#[test]
fn an_excess_of_a_billionth_is_reported_however_large_or_small_the_feedforward() -> Result<(), ParameterError> {
    let settings = settings::<1>(1.0, [-2.0], [2.0], 50.0)?;
    let regulator = AccelerationRegulator::new(settings)?;
    let beyond = 1e-9;
    // The reference stands at 0, where a large feedforward asks for nothing, or goes on at 0.5, where a tiny one hardly helps.
    for (before, feedforward) in [(0.0, 1e9), (0.5, -1e-12)] {
        let mut state = AccelerationState::moving(before, [0.0], &settings.speed_limits)?;
        let demand = AffineSpeed { feedback: [2.0 * TS + beyond], feedforward: [feedforward] };
        let command = regulator.step(&mut state, &demand);
        assert_eq!(command.factor, before);
        let is_reported = |excess: f64| (excess - beyond).abs() < 1e-12;
        assert!(matches!(command.keeping, PathKeeping::LeavesPath { excess } if is_reported(excess)), "{command:?}");
    }
    Ok(())
}
