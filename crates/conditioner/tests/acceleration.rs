//! Joint-acceleration limits are kept whatever is asked; without look-ahead some paths must be left.

use proptest::prelude::*;
use slideway_conditioner::acceleration::{
    AccelerationCommand, AccelerationLimits, AccelerationRegulator, AccelerationSettings, AccelerationState,
    PathKeeping, Recovery,
};
use slideway_conditioner::{AffineSpeed, ParameterError, SpeedLimits};

const TS: f64 = 1e-3;

fn settings<const N: usize>(speed: f64, acceleration: f64) -> Result<AccelerationSettings<N>, ParameterError> {
    Ok(AccelerationSettings {
        speed_limits: SpeedLimits::symmetric([speed; N])?,
        acceleration_limits: AccelerationLimits::symmetric([acceleration; N])?,
        sampling_period: TS,
        bandwidth: 50.0,
        target_rate: 5.0,
        recovery: Recovery::AsDemanded,
    })
}

#[test]
fn a_path_that_goes_on_without_a_moving_joint_must_be_left() -> Result<(), ParameterError> {
    let regulator = AccelerationRegulator::new(settings::<2>(1.0, 2.0)?)?;
    let mut state = AccelerationState::moving(0.2, [1.0, 0.0], &SpeedLimits::symmetric([1.0; 2])?)?;
    let corner = AffineSpeed { feedback: [0.0; 2], feedforward: [0.0, 5.0] };
    let command = regulator.step(&mut state, &corner);
    // Joint 1 cannot lose more than 2 rad/s² times 1 ms, so whatever f is, it is 0.998 rad/s away from the ray.
    assert!(matches!(command.keeping, PathKeeping::LeavesPath { excess } if (excess - 0.998).abs() < 1e-12));
    assert_eq!(command.joint_speed[0], 1.0 + TS * -2.0);
    // No factor brings it nearer: the reference stands, and so does joint 2.
    assert_eq!((command.factor, command.joint_speed[1]), (0.0, 0.0));
    Ok(())
}

#[test]
fn a_joint_that_must_not_slow_down_pulls_the_reference_along() -> Result<(), ParameterError> {
    let regulator = AccelerationRegulator::new(settings::<1>(1.0, 2.0)?)?;
    let mut state = AccelerationState::moving(0.2, [1.0], &SpeedLimits::symmetric([1.0])?)?;
    // The path speed falls to half: the factor must double, far above what the filter allows.
    let command = regulator.step(&mut state, &AffineSpeed { feedback: [0.0], feedforward: [2.5] });
    assert_eq!(command.keeping, PathKeeping::OnPath);
    assert!((command.factor - 0.998 / 2.5).abs() < 1e-12 && command.switch > 1.0);
    Ok(())
}

#[test]
fn while_the_robot_approaches_from_afar_the_reference_stands() -> Result<(), ParameterError> {
    let regulator = AccelerationRegulator::new(settings::<2>(1.0, 2.0)?)?;
    let mut state = AccelerationState::at_rest();
    let desired = AffineSpeed { feedback: [3.0, 0.5], feedforward: [-4.0, 1.0] };
    let command = regulator.step(&mut state, &desired);
    assert_eq!((command.factor, command.path_rate), (0.0, 0.0));
    assert_eq!(command.joint_speed, [TS * 2.0; 2]);
    Ok(())
}

/// Closes an error of 1 rad with `q̇ = Kp e`; how far the joint goes beyond.
fn overshoot(gain: f64, recovery: Recovery) -> Result<f64, ParameterError> {
    let regulator = AccelerationRegulator::new(AccelerationSettings { recovery, ..settings::<1>(1.0, 2.0)? })?;
    let (mut state, mut error, mut beyond) = (AccelerationState::at_rest(), 1.0, 0.0_f64);
    for _ in 0..20_000 {
        let command = regulator.step(&mut state, &AffineSpeed { feedback: [gain * error], feedforward: [0.0] });
        error -= TS * command.joint_speed[0];
        beyond = beyond.max(-error);
    }
    assert!(error.abs() < 1e-6, "{error}");
    Ok(beyond)
}

#[test]
fn a_gain_up_to_deceleration_over_speed_does_not_overshoot_and_a_larger_one_does() -> Result<(), ParameterError> {
    // Kp · 1 rad/s <= 2 rad/s².
    assert!(overshoot(2.0, Recovery::AsDemanded)? <= 1e-15);
    assert!(overshoot(10.0, Recovery::AsDemanded)? > 1e-3);
    Ok(())
}

#[test]
fn feedback_slowed_to_what_can_be_braked_from_does_not_overshoot() -> Result<(), ParameterError> {
    for gain in [2.0, 10.0, 100.0, 500.0] {
        assert!(overshoot(gain, Recovery::Braking { gain })? <= 1e-15, "gain {gain}");
    }
    Ok(())
}

#[test]
fn parameters_out_of_range_are_refused_with_their_value() -> Result<(), ParameterError> {
    let good = settings::<1>(1.0, 2.0)?;
    let with = |recovery| AccelerationRegulator::new(AccelerationSettings { recovery, ..good });
    assert_eq!(with(Recovery::Braking { gain: 501.0 }).err(), Some(ParameterError::GainStep { step: 0.501 }));
    assert_eq!(with(Recovery::Braking { gain: 0.0 }).err(), Some(ParameterError::Gain(0.0)));
    let limits = AccelerationLimits::new([0.0], [1.0]);
    assert_eq!(limits.err(), Some(ParameterError::LowerAcceleration { joint: 0, value: 0.0 }));
    let state = AccelerationState::moving(0.0, [1.5], &good.speed_limits);
    assert_eq!(state.err(), Some(ParameterError::Speed { joint: 0, value: 1.5 }));
    Ok(())
}

fn inside(command: &AccelerationCommand<3>, before: &[f64; 3], settings: &AccelerationSettings<3>) -> bool {
    let (speeds, accelerations) = (&settings.speed_limits, &settings.acceleration_limits);
    let changes = command.joint_speed.iter().zip(before).zip(accelerations.lower().iter().zip(accelerations.upper()));
    // p + Ts a rounds twice and the difference here once, each relative to a number of at most |p| + Ts |a|.
    let keeps = |((c, p), (lo, up)): ((&f64, &f64), (&f64, &f64))| {
        let slack = 2.0 * f64::EPSILON * (p.abs() + c.abs());
        TS * lo - slack <= c - p && c - p <= TS * up + slack
    };
    speeds.contain(&command.joint_speed) && changes.into_iter().all(keeps)
}

proptest! {
    #[test]
    fn a_demand_that_is_not_finite_brakes_within_the_acceleration_limits(
        speed in proptest::array::uniform3(-1.0..1.0),
        bad in prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(f64::NEG_INFINITY)],
        joint in 0..3_usize,
    ) {
        let settings = settings::<3>(1.0, 2.0)?;
        let regulator = AccelerationRegulator::new(settings)?;
        let mut state = AccelerationState::moving(0.7, speed, &settings.speed_limits)?;
        let mut demand = AffineSpeed { feedback: [0.1; 3], feedforward: [0.3; 3] };
        demand.feedforward[joint] = bad;
        let command = regulator.step(&mut state, &demand);
        prop_assert!(command.keeping == PathKeeping::Brakes && command.path_rate == 0.0);
        prop_assert!(inside(&command, &speed, &settings));
        for (c, p) in command.joint_speed.iter().zip(&speed) {
            prop_assert!((c.abs() - (p.abs() - 2.0 * TS).max(0.0)).abs() <= f64::EPSILON);
        }
    }

    #[test]
    fn speeds_and_accelerations_stay_inside_for_any_run_of_demands(
        demands in proptest::collection::vec(
            (proptest::array::uniform3(prop_oneof![any::<f64>(), -3.0..3.0]), proptest::array::uniform3(-10.0..10.0), any::<f64>()),
            1..40,
        ),
        gain in 1.0..400.0,
    ) {
        let settings = AccelerationSettings { recovery: Recovery::Braking { gain }, ..settings::<3>(1.0, 2.0)? };
        let regulator = AccelerationRegulator::new(settings)?;
        let mut state = AccelerationState::at_rest();
        for (feedback, feedforward, ceiling) in demands {
            let before = *state.joint_speed();
            let command = regulator.step_below(&mut state, &AffineSpeed { feedback, feedforward }, ceiling);
            prop_assert!(inside(&command, &before, &settings), "{command:?} after {before:?}");
            prop_assert!((0.0..=1.0).contains(&command.factor));
        }
    }
}
