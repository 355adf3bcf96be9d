//! Claim `path-gain`: the smallest gain of the sum law that makes several constraints slide together.
//!
//! Hypotheses: `φ̇ = L_f + L_g u` with independent rows of `L_g`, `u = -u⁺ L_gᵀ s`, `s_i = [φ_i >= 0]`,
//! `μ = (L_g L_gᵀ)⁻¹ L_f >= 0`.
//!
//! ```text
//! u⁺ > max μ_i   implies   V̇ <= -(u⁺ - max μ_i) Σ φ_i⁺ < 0 outside the set,   V = ½ φᵀ (L_g L_gᵀ)⁻¹ φ
//! ```
//!
//! and with `u⁺ < max μ_i` the set of all `φ_i = 0` cannot be held.
//!
//! Source: `[G12] eq 21`, which is sufficient and can be twelve times larger.
//!
//! Derivation. `V̇ = φᵀ (μ - u⁺ s)`. For `φ_i >= 0` the term is `φ_i (μ_i - u⁺)`, for `φ_i < 0` it is `φ_i μ_i <= 0`. That the
//! gain is sharp: on the surface the mean push of each constraint would have to be `μ_i`, and a switch gives at most `u⁺`.
//! The function is [`slideway_conditioner::path::bounds::required_gain`].
//!
//! Dropped hypothesis: that the gain exceeds the largest multiplier, not just the others.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "path-gain",
    statement: "With the sum law, u⁺ > max μ_i makes any number of independent constraints slide, however small the angles; below it they do not.",
    source: "[G12] eq 21",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[Script { file: "path-gain.smt2", text: include_str!("../smt/path-gain.smt2") }],
    twins: &[Twin {
        without: "largest-multiplier",
        script: Script {
            file: "path-gain-without-largest-multiplier.smt2",
            text: include_str!("../smt/path-gain-without-largest-multiplier.smt2"),
        },
    }],
    engines: &[],
};
