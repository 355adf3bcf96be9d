//! Claim `delayed-band`: the frozen band when the switch arrives late.
//!
//! Hypotheses: zero tracking error, `0 < a <= 1`, `g >= 1` constant, `m[0] <= 1`, and the filter receives `u[k - D]` at sample
//! `k`, with `D >= 0` whole samples of delay; what it receives before sample `D` is arbitrary.
//!
//! ```text
//! m[k] <= 1 + (1 - (1 - a)^(D+1)) (g - 1)   at every sample
//! ```
//!
//! Source: this project. For `D = 0` it is the claim [`crate::frozen_band`].
//!
//! Derivation. Let `n` count the samples since the last one with `m <= 1`, where `1 - f >= 1 - 1/g`. A rise multiplies `1 - f` by
//! `1 - a`, a fall increases it, so `1 - f >= (1 - a)^n (1 - 1/g)`. From `n = D + 1` on, the switch that arrives was decided at a
//! sample with `m > 1`: it is 0 and `f` falls. Hence `g (1 - f) >= (1 - a)^(D+1) (g - 1)` always, which is the bound. The counting
//! is done here by hand; the script checks that every step keeps the invariant, with the power of `1 - a` as a real.
//! The function is [`slideway_conditioner::bounds::delayed_frozen_band`].
//!
//! Dropped hypothesis: that the delay is at most the `D` of the bound.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "delayed-band",
    statement: "On a frozen path with zero error, m[0] <= 1 and u arriving D samples late: m <= 1 + (1 - (1 - a)^(D+1)) (g - 1).",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[Script { file: "delayed-band.smt2", text: include_str!("../smt/delayed-band.smt2") }],
    twins: &[Twin {
        without: "bounded-delay",
        script: Script {
            file: "delayed-band-without-bounded-delay.smt2",
            text: include_str!("../smt/delayed-band-without-bounded-delay.smt2"),
        },
    }],
};
