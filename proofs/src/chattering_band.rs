//! Claim `chattering-band`: how much one joint's desired speed can change from one sample to the next.
//!
//! Hypotheses: `q̇d = A + f B` (rad/s) at both samples, `0 < a <= 1`, `f` in [0, 1], `u` in {0, 1}. Nothing else: `A` and `B` are
//! arbitrary.
//!
//! ```text
//! |q̇d[k+1] - q̇d[k]| <= |B[k+1]| a s + f |B[k+1] - B[k]| + |A[k+1] - A[k]|,   s = 1 - f if u = 1, f if u = 0
//! ```
//!
//! With zero error and `B = v(λ) λ̇d`, the second term is at most `Ts λ̇² sup |dv/dλ|` (rad/s), because `Δλ = Ts λ̇`.
//!
//! Source: `[G11] eq 23` estimates the change by `|B| a` alone. It is an estimate: it leaves out the drift of `B`, which for a
//! joint that does not limit, or where the drift beats the filter, is most of the change.
//!
//! Derivation. `q̇d' - q̇d = (f' - f) B' + f (B' - B) + (A' - A)`, `f' - f = a (u - f)`, and the triangle inequality. The function
//! is [`slideway_conditioner::bounds::chattering_bound`].
//!
//! Dropped hypothesis: the drift terms, which is eq 23 read as a bound.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "chattering-band",
    statement: "The desired speed of a joint changes by at most |B'| a |u - f| + f |ΔB| + |ΔA| over one sample; without the drift terms (eq 23) this is an estimate, not a bound.",
    source: "[G11] eq 23",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[Script { file: "chattering-band.smt2", text: include_str!("../smt/chattering-band.smt2") }],
    twins: &[Twin {
        without: "drift-term",
        script: Script {
            file: "chattering-band-without-drift-term.smt2",
            text: include_str!("../smt/chattering-band-without-drift-term.smt2"),
        },
    }],
};
