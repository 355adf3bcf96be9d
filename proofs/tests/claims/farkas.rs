use slideway_baselines::time_optimal::{OptimumError, PieceProgram};
use slideway_path::{EndRate, PathSample};
use slideway_proofs::farkas::CLAIM;
use slideway_proofs::random_program::path_of;

use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// A negative multiplier "proves" that `x <= b` has no `x` in [0, 1]; taken for 0, as the shipped check does, it proves nothing.
fn negative_multiplier_proves_what_is_false(mu: f64, b: f64) {
    let margin = |mu: f64| mu.min(0.0) - mu * b;
    assert!(b >= 0.0 && margin(mu) > 0.05 && margin(mu.max(0.0)) <= 0.0, "{}", margin(mu));
}

#[test]
fn negative_multipliers_prove_nothing() -> Outcome {
    negative_multiplier_proves_what_is_false(-3.0, 2.0);
    let model = counterexample(&CLAIM, "signs")?;
    negative_multiplier_proves_what_is_false(model.value("mu")?, model.value("b")?);
    Ok(())
}

/// A change of speed by `2 a s` in `b` over the way `s`: just possible, and just not.
#[test]
fn what_is_just_impossible_is_refused_with_a_proof() {
    let program = |rate: f64| {
        let node = |s: f64| PathSample { s, lambda: s, first: vec![1.0], second: vec![0.0], ..PathSample::default() };
        let mut path =
            path_of((0..4).map(|k| node(f64::from(k))).collect(), vec![10.0], Some(vec![1.0]), EndRate::Given(0.0));
        path.pieces[0].end = EndRate::Given(rate);
        PieceProgram::new(&path, 0)
    };
    // b = 6 at the end is what an acceleration of 1 gives over 3.
    assert!(program(5.999_f64.sqrt()).is_ok());
    let refused = program(6.001_f64.sqrt());
    assert!(matches!(refused, Err(OptimumError::Infeasible { proven: true, .. })), "{refused:?}");
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
