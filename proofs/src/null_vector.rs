//! Claim `null-vector`: `n̄ = [adj(J) t; det J]` is in the kernel of the column-augmented Jacobian `[J, -t]`.
//!
//! Hypotheses: `J` square, of any rank; `t` any vector.
//!
//! ```text
//! J adj(J) t - t det J = 0
//! ```
//!
//! Source: `[N] eq 3-6`. Eq 5, the cofactors `(-1)^(i+1) det J̄_i`, ends in `(-1)^N det J`; eq 6 ends in `det J`. Each is in the
//! kernel with a first part of its own sign; `n = adj(J) t` belongs to eq 6.
//!
//! Derivation. `J adj(J) = det(J) I` is a polynomial identity in the entries of `J`. The scripts have two and three joints; for
//! more the property test has the shipped code, up to six.
//!
//! Dropped hypothesis: one sign convention for both parts.

use nalgebra::{DMatrix, SMatrix};
use slideway_robot::augmented::null_vector;

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::natural_world::System;
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "null-vector",
    statement: "[adj(J) t; det J] is in the kernel of [J, -t] for every square J, singular ones included, and every t.",
    source: "[N] eq 3-6",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[
        Script { file: "null-vector-2.smt2", text: include_str!("../smt/null-vector-2.smt2") },
        Script { file: "null-vector-3.smt2", text: include_str!("../smt/null-vector-3.smt2") },
    ],
    twins: &[Twin {
        without: "one-sign",
        script: Script {
            file: "null-vector-without-one-sign.smt2",
            text: include_str!("../smt/null-vector-without-one-sign.smt2"),
        },
    }],
    engines: &[
        Engine {
            name: "shipped_null_vector_of_two_joints_is_in_the_kernel",
            unit: "share of the terms",
            about: About::Other,
            cost: Cost::Sample,
            trial: in_the_kernel::<2>,
        },
        Engine {
            name: "shipped_null_vector_of_three_joints_is_in_the_kernel",
            unit: "share of the terms",
            about: About::Other,
            cost: Cost::Sample,
            trial: in_the_kernel::<3>,
        },
        Engine {
            name: "shipped_null_vector_of_six_joints_is_in_the_kernel",
            unit: "share of the terms",
            about: About::Other,
            cost: Cost::Sample,
            trial: in_the_kernel::<6>,
        },
    ],
};

/// Reflections err by some `N` roundings each of what they move, and there are `2 N` of them: 2 · 36 of 1e-16, and a
/// constant of about ten (Higham 2002, theorem 19.4). Against the definition both sides are determinants with errors of
/// that share of their Hadamard bound.
const SLACK: f64 = 1e-13;

/// Regular, nearly singular and singular to rounding.
fn in_the_kernel<const N: usize>(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let own = choices.decade(-17.0, 0.0);
    let system = match choices.below(3) {
        0 => System::<N>::draw(choices),
        1 => System::spoilt(choices, own),
        _ => System::spoilt(choices, 0.0),
    };
    let null = null_vector(&system.jacobian, &system.tangent);
    let [left, size] = system.residual(&null);
    let volume = system.volume();
    let mut margin = worse(f64::INFINITY, SLACK - left / size.max(f64::MIN_POSITIVE));
    // Cramer's rule: entry i is det J with column i replaced by t.
    for i in 0..N {
        let mut replaced = system.jacobian;
        replaced.set_column(i, &system.tangent);
        margin = worse(margin, SLACK - (null.joints[i] - determinant(&system, &replaced)).abs() / volume);
    }
    Ok(worse(margin, SLACK - (null.path - determinant(&system, &system.jacobian)).abs() / volume))
}

/// By elimination, rows first divided by their lengths in the system: pivoting mixes rows, and a short one would inherit the
/// roundings of a long one.
fn determinant<const N: usize>(system: &System<N>, matrix: &SMatrix<f64, N, N>) -> f64 {
    let length = |i: usize| system.jacobian.row(i).norm().hypot(system.tangent[i]);
    DMatrix::from_fn(N, N, |i, j| matrix[(i, j)] / length(i)).lu().determinant() * system.volume()
}
