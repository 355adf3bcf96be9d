use proptest::prelude::{prop_assert, proptest};
use slideway_conditioner::acceleration::{AccelerationLimits, AccelerationState, PathKeeping};
use slideway_conditioner::{AffineSpeed, SpeedLimits};
use slideway_proofs::acceleration_factor::CLAIM;

use crate::acceleration_box::regulator;
use crate::support::{Outcome, TS, config, counterexample, filter, filter_step, joints, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The path goes on without a joint that moves at `speed`.
fn path_is_left(speed: f64) -> Outcome {
    let limits = SpeedLimits::symmetric([1.0, 1.0])?;
    let regulator = regulator(limits, AccelerationLimits::symmetric([2.0, 2.0])?, 0.1)?;
    let mut state = AccelerationState::moving(0.5, [speed, 0.0], &limits)?;
    let command = regulator.step(&mut state, &AffineSpeed { feedback: [0.0; 2], feedforward: [0.0, 1.0] });
    assert!(matches!(command.keeping, PathKeeping::LeavesPath { .. }), "{command:?}");
    Ok(())
}

#[test]
fn a_path_that_goes_on_without_a_moving_joint_is_left() -> Outcome {
    path_is_left(-0.9)?;
    path_is_left(counterexample(&CLAIM, "reachable-ray")?.value("p")?)
}

proptest! {
    #![proptest_config(config())]

    // A previous command near the demand at some factor, so that the ray meets the box.
    #[test]
    fn a_reachable_ray_is_kept_with_the_largest_factor_that_limits_and_filter_allow(
        feedback in joints::<3>(-0.3..0.3),
        feedforward in joints::<3>(-0.6..0.6),
        near in 0.0..=1.0,
        shares in joints::<3>(-0.999..0.999),
        before in 0.0..=1.0,
        a in filter_step(),
    ) {
        let limits = SpeedLimits::symmetric([1.0; 3])?;
        let regulator = regulator(limits, AccelerationLimits::symmetric([2.0; 3])?, a)?;
        let desired = AffineSpeed { feedback, feedforward };
        let mut speed = desired.at(near);
        for (v, share) in speed.iter_mut().zip(&shares) {
            *v += 2.0 * TS * share;
        }
        let mut state = AccelerationState::moving(before, speed, &limits)?;
        let command = regulator.step(&mut state, &desired);
        prop_assert!(command.keeping == PathKeeping::OnPath, "{command:?}");
        let risen = filter(a)?.next(before, 1.0);
        // A millionth above it no factor is both allowed by the filter and reachable; a millionth of B is far above rounding.
        let above = command.factor + 1e-6;
        let reaches = |factor: f64| desired.at(factor).iter().zip(&speed).all(|(v, p)| (v - p).abs() <= 2.0 * TS && v.abs() <= 1.0);
        let size = feedforward.iter().fold(0.0_f64, |s, b| s.max(b.abs()));
        prop_assert!(above > risen.min(1.0) || size < 1e-6 || !reaches(above) || !reaches(command.factor), "{command:?}");
    }
}
