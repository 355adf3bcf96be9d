//! Claim `path-equivalence`: the equivalent control of the sliding mode is the optimum of the safety filter.
//!
//! Hypotheses: `μ = (L_g L_gᵀ)⁻¹ L_f >= 0`, `u_eq = -L_gᵀ μ`.
//!
//! ```text
//! u_eq = argmin ‖u‖²   subject to   L_f + L_g u <= 0,   with multipliers μ
//! ```
//!
//! Source: this project; `φ <= 0` is a control-barrier condition of rate `1 / K`.
//!
//! Derivation. The optimality conditions of that convex program are `u = -L_gᵀ μ`, `μ >= 0`, `L_f + L_g u <= 0` and
//! `μᵀ (L_f + L_g u) = 0`. With every constraint at equality, `L_f - L_g L_gᵀ μ = 0`, they hold, and they are sufficient: for
//! an admissible `v = u + d` they give `uᵀd = -Σ μ_i g_iᵀd >= 0`, so `‖v‖² = ‖u‖² + 2 uᵀd + ‖d‖² >= ‖u‖²`.
//!
//! Dropped hypothesis: `μ_2 >= 0`. The optimum then lets that constraint go.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "path-equivalence",
    statement: "Where μ = (L_g L_gᵀ)⁻¹ L_f >= 0, the equivalent control -L_gᵀ μ is the smallest u with L_f + L_g u <= 0, and μ are its multipliers.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[Script { file: "path-equivalence.smt2", text: include_str!("../smt/path-equivalence.smt2") }],
    twins: &[Twin {
        without: "positive-multiplier",
        script: Script {
            file: "path-equivalence-without-positive-multiplier.smt2",
            text: include_str!("../smt/path-equivalence-without-positive-multiplier.smt2"),
        },
    }],
    engines: &[],
};
