use proptest::prelude::{prop_assert, prop_assume, proptest};
use slideway_conditioner::path::{PathOutcome, PathQuantity};
use slideway_conditioner::{ParameterError, PathConditioner};
use slideway_proofs::path_lag::CLAIM;

use crate::path_support::{Suprema, explicit, implicit, runs, settings, sketch, swing};
use crate::support::{Outcome, config, counterexample, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// `e = exp(-T / K)`, and the conditioner's verdict on that `K`.
fn memory_of_a_negative_approach_is_refused(e: f64, sigma: f64, mean: f64, m: f64) {
    assert!(sigma <= m && mean <= m && e * sigma + (1.0 - e) * mean > m + 0.04);
    let mut settings = settings::<1>(implicit());
    settings.approach = [-settings.sampling_period / e.ln()];
    let refused = PathConditioner::<3, 1>::new(settings);
    let quantity = PathQuantity::Approach(0);
    assert_eq!(refused, Err(ParameterError::Path { quantity, value: settings.approach[0] }));
}

#[test]
fn without_a_positive_approach_time_it_is_no_lag_and_the_conditioner_refuses_it() -> Outcome {
    memory_of_a_negative_approach_is_refused(1.5, 0.0, -1.0, 0.0);
    let model = counterexample(&CLAIM, "approach")?;
    let value = |name| model.value(name);
    memory_of_a_negative_approach_is_refused(value("e")?, value("sigma")?, value("mean")?, value("m")?);
    Ok(())
}

proptest! {
    #![proptest_config(config())]

    // One rounding of a number up to 2 per sample, 200 samples.
    #[test]
    fn a_lag_of_held_values_stays_below_the_largest(
        values in proptest::collection::vec(-1.0..1.0_f64, 1..200),
        rate in 0.001..2.0_f64,
    ) {
        let memory = (-rate).exp();
        let (mut sigma, mut largest) = (-1.0_f64, f64::NEG_INFINITY);
        for &phi in &values {
            largest = largest.max(phi);
            sigma += (1.0 - memory) * (phi - sigma);
            prop_assert!(sigma <= largest + 1e-13);
        }
    }
}

proptest! {
    #![proptest_config(runs())]

    // The explicit form on one wall or ball, pushes that suffice and pushes that do not. What φ does between samples is
    // bounded by the motion itself; rounding, 1e-12, is nothing beside it.
    #[test]
    fn sigma_never_exceeds_the_largest_phi(swing in swing(), sketch in sketch(3), amplitude in 0.02..3.0) {
        let body = sketch.around(&swing.at(0));
        prop_assume!(body.is_some());
        let body = body.expect("assumed");
        let conditioner = PathConditioner::<3, 1>::new(settings(explicit(amplitude)))?;
        let mut state = conditioner.on_reference();
        let (mut suprema, mut largest, mut closest) = (Suprema::default(), f64::NEG_INFINITY, f64::INFINITY);
        for k in 0..1000 {
            let reference = swing.at(k);
            let step = conditioner.step(&mut state, &reference, |m| [body.sample(m)]);
            // Next to the centre of a ball the derivatives have no useful bound.
            closest = body.radius(step.sigma[0]).min(closest);
            if matches!(step.outcome, PathOutcome::Held(_)) || closest < 0.02 {
                break;
            }
            let rate = std::array::from_fn(|i| step.motion.velocity[i] - reference.velocity[i]);
            suprema.see(&swing, &step.correction, &rate, &step.push);
            largest = if k == 0 { step.sigma[0] } else { largest }.max(step.phi[0]);
            let bulge = suprema.bulge(1.0 / closest);
            prop_assert!(step.sigma[0] <= largest + bulge, "{} {largest} at {k}", step.sigma[0]);
        }
    }
}
