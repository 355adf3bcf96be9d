use proptest::prelude::{any, prop_assert, prop_oneof, proptest};
use slideway_conditioner::acceleration::{
    AccelerationLimits, AccelerationRegulator, AccelerationSettings, AccelerationState, Recovery,
};
use slideway_conditioner::{AffineSpeed, ParameterError, SpeedLimits};
use slideway_proofs::acceleration_box::CLAIM;

use crate::support::{Outcome, ROUNDOFF, TS, config, counterexample, filter_step, joints, limits, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

pub(crate) fn regulator<const N: usize>(
    speed_limits: SpeedLimits<N>,
    acceleration_limits: AccelerationLimits<N>,
    filter_step: f64,
) -> Result<AccelerationRegulator<N>, ParameterError> {
    AccelerationRegulator::new(AccelerationSettings {
        speed_limits,
        acceleration_limits,
        sampling_period: TS,
        bandwidth: filter_step / TS,
        target_rate: 5.0,
        recovery: Recovery::AsDemanded,
    })
}

/// A state made under wider speed limits: the narrower ones are kept at once, the acceleration limit cannot be.
fn acceleration_is_exceeded(before: f64) -> Outcome {
    let regulator = regulator(SpeedLimits::symmetric([1.0])?, AccelerationLimits::symmetric([2.0])?, 0.1)?;
    let mut state = AccelerationState::moving(0.0, [before], &SpeedLimits::symmetric([3.0])?)?;
    let command = regulator.step(&mut state, &AffineSpeed { feedback: [0.0], feedforward: [0.0] });
    let [speed] = command.joint_speed;
    assert!(speed.abs() <= 1.0 && (speed - before).abs() >= 4.0 * TS, "{speed} after {before}");
    Ok(())
}

#[test]
fn a_previous_command_beyond_the_speed_limits_exceeds_the_acceleration() -> Outcome {
    acceleration_is_exceeded(2.5)?;
    acceleration_is_exceeded(counterexample(&CLAIM, "previous-inside")?.value("p")?)
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn every_command_is_in_the_box(
        speeds in limits::<3>(-2.0..2.0),
        accelerations in limits::<3>(-2.0..3.0),
        places in joints::<3>(0.0..=1.0),
        start in 0.0..=1.0,
        a in filter_step(),
        feedback in prop_oneof![joints::<3>(any::<f64>()), joints::<3>(-10.0..10.0)],
        feedforward in prop_oneof![joints::<3>(any::<f64>()), joints::<3>(-10.0..10.0)],
        ceiling in any::<f64>(),
    ) {
        let mut before = places;
        for ((v, lo), up) in before.iter_mut().zip(speeds.lower()).zip(speeds.upper()) {
            *v = (lo + *v * (up - lo)).max(*lo).min(*up);
        }
        let acceleration_limits = AccelerationLimits::new(*accelerations.lower(), *accelerations.upper())?;
        let regulator = regulator(speeds, acceleration_limits, a)?;
        let mut state = AccelerationState::moving(start, before, &speeds)?;
        let command = regulator.step_below(&mut state, &AffineSpeed { feedback, feedforward }, ceiling);
        prop_assert!(speeds.contain(&command.joint_speed));
        let ends = accelerations.lower().iter().zip(accelerations.upper());
        for ((c, p), (lo, up)) in command.joint_speed.iter().zip(&before).zip(ends) {
            // The sum and the difference here round once each; TS is a power of two, so the product does not.
            let slack = 2.0 * ROUNDOFF * (c.abs() + p.abs() + TS * (up - lo));
            prop_assert!(TS * lo - slack <= c - p && c - p <= TS * up + slack, "{c} after {p}");
        }
        prop_assert!((0.0..=1.0).contains(&command.factor));
    }
}
