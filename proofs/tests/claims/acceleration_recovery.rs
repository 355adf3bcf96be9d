use proptest::prelude::{prop_assert, proptest};
use slideway_conditioner::acceleration::{
    AccelerationLimits, AccelerationRegulator, AccelerationSettings, AccelerationState, Recovery,
};
use slideway_conditioner::{AffineSpeed, ParameterError, SpeedLimits};
use slideway_proofs::acceleration_recovery::CLAIM;

use crate::support::{Outcome, TS, config, counterexample, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

fn regulator(speed: f64, limits: [f64; 2], recovery: Recovery) -> Result<AccelerationRegulator<1>, ParameterError> {
    let [deceleration, acceleration] = limits;
    AccelerationRegulator::new(AccelerationSettings {
        speed_limits: SpeedLimits::symmetric([speed])?,
        acceleration_limits: AccelerationLimits::new([-deceleration], [acceleration])?,
        sampling_period: TS,
        bandwidth: 1.0,
        target_rate: 1.0,
        recovery,
    })
}

/// The error after one sample of `Kp Ts = 1` from the previous command `p = Kp e_before`.
fn passes_the_reference(deceleration: f64, p: f64) -> Outcome {
    let regulator = regulator(1.0, [deceleration, 1.0], Recovery::AsDemanded)?;
    let mut state = AccelerationState::moving(0.0, [p], &SpeedLimits::symmetric([1.0])?)?;
    // e_before = p / Kp = Ts p, all of which the previous command covers.
    let error = 0.0;
    let command = regulator.step(&mut state, &AffineSpeed { feedback: [error], feedforward: [0.0] });
    assert!(error - TS * command.joint_speed[0] < -2e-4, "{command:?}");
    Ok(())
}

#[test]
fn a_gain_beyond_deceleration_over_speed_passes_the_reference() -> Outcome {
    passes_the_reference(2.0, 0.9)?;
    let model = counterexample(&CLAIM, "moderate-gain")?;
    passes_the_reference(model.value("D")?, model.value("p")?)
}

/// Runs the loop from rest; the least error on the way.
fn least_error(regulator: &AccelerationRegulator<1>, gain: f64, mut error: f64) -> f64 {
    let mut state = AccelerationState::at_rest();
    let mut least = error;
    for _ in 0..400 {
        let desired = AffineSpeed { feedback: [gain * error], feedforward: [0.0] };
        error -= TS * regulator.step(&mut state, &desired).joint_speed[0];
        least = least.min(error);
    }
    least
}

proptest! {
    #![proptest_config(config())]

    // Rounding: of 400 errors of at most 1 each, 1e-13 in all.
    #[test]
    fn a_moderate_gain_never_passes_the_reference(
        error in 1e-3..1.0, speed in 0.05..2.0, share in 0.01..=1.0, deceleration in 0.5..200.0, acceleration in 0.5..200.0,
    ) {
        let moderate: f64 = deceleration / speed;
        let gain = share * moderate.min(1.0 / TS);
        let regulator = regulator(speed, [deceleration, acceleration], Recovery::AsDemanded)?;
        prop_assert!(least_error(&regulator, gain, error) >= -1e-13);
    }

    #[test]
    fn braking_feedback_never_passes_the_reference_at_any_gain(
        error in 1e-3..1.0, speed in 0.05..2.0, gain in 1.0..512.0, deceleration in 0.5..200.0, acceleration in 0.5..200.0,
    ) {
        let regulator = regulator(speed, [deceleration, acceleration], Recovery::Braking { gain })?;
        let least = least_error(&regulator, gain, error);
        prop_assert!(least >= -1e-13, "{least:e}");
    }
}
