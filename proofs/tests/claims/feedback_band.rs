use slideway_conditioner::bounds::frozen_band_with_feedback;
use slideway_conditioner::{Advance, SpeedLimits, SpeedRegulator, SpeedState};
use slideway_proofs::feedback_band::CLAIM;

use crate::support::{Outcome, TS, counterexample, holds, proven, settings};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// Largest use of the limit in two samples on a frozen path, one joint, synchronised advance; `x` is the feedback at first.
fn ratios(a: f64, gain_step: f64, g: f64, x: f64, f: f64) -> Result<[f64; 2], Box<dyn std::error::Error>> {
    let mut settings = settings(SpeedLimits::symmetric([1.0])?, a, g);
    settings.advance = Advance::Synchronised;
    let regulator = SpeedRegulator::new(settings)?;
    let mut state = SpeedState::moving(f)?;
    let gain = gain_step / TS;
    let mut lag = x / gain;
    Ok([0, 1].map(|_| {
        let desired = [regulator.requested_rate(&state) + gain * lag];
        let command = regulator.step(&mut state, &desired);
        lag += TS * (command.path_rate - command.joint_speed[0]);
        command.limit_ratio
    }))
}

fn opposing_feedback_leaves_the_band(a: f64, gain_step: f64, g: f64, x: f64, f: f64) -> Outcome {
    let band = frozen_band_with_feedback(a, g, gain_step).ok_or("a gain below the bandwidth")?;
    let [first, second] = ratios(a, gain_step, g, x, f)?;
    assert!(x < 0.0 && first <= band && second > band + 0.05, "{first} {second} {band}");
    Ok(())
}

#[test]
fn feedback_that_opposes_the_feedforward_leaves_the_band() -> Outcome {
    opposing_feedback_leaves_the_band(0.5, 0.25, 2.0, -2.75, 0.5)?;
    let model = counterexample(&CLAIM, "trailing")?;
    let value = |name| model.value(name);
    opposing_feedback_leaves_the_band(value("a")?, value("k")?, value("g")?, value("x")?, value("f")?)
}

/// Feedback faster than the filter leaves the band that the formula gives, and the shipped function refuses to give one.
fn fast_feedback_leaves_the_band(a: f64, gain_step: f64, g: f64, x: f64, f: f64) -> Outcome {
    let [first, second] = ratios(a, gain_step, g, x, f)?;
    assert!(first <= 1.0 && second > 1.0 + a * g - gain_step + 0.05, "{first} {second}");
    assert_eq!(frozen_band_with_feedback(a, g, gain_step), None);
    Ok(())
}

#[test]
fn a_gain_above_the_bandwidth_leaves_the_band_and_is_refused() -> Outcome {
    fast_feedback_leaves_the_band(0.5, 0.75, 2.0, 0.4375, 0.25)?;
    let model = counterexample(&CLAIM, "fast-filter")?;
    let value = |name| model.value(name);
    fast_feedback_leaves_the_band(value("a")?, value("k")?, value("g")?, value("x")?, value("f")?)
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
