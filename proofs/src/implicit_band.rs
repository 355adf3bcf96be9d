//! Claim `implicit-band`: the implicit form does not chatter.
//!
//! Hypotheses: `q̇d(f) = A + f B` (rad/s), `lower <= A <= upper` for every joint, `lower < 0 < upper`, `0 < a <= 1`, `f_before` in
//! [0, 1].
//!
//! ```text
//! f* = max { f in [0, 1] : lower <= A + f B <= upper },   f = min((1 - a) f_before + a, f*)
//! m = ‖F_N (A + f B)‖∞ <= 1,   f <= (1 - a) f_before + a
//! ```
//!
//! Source: this project, after Acary and Brogliato's implicit discretisation of set-valued controllers.
//!
//! Derivation. Joint by joint the closed form `f <= (limit - A) / B`, with the limit the joint moves towards, is exactly
//! `A + f B <= limit` (or `>=`); the limits are convex, so every smaller `f >= 0` is admissible too, and none above `f*` is.
//!
//! Rounding. Over doubles the difference, the quotient and the product each add one rounding `e = 2^-53` relative to
//! `limit - A`, the sum and the final ratio one each relative to the limit, so
//!
//! ```text
//! m <= 1 + e (2 + 3 (1 + κ)) + O(e²),   κ = largest of |lower / upper| and |upper / lower| over the joints
//! ```
//!
//! which is four units in the last place of 1 for symmetric limits and **grows with the asymmetry of the limits**: a joint allowed
//! 1 rad/s one way and 1000 rad/s the other can overshoot the narrow limit by 3e-13 of it. It holds while nothing underflows;
//! feedforwards of more than 1e100 times a limit are outside it. The commanded speed is saturated afterwards and keeps the limits
//! to the last bit regardless (claim [`crate::command_within_limits`]).
//!
//! Dropped hypothesis: that `A` lies inside. Then the reference stands still, `f = 0`, and `m > 1`.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "implicit-band",
    statement: "Whenever the feedback part A lies inside the limits, so does A + f B: m <= 1 (to 4 units in the last place for symmetric limits), and f rises no faster than the filter.",
    source: "this project, after Acary and Brogliato",
    verdict: Verdict::Ours,
    negations: &[Script { file: "implicit-band.smt2", text: include_str!("../smt/implicit-band.smt2") }],
    twins: &[Twin {
        without: "feedback-inside",
        script: Script {
            file: "implicit-band-without-feedback-inside.smt2",
            text: include_str!("../smt/implicit-band-without-feedback-inside.smt2"),
        },
    }],
};
