use slideway_conditioner::{Saturation, SpeedLimits};
use slideway_proofs::command_within_limits::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model_over_doubles() -> Outcome {
    proven(&CLAIM)
}

/// Scaling by `1 / ratio` alone ends beyond the limit of 3 rad/s; the shipped saturation does not.
fn scaling_alone_exceeds_the_limit(speed: f64) -> Outcome {
    let limits = SpeedLimits::symmetric([3.0])?;
    let scaled = speed * (1.0 / limits.ratio(&[speed]));
    assert!(scaled > 3.0, "{scaled}");
    let saturated = limits.saturate(&[speed], Saturation::DirectionPreserving);
    assert!(limits.contain(&saturated.joint_speed));
    Ok(())
}

#[test]
fn scaling_without_the_clamp_exceeds_a_limit() -> Outcome {
    scaling_alone_exceeds_the_limit(f64::from_bits(0x4014_044b_e80f_22fb))?;
    scaling_alone_exceeds_the_limit(counterexample(&CLAIM, "clamp")?.value("speed")?)
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
