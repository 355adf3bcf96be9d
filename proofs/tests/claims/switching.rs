use slideway_conditioner::SpeedState;
use slideway_conditioner::bounds::switches_by;
use slideway_proofs::switching::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven, unit_joint};

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

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
