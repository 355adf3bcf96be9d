use proptest::prelude::{any, prop_assert, prop_oneof, proptest};
use slideway_conditioner::{
    AffineSpeed, ImplicitSpeedRegulator, Saturation, SpeedLimits, SpeedRegulator, SpeedSettings, SpeedState,
};
use slideway_proofs::command_within_limits::CLAIM;

use crate::support::{Outcome, TS, advance, config, counterexample, filter_step, joints, limits, proven, saturation};

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

proptest! {
    #![proptest_config(config())]

    // No slack anywhere: the claim is exact. Limits from 1e-300 to 1e300, speeds of every bit pattern, so ratios that
    // overflow and underflow are among the cases.
    #[test]
    fn every_command_lies_inside_the_limits(
        limits in prop_oneof![limits::<3>(-300.0..300.0), limits::<3>(-2.0..2.0)],
        a in filter_step(),
        start in 0.0..=1.0,
        saturation in saturation(),
        advance in advance(),
        feedback in prop_oneof![joints::<3>(any::<f64>()), joints::<3>(-100.0..100.0)],
        feedforward in prop_oneof![joints::<3>(any::<f64>()), joints::<3>(-100.0..100.0)],
    ) {
        let settings =
            SpeedSettings { limits, sampling_period: TS, bandwidth: a / TS, target_rate: 5.0, saturation, advance };
        let explicit = SpeedRegulator::new(settings)?.step(&mut SpeedState::moving(start)?, &feedback);
        let desired = AffineSpeed { feedback, feedforward };
        let implicit = ImplicitSpeedRegulator::new(settings)?.step(&mut SpeedState::moving(start)?, &desired);
        for command in [explicit, implicit] {
            prop_assert!(limits.contain(&command.joint_speed), "{:?}", command.joint_speed);
            prop_assert!((0.0..=1.0).contains(&command.direction_factor));
            prop_assert!((0.0..=5.0).contains(&command.path_rate));
        }
    }

    // The switch and the ratio agree to the bit. A quotient of at most 1 rounds to at most 1. The next double beyond a limit
    // of 2^k s, 1 <= s < 2, is larger by a relative 2^-52 / s, more than half a unit in the last place of 1, so that quotient
    // rounds to more than 1. (Normal limits only.)
    #[test]
    fn inside_the_limits_is_a_ratio_of_at_most_one(
        limits in limits::<1>(-3.0..3.0),
        neighbours in -4_i64..=4,
        backwards in any::<bool>(),
    ) {
        let limit = if backwards { limits.lower() } else { limits.upper() };
        let speed = limit.map(|limit| f64::from_bits(limit.to_bits().wrapping_add_signed(neighbours)));
        prop_assert!(limits.contain(&speed) == (limits.ratio(&speed) <= 1.0));
    }
}
