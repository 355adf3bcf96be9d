//! Claim `curve-end`: a curve whose rate is decided sample by sample is never run backwards, never passed, and ends at rest.
//!
//! Hypotheses: place `u` and rate `w >= 0` at a sample with `u + Ts w / 2 <= 1`; the next rate `w2` in
//!
//! ```text
//! 0 <= w2 <= (1 - u - Ts w / 2) / Ts
//! ```
//!
//! and the rate linear in time between the two, so that `u2 = u + Ts (w + w2) / 2`. Then the same holds at the next sample, every place
//! between lies in `[u, u2]`, and `u2 <= 1`. Where `w2` is the largest that is allowed, a rate of 0 after it leads to 1 itself: from
//! every state two samples of `w2` and 0 end there, if the joints can take them. To that the look-ahead sees (claim `look-ahead-tail`), whose
//! plan ends by `α Ts² / 8` before the curve's end: by so much a stop in whole samples is longer than one at constant deceleration `α`.
//!
//! Source: this project.
//!
//! Derivation. Seen from `x = u + Ts w / 2` the next is `x + Ts w2`. The place between two samples is monotone, for its rate is a mean of
//! two rates that are not negative.
//!
//! Rounding. `u` is cut at 1; a remainder below 1e-12 counts as none.
//!
//! Dropped hypothesis: the half. With `w2` up to `2 (1 - u - Ts w / 2) / Ts` the next sample is still on the curve, and the one after
//! it is not.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "curve-end",
    statement: "A curve whose rate is decided sample by sample is never run backwards and never passed, at samples and between them, and a stand leads to its end.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[Script { file: "curve-end.smt2", text: include_str!("../smt/curve-end.smt2") }],
    twins: &[Twin {
        without: "half",
        script: Script {
            file: "curve-end-without-half.smt2",
            text: include_str!("../smt/curve-end-without-half.smt2"),
        },
    }],
    engines: &[],
};
