use proptest::prelude::{prop_assert, prop_assume, proptest};
use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::bounds::band;
use slideway_conditioner::path::{Constraint, Motion, PathOutcome};
use slideway_conditioner::shapes::HalfSpace;
use slideway_proofs::path_band::CLAIM;

use crate::path_support::{APPROACH, Held, PERIOD, explicit, per_push, runs, settings, sketch, swing};
use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// `φ` one sample later, from a conditioner that starts on its reference with `φ`. A jump of the reference is the drift.
fn next_phi(phi: f64, drift: f64, push: f64) -> Result<f64, Box<dyn std::error::Error>> {
    let conditioner = PathConditioner::<1, 1>::new(settings(explicit(push / per_push())))?;
    let wall = HalfSpace::new(&[1.0], 0.0)?;
    let mut state = conditioner.on_reference();
    let mut at = |place: f64| {
        let reference = Motion { time: 0.0, position: [place], velocity: [0.0] };
        conditioner.step(&mut state, &reference, |m| [wall.sample(m)]).phi[0]
    };
    assert_eq!(at(phi), phi);
    Ok(at(phi + drift))
}

#[test]
fn a_drift_that_beats_the_push_leaves_the_band() -> Outcome {
    assert!(next_phi(0.25, 0.5, 0.125)? > band(0.125, 0.0, 0.5).upper + 0.1);
    let model = counterexample(&CLAIM, "push-beating-drift")?;
    let (phi, push) = (model.value("phi")?, model.value("G")?);
    assert!(next_phi(phi, model.value("D")?, push)? > band(push, 0.0, model.value("Dmax")?).upper + 0.04);
    Ok(())
}

#[test]
fn a_falling_drift_leaves_the_lower_end() -> Outcome {
    assert!(next_phi(-0.4, -0.5, 0.5)? < band(0.5, -0.125, 0.0).lower - 0.1);
    let model = counterexample(&CLAIM, "rising-drift")?;
    let (push, smallest) = (model.value("G")?, model.value("Dmin")?);
    let next = next_phi(model.value("phi")?, model.value("D")?, push)?;
    assert!(next < band(push, smallest, 0.0).lower - 0.04, "{next}");
    Ok(())
}

proptest! {
    #![proptest_config(runs())]

    // Rounding: 200 samples of 30 operations on numbers up to 10, which the decaying filter does not add up: 200 * 1e-15 is
    // generous.
    #[test]
    fn a_run_of_any_drifts_keeps_the_band(
        push in 0.1..2.0,
        drifts in proptest::collection::vec(0.0..1.0_f64, 2..200),
    ) {
        let conditioner = PathConditioner::<1, 1>::new(settings(explicit(push / per_push())))?;
        let wall = HalfSpace::new(&[1.0], 0.0)?;
        let largest = drifts.iter().fold(0.0_f64, |a, b| a.max(*b)) * push;
        let smallest = drifts.iter().fold(1.0_f64, |a, b| a.min(*b)) * push;
        let band = band(push, smallest, largest);
        let mut state = conditioner.on_reference();
        // The twin tells what the filter does without a push; the reference is put where the drift is the wanted one.
        let (mut twin, mut phi, mut first) = (Held::REST, 0.0_f64, true);
        for drift in drifts {
            let free = if first { phi } else { phi + drift * push };
            let rest = twin.after(0.0);
            let place = free - rest.place - APPROACH * rest.rate;
            let reference = Motion { time: 0.0, position: [place], velocity: [0.0] };
            let step = conditioner.step(&mut state, &reference, |m| [wall.sample(m)]);
            let expected = if first || phi < 0.0 { free } else { free - push };
            prop_assert!((step.phi[0] - expected).abs() <= 2e-13, "{} {expected}", step.phi[0]);
            if !first {
                // The state at this sample: what the last push made of the last one.
                twin = twin.after(if phi >= 0.0 { -push / per_push() } else { 0.0 });
            }
            phi = step.phi[0];
            first = false;
            prop_assert!(phi <= band.upper + 2e-13 && phi >= band.lower - 2e-13, "{phi} {band:?}");
        }
    }

    // Walls and balls, swinging references: drift and push of every sample as the twin measures them. Rounding as above.
    #[test]
    fn on_walls_and_balls_phi_stays_below_the_largest_drift(swing in swing(), sketch in sketch(3), amplitude in 0.5..3.0) {
        let body = sketch.around(&swing.at(0));
        prop_assume!(body.is_some());
        let body = body.expect("assumed");
        let conditioner = PathConditioner::<3, 1>::new(settings(explicit(amplitude)))?;
        let mut state = conditioner.on_reference();
        let (mut twin, mut push) = ([Held::REST; 3], [0.0; 3]);
        let (mut before, mut largest) = (f64::NEG_INFINITY, 0.0_f64);
        for k in 0..600 {
            let reference = swing.at(k);
            let step = conditioner.step(&mut state, &reference, |m| [body.sample(m)]);
            prop_assert!(!matches!(step.outcome, PathOutcome::Held(_)));
            let free = twin.map(|x| if k == 0 { x } else { x.after(0.0) });
            twin = std::array::from_fn(|i| if k == 0 { twin[i] } else { twin[i].after(push[i]) });
            let motion = Motion {
                time: PERIOD * f64::from(k),
                position: std::array::from_fn(|i| reference.position[i] + free[i].place),
                velocity: std::array::from_fn(|i| reference.velocity[i] + free[i].rate),
            };
            let unpushed = body.sample(&motion).phi(APPROACH, &motion.velocity);
            let (drift, felt) = (unpushed - before, unpushed - step.phi[0]);
            // The hypothesis D <= G; a push that loses ends the run.
            if before >= 0.0 && drift > felt {
                break;
            }
            if k > 0 {
                largest = largest.max(drift);
                prop_assert!(step.phi[0] <= largest + 2e-13, "{} {largest} at {k}", step.phi[0]);
            }
            (before, push) = (step.phi[0], step.push);
        }
    }
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
