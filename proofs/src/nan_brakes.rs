//! Claim `nan-brakes`: an input that is not finite brakes.
//!
//! Hypotheses: finite limits `lower < 0 < upper` (rad/s), `f` in [0, 1]; at least one number of the input is NaN or infinite.
//!
//! ```text
//! explicit forms:  u = 0
//! implicit form:   f = 0, u <= 0
//! all forms:       q̇ds = 0 for every joint, λ̇ = 0, f does not rise
//! ```
//!
//! Source: this project.
//!
//! Derivation. "Inside" is `lower <= v and v <= upper`; a comparison with NaN is false and an infinity lies beyond every finite
//! limit, so `u = 0`, and `u = 0` cannot raise `f` (claim `factor-range`). The saturation looks for a number that is not finite
//! before it divides. In the implicit form `f*` does not exist and 0 stands for it; `A + 0 B` is then not finite, whether `A` or
//! `B` was the culprit. A factor is set through `max(0)` and `min(1)`, which turn NaN into 0. The script is exact to the bit.
//!
//! Dropped hypotheses: that the comparison is written so that NaN fails it, and that the limits are finite (limits the shipped
//! code refuses).

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "nan-brakes",
    statement: "A NaN or an infinity anywhere in the input: the joints are commanded to stand still, λ̇ = 0, u = 0 (at most 0 in the implicit form) and the factor does not rise.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[Script { file: "nan-brakes.smt2", text: include_str!("../smt/nan-brakes.smt2") }],
    twins: &[
        Twin {
            without: "ordered-comparison",
            script: Script {
                file: "nan-brakes-without-ordered-comparison.smt2",
                text: include_str!("../smt/nan-brakes-without-ordered-comparison.smt2"),
            },
        },
        Twin {
            without: "finite-limits",
            script: Script {
                file: "nan-brakes-without-finite-limits.smt2",
                text: include_str!("../smt/nan-brakes-without-finite-limits.smt2"),
            },
        },
    ],
};
