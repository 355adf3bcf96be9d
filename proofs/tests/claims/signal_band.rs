use slideway_conditioner::bounds::{SignalBand, Signals};
use slideway_conditioner::{AffineSpeed, SpeedLimits, SpeedState};
use slideway_proofs::signal_band::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven, unit_joint};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

#[test]
fn the_shipped_regulator_keeps_the_band_of_its_signals() -> Outcome {
    holds(&CLAIM)
}

/// Runs one joint with the limits -1 and 1 and gives its ratios and its signals.
fn run<const K: usize>(
    a: f64,
    f0: f64,
    demand: [(f64, f64); K],
) -> Result<([f64; K], Signals), Box<dyn std::error::Error>> {
    let limits = SpeedLimits::symmetric([1.0])?;
    let (regulator, mut state) = (unit_joint(a, 1.0)?, SpeedState::moving(f0)?);
    let mut band = SignalBand::new(a);
    let ratios = demand.map(|(feedback, feedforward)| {
        let split = AffineSpeed { feedback: [feedback], feedforward: [feedforward] };
        let factor = state.factor();
        let command = regulator.step(&mut state, &split.at(factor));
        band.update(&limits, &split, factor, command.switch);
        command.limit_ratio
    });
    Ok((ratios, band.signals()))
}

fn length_is_left_without_surplus(a: f64, f0: f64, g: [f64; 3]) -> Outcome {
    let ([m0, m1, m2], signals) = run(a, f0, g.map(|g| (0.0, g)))?;
    assert!(m0 <= 1.0 && m1 > 1.0, "{m0} {m1}");
    let without = Signals { surplus: 0.0, ..signals };
    assert!(m2 > without.feedforward_band(a) + 0.05 && m2 <= signals.feedforward_band(a), "{m2} {signals:?}");
    Ok(())
}

#[test]
fn without_the_surplus_the_band_by_length_is_left() -> Outcome {
    length_is_left_without_surplus(0.25, 0.5, [1.0, 2.0, 8.0])?;
    let model = counterexample(&CLAIM, "surplus")?;
    let g = [model.value("g0")?, model.value("g1")?, model.value("g2")?];
    length_is_left_without_surplus(model.value("a")?, model.value("f0")?, g)
}

fn length_is_left_without_feedback(a: f64, f0: f64, g: f64, e: f64) -> Outcome {
    let ([m0, m1], signals) = run(a, f0, [(-e, g), (e, g)])?;
    let without = Signals { feedback: 0.0, ..signals };
    assert!(m0 <= 1.0 && m1 > without.feedforward_band(a) + 0.05 && m1 <= signals.band(a), "{m0} {m1} {signals:?}");
    Ok(())
}

#[test]
fn without_the_feedback_the_band_by_length_is_left() -> Outcome {
    length_is_left_without_feedback(0.25, 0.5, 1.0, 0.5)?;
    let model = counterexample(&CLAIM, "feedback")?;
    length_is_left_without_feedback(model.value("a")?, model.value("f0")?, model.value("g")?, model.value("e")?)
}

fn vector_is_left_without_braked_change(a: f64, f0: f64, g: [f64; 3]) -> Outcome {
    let ([m0, m1, m2], signals) = run(a, f0, g.map(|g| (0.0, g)))?;
    assert!(m0 <= 1.0 && m1 > 1.0, "{m0} {m1}");
    let bound = 1.0 - a + signals.released_change + a * signals.overspeed;
    assert!(m2 > bound + 0.05 && m2 <= signals.braked_change / a, "{m2} {signals:?}");
    Ok(())
}

#[test]
fn without_the_change_while_braking_the_band_by_vector_is_left() -> Outcome {
    vector_is_left_without_braked_change(0.25, 0.5, [1.0, 3.0, 8.0])?;
    let model = counterexample(&CLAIM, "braked-change")?;
    let g = [model.value("g0")?, model.value("g1")?, model.value("g2")?];
    vector_is_left_without_braked_change(model.value("a")?, model.value("f0")?, g)
}

#[test]
fn a_number_that_is_none_leaves_no_band() -> Outcome {
    let limits = SpeedLimits::symmetric([1.0])?;
    for (feedback, feedforward) in [(f64::NAN, 1.0), (0.1, f64::NAN), (0.1, f64::INFINITY)] {
        let mut band = SignalBand::new(0.1);
        band.update(&limits, &AffineSpeed { feedback: [0.0], feedforward: [1.0] }, 0.5, 1.0);
        band.update(&limits, &AffineSpeed { feedback: [feedback], feedforward: [feedforward] }, 0.5, 0.0);
        assert_eq!(band.band(), f64::INFINITY, "{feedback} {feedforward}");
    }
    Ok(())
}
