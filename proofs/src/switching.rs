//! Claim `switching`: exactly when the switch acts.
//!
//! Hypotheses: zero tracking error, `0 < a <= 1`, `f0` in [0, 1], `g > 0` (all unit 1).
//!
//! ```text
//! u[k] = 0 for the first time  <=>  k is the first sample with g[k] (1 - (1 - f0)(1 - a)^k) > 1
//! g <= 1 at every sample       =>   u = 1 for ever (equality included)
//! ```
//!
//! Source: `[G11] eq 21` asks for `g >= 1` and calls it both what the surfaces need to be reached and what makes one joint
//! saturate all along the path. The first half is right. The second is not: a run can end before the filter has risen far
//! enough, and at `g = 1` no switch ever happens.
//!
//! Derivation. While `u = 1`, `1 - f` is multiplied by `1 - a` every sample, so `f[k] = 1 - (1 - f0)(1 - a)^k` by induction;
//! `u[k] = 0` means `m = g[k] f[k] > 1`. With `g <= 1` and `f <= 1` (claim `factor-range`) `m <= 1`.
//! [`slideway_conditioner::bounds::switches_by`] is the criterion for constant `g`: `f` does not fall while `u = 1`, so the
//! last sample decides.
//!
//! Dropped hypothesis: that there are enough samples.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "switching",
    statement: "With zero error u switches exactly if some sample of the run with u = 1 has g (1 - (1 - f0)(1 - a)^k) > 1; g > 1 (eq 21) is necessary and not sufficient, and equality never switches.",
    source: "[G11] eq 21",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[Script { file: "switching.smt2", text: include_str!("../smt/switching.smt2") }],
    twins: &[Twin {
        without: "enough-samples",
        script: Script {
            file: "switching-without-enough-samples.smt2",
            text: include_str!("../smt/switching-without-enough-samples.smt2"),
        },
    }],
};
