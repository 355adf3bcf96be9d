//! Claim `transpose-descent`: first-order control by the transposed Jacobian descends.
//!
//! Hypotheses: `q̇ = Jᵀ K e`, the reference at rest, `K` symmetric positive definite (here diagonal), `J` of full row rank.
//!
//! ```text
//! V = ½ eᵀ K e          V̇ = -|Jᵀ K e|² < 0 for e ≠ 0
//! ```
//!
//! Source: `[R16]` operational space control, which asks for nonsingular `J` and `K_P`: that does not make `V` positive (take
//! `K = -1`), nor is a wide `J` nonsingular.
//!
//! Derivation. `ė = -J q̇`; `Jᵀ K e = 0` only for `K e = 0` if the rows of `J` are independent.
//!
//! Dropped hypothesis: full row rank. `V` does not grow then, but an error may stay.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "transpose-descent",
    statement: "With q̇ = Jᵀ K e, K symmetric positive definite and J of full row rank, V = ½ eᵀ K e falls wherever e is not zero.",
    source: "[R16] operational space control",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[Script { file: "transpose-descent.smt2", text: include_str!("../smt/transpose-descent.smt2") }],
    twins: &[Twin {
        without: "full-rank",
        script: Script {
            file: "transpose-descent-without-full-rank.smt2",
            text: include_str!("../smt/transpose-descent-without-full-rank.smt2"),
        },
    }],
    engines: &[],
};
