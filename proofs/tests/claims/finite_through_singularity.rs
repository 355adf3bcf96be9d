use nalgebra::SMatrix;
use slideway_proofs::finite_through_singularity::CLAIM;
use slideway_robot::augmented::null_vector;

use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// A system that has lost two ranks' worth of its null vector: the shipped one is zero to a few roundings.
fn null_vector_vanishes(entries: &[f64; 4], tangent: [f64; 2]) -> Outcome {
    let null = null_vector(&SMatrix::<f64, 2, 2>::from_row_slice(entries), &tangent.into());
    // Entries up to 1, the solver's decimals cut at 1e-20.
    assert!(null.norm() <= 1e-15, "{null:?}");
    Ok(())
}

#[test]
fn beyond_codimension_one_the_null_vector_vanishes() -> Outcome {
    null_vector_vanishes(&[1.0, 0.5, 0.5, 0.25], [0.5, 0.25])?;
    let model = counterexample(&CLAIM, "codimension-one")?;
    let value = |name| model.value(name);
    let entries = [value("a")?, value("b")?, value("c")?, value("d")?];
    null_vector_vanishes(&entries, [value("t1")?, value("t2")?])
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
