use nalgebra::SMatrix;
use slideway_proofs::null_vector::CLAIM;
use slideway_robot::augmented::{NullVector, null_vector};

use crate::natural_support::System;
use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// `n` of eq 6 beside the last entry of eq 5 leaves the kernel of a system of three joints; the shipped vector does not.
fn mixed_signs_leave_the_kernel(entries: &[f64; 9], tangent: [f64; 3]) -> Outcome {
    let system = System { jacobian: SMatrix::<f64, 3, 3>::from_row_slice(entries), tangent: tangent.into() };
    let null = null_vector(&system.jacobian, &system.tangent);
    let mixed = NullVector { path: -null.path, ..null };
    let [left, _] = system.residual(&mixed);
    assert!(left > 0.09, "{left}");
    let [left, size] = system.residual(&null);
    assert!(left <= 1e-14 * size, "{left}");
    Ok(())
}

#[test]
fn mixing_the_signs_of_the_two_printed_forms_leaves_the_kernel() -> Outcome {
    mixed_signs_leave_the_kernel(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0])?;
    let model = counterexample(&CLAIM, "one-sign")?;
    let mut entries = [0.0; 9];
    for (entry, name) in entries.iter_mut().zip(["a", "b", "c", "d", "e", "f", "g", "h", "i"]) {
        *entry = model.value(name)?;
    }
    mixed_signs_leave_the_kernel(&entries, [model.value("t1")?, model.value("t2")?, model.value("t3")?])
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
