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

use crate::claim::{Claim, Script, Twin, Verdict};

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
    engines: &[],
};
