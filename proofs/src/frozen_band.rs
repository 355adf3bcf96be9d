//! Claim `frozen-band`: the width of the chattering on a frozen path.
//!
//! Hypotheses: zero tracking error, `0 < a <= 1`, `g >= 1` constant, `m[0] <= 1 + a (g - 1)` (all unit 1; a start with
//! `m[0] <= 1` is a special case).
//!
//! ```text
//! m[k] <= 1 + a (g - 1)   at every sample,   m = g f
//! ```
//!
//! Source: this project; `[G11] eq 23` estimates the same amplitude joint by joint.
//!
//! Derivation. If `m <= 1` then `u = 1` and `m' = (1 - a) m + a g <= 1 - a + a g`. If `m > 1` then `u = 0` and
//! `m' = (1 - a) m <= m`. For `g < 1`, `m = g f <= 1` already (claim `factor-range`). The function is
//! [`slideway_conditioner::bounds::frozen_band`].
//!
//! Dropped hypotheses: that `g` is constant (the drift of a real path: see [`crate::drifting_band`]), and zero error.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "frozen-band",
    statement: "On a frozen path with zero error and g >= 1, a start with m <= 1 + a (g - 1) keeps m <= 1 + a (g - 1) for ever.",
    source: "section 3.3.1 of [G11]; the bound is this project's",
    verdict: Verdict::Ours,
    negations: &[Script { file: "frozen-band.smt2", text: include_str!("../smt/frozen-band.smt2") }],
    twins: &[
        Twin {
            without: "frozen-path",
            script: Script {
                file: "frozen-band-without-frozen-path.smt2",
                text: include_str!("../smt/frozen-band-without-frozen-path.smt2"),
            },
        },
        Twin {
            without: "zero-error",
            script: Script {
                file: "frozen-band-without-zero-error.smt2",
                text: include_str!("../smt/frozen-band-without-zero-error.smt2"),
            },
        },
    ],
};
