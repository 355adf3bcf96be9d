use nalgebra::{SMatrix, SVector};
use proptest::prelude::{prop_assert, proptest};
use proptest::test_runner::TestCaseError;
use slideway_proofs::null_vector::CLAIM;
use slideway_robot::augmented::{NullVector, null_vector};

use crate::natural_support::{System, any_rank};
use crate::support::{Outcome, config, counterexample, proven};

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

/// Reflections err by some `N` roundings each of what they move, and there are `2 N` of them: 2 · 36 of 1e-16, and a
/// constant of about ten (Higham 2002, theorem 19.4). Against the definition both sides are determinants with errors of
/// that share of their Hadamard bound.
const SLACK: f64 = 1e-13;

fn is_the_null_vector<const N: usize>(system: &System<N>) -> Result<(), TestCaseError> {
    let null = null_vector(&system.jacobian, &system.tangent);
    let [left, size] = system.residual(&null);
    prop_assert!(left <= SLACK * size, "{left} {size}");
    // Cramer's rule: entry i is det J with column i replaced by t.
    let cramer = |i: usize| {
        let mut replaced = system.jacobian;
        replaced.set_column(i, &system.tangent);
        determinant(system, &replaced)
    };
    let wanted = SVector::<f64, N>::from_fn(|i, _| cramer(i));
    let slack = SLACK * system.volume();
    prop_assert!((null.joints - wanted).amax() <= slack, "{:?} {wanted:?}", null.joints);
    prop_assert!((null.path - determinant(system, &system.jacobian)).abs() <= slack);
    Ok(())
}

/// By elimination, rows first divided by their lengths in the system: pivoting mixes rows, and a short one would inherit the
/// roundings of a long one.
fn determinant<const N: usize>(system: &System<N>, matrix: &SMatrix<f64, N, N>) -> f64 {
    let length = |i: usize| system.jacobian.row(i).norm().hypot(system.tangent[i]);
    let even = nalgebra::DMatrix::from_fn(N, N, |i, j| matrix[(i, j)] / length(i));
    even.lu().determinant() * system.volume()
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn shipped_null_vector_of_two_joints_is_in_the_kernel(system in any_rank::<2>()) {
        is_the_null_vector(&system)?;
    }

    #[test]
    fn shipped_null_vector_of_three_joints_is_in_the_kernel(system in any_rank::<3>()) {
        is_the_null_vector(&system)?;
    }

    #[test]
    fn shipped_null_vector_of_six_joints_is_in_the_kernel(system in any_rank::<6>()) {
        is_the_null_vector(&system)?;
    }
}
