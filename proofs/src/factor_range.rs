//! Claim `factor-range`: the factor stays in [0, 1], to the last bit, whatever the inputs.
//!
//! Hypotheses: filter step `0 < a <= 1` (unit 1), `f[0]` in [0, 1], `u` in [0, 1].
//!
//! ```text
//! f[k+1] = f[k] + a (u[k] - f[k])
//! ```
//!
//! Source: `[G11] eq 19, 22`, which states the filter and its unit gain; the range is implied there, not stated.
//!
//! Derivation. Over the reals the step is a convex combination of `f` and `u`. In doubles, for `u = 1`: the rounded
//! difference `d = fl(1 - f)` is a double, so `fl(a d) <= d` because rounding is monotonic. If `f >= 1/2`, `d` is exact
//! (Sterbenz) and `f + d = 1`; if `f < 1/2`, `d` lies in (1/2, 1] and is off by at most 2^-54, so `f + d <= 1 + 2^-54`,
//! which rounds to 1. For `u = 0`: `fl(0 - f) = -f` exactly and `fl(a f) <= f`. An input between 0 and 1 gives a difference
//! between those two. The script over doubles checks this for every bit pattern. NaN cannot enter through the switch, which
//! is 0 or 1; in the implicit form it is turned into 0 where the state is set, see [`crate::nan_brakes`].
//!
//! Dropped hypotheses: `a <= 1` (a set of parameters the shipped filter refuses), and `u` in [0, 1].

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "factor-range",
    statement: "The factor f stays in [0, 1], to the last bit, for every input, NaN and infinities included.",
    source: "[G11] eq 19, 22",
    verdict: Verdict::Holds,
    negations: &[
        Script { file: "factor-range.smt2", text: include_str!("../smt/factor-range.smt2") },
        Script { file: "factor-range-float64.smt2", text: include_str!("../smt/factor-range-float64.smt2") },
    ],
    twins: &[
        Twin {
            without: "step-at-most-one",
            script: Script {
                file: "factor-range-without-step-at-most-one.smt2",
                text: include_str!("../smt/factor-range-without-step-at-most-one.smt2"),
            },
        },
        Twin {
            without: "input-in-range",
            script: Script {
                file: "factor-range-without-input-in-range.smt2",
                text: include_str!("../smt/factor-range-without-input-in-range.smt2"),
            },
        },
    ],
};
