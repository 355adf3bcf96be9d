use proptest::prelude::{prop_assert, prop_assume, proptest};
use slideway_conditioner::{AffineSpeed, ImplicitSpeedRegulator, SpeedLimits, SpeedState};
use slideway_proofs::never_slower::CLAIM;
use slideway_robot::augmented::null_vector;

use crate::natural_support::regular;
use crate::support::{Outcome, config, counterexample, limits, proven, settings};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The first sample from rest, with a limit of 1 rad/s.
fn rising_filter_is_slower(v: f64, target: f64, a: f64, natural: f64) -> Outcome {
    let regulator = ImplicitSpeedRegulator::new(settings(SpeedLimits::symmetric([1.0])?, a, target))?;
    let desired = AffineSpeed { feedback: [0.0], feedforward: [v * target] };
    let rate = regulator.step(&mut SpeedState::at_rest(), &desired).path_rate;
    // The solver's decimals are cut at 1e-20.
    assert!(natural * v <= 1.0 + 1e-15 && natural <= target + 1e-15);
    assert!(rate < natural - 0.05, "{rate} {natural}");
    Ok(())
}

#[test]
fn while_the_filter_rises_natural_motion_is_faster() -> Outcome {
    rising_filter_is_slower(0.5, 4.0, 0.125, 1.5)?;
    let model = counterexample(&CLAIM, "settled-filter")?;
    let value = |name| model.value(name);
    rising_filter_is_slower(value("v")?, value("d")?, value("a")?, value("s")?)
}

proptest! {
    #![proptest_config(config())]

    // Natural motion of a random system of three joints, b as large as the limits allow times `share`; the shipped implicit
    // form at the same place, 200 samples after rest. With a >= 0.2 the filter has risen to 1 - 0.8^200 = 1 - 4e-20: settled.
    // Roundings: some ten of 1e-16 in each of the two rates, times the condition of n / det J, which is the share of the
    // determinant in the null vector and cancels: both take the same quotient.
    #[test]
    fn regulated_path_rate_is_no_lower_than_that_of_natural_motion(
        system in regular::<3>(),
        limits in limits::<3>(-2.0..2.0),
        share in 0.0..=1.0_f64,
        a in 0.2..=1.0,
        headroom in 1.0..100.0_f64,
    ) {
        let null = null_vector(&system.jacobian, &system.tangent);
        prop_assume!(null.path.abs() > 1e-9 * system.volume());
        let unit = null.scaled(null.path.signum());
        let speeds: [f64; 3] = unit.joints.into();
        let natural_b = share / limits.ratio(&speeds);
        let natural: f64 = natural_b * unit.path;
        let target = headroom * natural.max(1e-6);
        let regulator = ImplicitSpeedRegulator::new(settings(limits, a, target))?;
        let per_rate = unit.joints / unit.path;
        let desired = AffineSpeed { feedback: [0.0; 3], feedforward: (per_rate * target).into() };
        let mut state = SpeedState::at_rest();
        let mut rate = 0.0;
        for _ in 0..200 {
            rate = regulator.step(&mut state, &desired).path_rate;
        }
        prop_assert!(rate >= natural * (1.0 - 20.0 * f64::EPSILON), "{rate} {natural}");
    }
}
