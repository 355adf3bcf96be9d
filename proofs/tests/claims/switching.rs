use proptest::prelude::{Just, any, prop_assert, prop_assert_eq, proptest};
use proptest::strategy::Strategy;
use slideway_conditioner::bounds::switches_by;
use slideway_conditioner::{SpeedRegulator, SpeedState};
use slideway_proofs::switching::CLAIM;

use crate::support::{
    Outcome, Proportional, config, counterexample, filter_step, proportional, proven, settings, unit_joint,
};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// Runs four samples on a frozen path that eq 21 calls fast enough.
fn never_switches(a: f64, g: f64, f0: f64) -> Outcome {
    assert!(g >= 1.0, "eq 21 holds");
    let regulator = unit_joint(a, g)?;
    let mut state = SpeedState::moving(f0)?;
    for sample in 0..4 {
        let desired = [regulator.requested_rate(&state)];
        assert_eq!(regulator.step(&mut state, &desired).switch, 1.0);
        assert!(!switches_by(a, g, f0, sample));
    }
    Ok(())
}

#[test]
fn eq_21_does_not_make_the_switch_act() -> Outcome {
    never_switches(0.5, 1.109_375, 0.125)?;
    let model = counterexample(&CLAIM, "enough-samples")?;
    never_switches(model.value("a")?, model.value("g")?, model.value("f0")?)
}

#[test]
fn the_criterion_answers_for_the_first_sample_with_a_step_of_one() {
    assert!(switches_by(1.0, 2.0, 0.9, 0));
    assert!(!switches_by(1.0, 2.0, 0.5, 0));
    assert!(switches_by(1.0, 2.0, 0.0, 1));
}

/// The first sample with `u = 0` among the first `samples`.
fn first_brake(
    regulator: &SpeedRegulator<2>,
    arm: &Proportional<2>,
    start: f64,
    samples: u32,
) -> Result<Option<u32>, slideway_conditioner::ParameterError> {
    let mut state = SpeedState::moving(start)?;
    for sample in 0..samples {
        let desired = arm.at(regulator.requested_rate(&state));
        if regulator.step(&mut state, &desired).switch == 0.0 {
            return Ok(Some(sample));
        }
    }
    Ok(None)
}

/// A filter step, a start, the sample to switch at and the overspeed that does it.
#[derive(Clone, Copy, Debug)]
struct Planned {
    a: f64,
    start: f64,
    sample: u32,
    g: f64,
}

/// Puts the threshold `1 / g` between the factors of two consecutive samples, off both ends by a hundredth of the gap.
fn planned() -> impl Strategy<Value = Planned> {
    (1e-3..0.6, 0.0..0.9, 1_u32..60, 0.01..0.99).prop_flat_map(|(a, start, latest, place): (f64, f64, u32, f64)| {
        // Past `a k = 12` the factors of neighbouring samples are closer than rounding lets one tell.
        let sample = latest.min((12.0 / a) as u32).max(1);
        let factor = |k: u32| 1.0 - (1.0 - start) * (1.0 - a).powi(k.cast_signed());
        let threshold = factor(sample - 1) + place * (factor(sample) - factor(sample - 1));
        Just(Planned { a, start, sample, g: 1.0 / threshold })
    })
}

proptest! {
    #![proptest_config(config())]

    // The gap between neighbouring factors is (1 - f0) a (1 - a)^(k-1) >= 0.1 * 1e-3 * 0.4^20 = 1e-12 (for a = 0.6 the
    // cap is k = 20; (1 - a)^(12 / a) is smallest there), and a hundredth of it 1e-14. The factor's own rounding: each
    // sample adds at most 2 roundoffs and contracts what it inherits by 1 - a, so 2^-53 * 2 * min(k, 1/a) <= 1.4e-14 for
    // a = 1/60; there the gap is 0.1 * a * exp(-1) = 6e-4. At a = 0.6 it is 2^-53 * 4 = 4e-16 against 0.1 * 0.6 * 0.4^19
    // / 100 = 1.6e-11. The threshold is never in doubt.
    #[test]
    fn the_first_switch_falls_where_the_criterion_says(arm in proportional::<2>(), plan in planned()) {
        let regulator = SpeedRegulator::new(settings(arm.limits, plan.a, plan.g))?;
        prop_assert_eq!(first_brake(&regulator, &arm, plan.start, plan.sample + 1)?, Some(plan.sample));
        prop_assert!(!switches_by(plan.a, plan.g, plan.start, plan.sample - 1));
        prop_assert!(switches_by(plan.a, plan.g, plan.start, plan.sample));
    }

    // No slack: with g <= 1 and f <= 1 the products g f, limit (g f) round to at most 1 and the limit, because 1 and the
    // limit are doubles and rounding is monotonic.
    #[test]
    fn below_eq_21_and_at_equality_nothing_switches(
        arm in proportional::<2>(),
        a in filter_step(),
        start in 0.0..=1.0,
        below in 1e-3..=1.0,
        equal in any::<bool>(),
    ) {
        let g = if equal { 1.0 } else { below };
        let regulator = SpeedRegulator::new(settings(arm.limits, a, g))?;
        prop_assert_eq!(first_brake(&regulator, &arm, start, 50)?, None);
        prop_assert!(!switches_by(a, g, start, 50));
    }
}
