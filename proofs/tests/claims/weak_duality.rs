use slideway_baselines::time_optimal::{PieceProgram, feasible_time, lower_bound};
use slideway_path::{EndRate, PathSample};
use slideway_proofs::random_program::path_of;
use slideway_proofs::weak_duality::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// With the row `x <= b`, `x` in [0, 1] and the objective `-x`: the naive bound at a negative multiplier lies above a feasible value.
fn negative_multiplier_lifts_the_naive_bound(mu: f64, b: f64, x: f64) {
    let naive = |mu: f64| -mu * b + (mu - 1.0_f64).min(0.0);
    assert!(mu < 0.0 && x <= b && naive(mu) > -x + 0.05 && naive(0.0) <= -x, "{}", naive(mu));
}

/// The same multiplier in every row of a path from rest to rest: the shipped bound takes it for 0.
fn shipped_bound_takes_it_for_zero(mu: f64) -> Outcome {
    let node = |s: f64| PathSample { s, lambda: s, first: vec![1.0], second: vec![0.0], ..PathSample::default() };
    let path = path_of((0..5).map(|k| node(f64::from(k))).collect(), vec![2.0], Some(vec![1.0]), EndRate::ByLimits);
    let program = PieceProgram::new(&path, 0)?;
    let profile = slideway_baselines::time_optimal::repair(&program, &program.cap)?;
    let bound = |mu: f64| lower_bound(&program, &profile, &vec![mu; program.row_count()]);
    assert!(bound(mu) == bound(0.0) && bound(mu).lo <= feasible_time(&program, &profile).hi);
    Ok(())
}

#[test]
fn negative_multipliers_would_lift_the_bound_and_count_as_zero() -> Outcome {
    negative_multiplier_lifts_the_naive_bound(-3.0, 2.0, 0.5);
    let model = counterexample(&CLAIM, "signs")?;
    let mu = model.value("mu")?;
    negative_multiplier_lifts_the_naive_bound(mu, model.value("b")?, model.value("x")?);
    shipped_bound_takes_it_for_zero(mu)?;
    shipped_bound_takes_it_for_zero(f64::NAN)
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
