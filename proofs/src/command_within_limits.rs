//! Claim `command-within-limits`: the saturated command keeps the limits, to the last bit, for every input.
//!
//! Hypotheses: finite limits `lower < 0 < upper` (rad/s), not necessarily symmetric. The desired speed is arbitrary, NaN and
//! infinities included; so are state and parameters.
//!
//! ```text
//! command = min(max(fdir q̇d, lower), upper),   fdir = min(1, 1 / ‖F_N q̇d‖∞)
//! ```
//!
//! Source: `[G11] eq 6-8`, where the bounded command is what the equations are for; the paper computes with real numbers.
//!
//! Derivation. `max` with `lower` gives a number of at least `lower` (the other operand, where one is NaN), `min` with `upper` one
//! between both because `lower < upper`. The script is exact to the bit. Over the reals scaling alone would do; over doubles it
//! does not, which the twin shows.
//!
//! Dropped hypothesis: the clamp after the scaling.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "command-within-limits",
    statement: "The saturated command lies inside the limits, to the last bit, for every finite or non-finite input.",
    source: "[G11] eq 6-8",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[Script {
        file: "command-within-limits.smt2",
        text: include_str!("../smt/command-within-limits.smt2"),
    }],
    twins: &[Twin {
        without: "clamp",
        script: Script {
            file: "command-within-limits-without-clamp.smt2",
            text: include_str!("../smt/command-within-limits-without-clamp.smt2"),
        },
    }],
};
