use slideway_conditioner::bounds::{Progress, ProgressForm, ProgressSums, TravelInputs, travel_bracket};
use slideway_conditioner::{Advance, AffineSpeed, SpeedLimits, SpeedRegulator, SpeedState};
use slideway_proofs::draw::{TS, settings};
use slideway_proofs::time_with_feedback::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

#[test]
fn the_shipped_regulator_keeps_the_bracket() -> Outcome {
    holds(&CLAIM)
}

/// A path of 20 samples at the largest admissible rate, the feedback opposing all along, the filter holding its factor.
fn bracket_is_left(f: f64, g: f64, e: f64) -> Outcome {
    let limits = SpeedLimits::symmetric([1.0])?;
    // So slow that the factor stays where it is.
    let settings = settings(limits, 1e-9, 1.0);
    let regulator =
        SpeedRegulator::new(slideway_conditioner::SpeedSettings { advance: Advance::Synchronised, ..settings })?;
    let mut state = SpeedState::moving(f)?;
    let demand = AffineSpeed { feedback: [-e], feedforward: [g] };
    let (mut progress, mut covered, mut samples) = (Progress::new(ProgressForm::Explicit, 1e-9), 0.0, 0.0);
    while covered < 20.0 {
        let factor = state.factor();
        let command = regulator.step(&mut state, &demand.at(factor));
        progress.update(&limits, &demand, factor, g);
        covered += command.path_rate * g;
        samples += 1.0;
    }
    let inputs =
        TravelInputs { sums: progress.sums(), optimum: [20.0 * TS; 2], period: TS, variation: 0.0, sample_drift: 0.0 };
    let blind = TravelInputs { sums: ProgressSums { feedback: 0.0, ..inputs.sums }, ..inputs };
    let [blind, honest] = [blind, inputs].map(|i| travel_bracket(&i).ok_or("finite numbers"));
    // The last sample is counted whole.
    let time = TS * samples;
    assert!(time < blind?[0] && time >= honest?[0] && time <= honest?[1] + TS, "{time}");
    Ok(())
}

#[test]
fn without_the_feedback_the_reference_beats_the_bracket() -> Outcome {
    bracket_is_left(0.5, 3.0, 0.75)?;
    let model = counterexample(&CLAIM, "feedback")?;
    bracket_is_left(model.value("f")?, model.value("g")?, model.value("e")?)
}
