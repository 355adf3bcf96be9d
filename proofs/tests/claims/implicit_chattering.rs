use slideway_conditioner::bounds::{Signals, implicit_chattering};
use slideway_conditioner::{AffineSpeed, ImplicitSpeedRegulator, SpeedLimits, SpeedState};
use slideway_proofs::draw::settings;
use slideway_proofs::implicit_chattering::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

#[test]
fn the_shipped_form_keeps_the_bound() -> Outcome {
    holds(&CLAIM)
}

/// Joint one is stopped by its feedback; joint two, without any, moves with the factor.
fn bound_is_left(f: f64, fb: [f64; 2], ff: [f64; 2], change: f64) -> Outcome {
    // A filter so slow that what it rises is nothing beside the fall.
    let a = 1e-6;
    let regulator = ImplicitSpeedRegulator::new(settings(SpeedLimits::symmetric([1.0; 2])?, a, 1.0))?;
    let mut state = SpeedState::moving(f)?;
    let after = AffineSpeed { feedback: [fb[1], 0.0], feedforward: ff };
    let command = regulator.step(&mut state, &after);
    let changed = ff[1] * (f - command.factor);
    let declared = Signals { overspeed: ff[0].max(ff[1]), demand_change: change, ..Signals::NONE };
    assert!(changed > implicit_chattering(&declared, a, 1.0) + 0.05, "{changed}");
    // With the feedback it really has, the bound holds, or there is none.
    let honest = Signals { feedback: fb[1].abs(), ..declared };
    assert!(changed <= implicit_chattering(&honest, a, 1.0), "{changed}");
    Ok(())
}

#[test]
fn without_the_feedback_inside_the_bound_is_left() -> Outcome {
    bound_is_left(0.75, [0.78125, 0.875], [0.25, 1.3125], 0.109_375)?;
    let model = counterexample(&CLAIM, "feedback-inside")?;
    let fb = [model.value("fb")?, model.value("fb_next")?];
    bound_is_left(model.value("f")?, fb, [model.value("ff")?, model.value("other_ff")?], model.value("x")?)
}
