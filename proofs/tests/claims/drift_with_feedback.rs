use slideway_conditioner::bounds::{FeedbackBand, FeedbackLoop, drifting_band_with_feedback};
use slideway_conditioner::{Advance, SpeedLimits, SpeedRegulator, SpeedState};
use slideway_proofs::drift_with_feedback::CLAIM;

use crate::support::{Outcome, TS, counterexample, holds, proven, settings};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// One joint on a straight path, on its reference at first.
fn straight(gain_step: f64, g: f64) -> FeedbackLoop {
    FeedbackLoop {
        filter_step: 0.1,
        gain: gain_step / TS,
        sampling_period: TS,
        target_rate: g,
        path_rate_max: 1.0,
        overspeed_max: g,
        curvature: 0.0,
        initial_lag: 0.0,
    }
}

/// The lag after one sample, in limits: nothing in the synchronised form, `κ (1 - fdir) g f` in the published one.
fn only_waiting_keeps_the_lag(gain_step: f64, g: f64, f: f64) -> Outcome {
    let band = drifting_band_with_feedback(&straight(gain_step, g)).ok_or("parameters in range")?;
    let lag = |advance| -> Result<f64, Box<dyn std::error::Error>> {
        let mut settings = settings(SpeedLimits::symmetric([1.0])?, 0.1, g);
        settings.advance = advance;
        let regulator = SpeedRegulator::new(settings)?;
        let mut state = SpeedState::moving(f)?;
        let desired = [regulator.requested_rate(&state)];
        let command = regulator.step(&mut state, &desired);
        Ok(gain_step * (command.path_rate - command.joint_speed[0]))
    };
    // Two roundings of numbers up to 4.
    assert!(lag(Advance::Synchronised)?.abs() <= band.lag + 1e-15);
    assert!(lag(Advance::Paper)? > band.lag + 0.05);
    Ok(())
}

#[test]
fn in_the_published_advance_a_saturated_sample_feeds_the_lag() -> Outcome {
    only_waiting_keeps_the_lag(0.5, 2.0, 0.75)?;
    let model = counterexample(&CLAIM, "synchronised-advance")?;
    only_waiting_keeps_the_lag(model.value("k")?, model.value("g")?, model.value("f")?)
}

/// At rest, with a lag of `x` limits: the robot jumps to the other side of its reference, further off than it was.
fn large_gain_grows_the_lag(gain_step: f64, x: f64) -> Outcome {
    let regulator = SpeedRegulator::new(settings(SpeedLimits::symmetric([1.0])?, 0.1, 1.0))?;
    let gain = gain_step / TS;
    let lag = x / gain;
    let command = regulator.step(&mut SpeedState::at_rest(), &[gain * lag]);
    let after = lag - TS * command.joint_speed[0];
    assert!(after.abs() > 1.01 * lag.abs(), "{after} {lag}");
    assert_eq!(drifting_band_with_feedback(&straight(gain_step, 1.0)), None);
    Ok(())
}

#[test]
fn a_gain_above_the_sampling_rate_grows_the_lag_and_is_refused() -> Outcome {
    large_gain_grows_the_lag(3.0, 0.25)?;
    let model = counterexample(&CLAIM, "gain-below-rate")?;
    large_gain_grows_the_lag(model.value("k")?, model.value("x")?)
}

#[test]
fn without_curvature_and_error_the_band_is_the_frozen_one() -> Outcome {
    let band = drifting_band_with_feedback(&straight(0.0, 3.0)).ok_or("parameters in range")?;
    let frozen = slideway_conditioner::bounds::frozen_band(0.1, 3.0);
    // The function adds a part in 1e13.
    assert!((band.limit_ratio - frozen).abs() <= 2e-13 * frozen && band.lag == 0.0, "{band:?} {frozen}");
    Ok(())
}

#[test]
fn what_is_out_of_range_or_no_number_has_no_band() {
    let spoil: [fn(&mut FeedbackLoop); 8] = [
        |s| s.filter_step = f64::NAN,
        |s| s.filter_step = 1.5,
        |s| s.gain = -1.0,
        |s| s.sampling_period = 0.0,
        |s| s.target_rate = f64::NAN,
        |s| s.path_rate_max = 0.0,
        |s| s.curvature = f64::NAN,
        |s| s.initial_lag = -0.1,
    ];
    for spoil in spoil {
        let mut system = straight(0.5, 2.0);
        spoil(&mut system);
        assert_eq!(drifting_band_with_feedback(&system), None::<FeedbackBand>, "{system:?}");
    }
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
