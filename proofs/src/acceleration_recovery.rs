//! Claim `acceleration-recovery`: when a proportional position loop under bounded acceleration does not overshoot.
//!
//! Hypotheses: one joint, a standing reference, error `e >= 0` (rad), previous command `0 <= p <= Kp e_before`, `Kp Ts <= 1`, and
//! `Kp · upper <= D` with `D` the deceleration limit (rad/s²).
//!
//! ```text
//! command = Kp e brought into the box:   0 <= command <= Kp e,   so the next error is >= (1 - Kp Ts) e >= 0
//! ```
//!
//! Source: this project.
//!
//! Derivation. `e = e_before - Ts p`, so `Kp e >= p - Kp Ts p >= p - Ts D` for `Kp p <= D`: the joint can always slow down to what the
//! law asks. From rest `p = 0` the hypothesis on `p` holds, and it is the claim's own conclusion for the next sample. Braking feedback
//! (`Recovery::Braking`) needs no bound on the gain but `Kp Ts <= 1/2`: on its root branch with deceleration `D' = (1 - Kp Ts) D` two
//! consecutive speeds are `v` and `sqrt(v² - 2 D' Ts v)`, whose difference is `2 D' Ts / (1 + sqrt(1 - 2 D' Ts / v)) <= Ts D` since
//! `v >= D' / Kp` there and `sqrt(1 - 2x) >= 1 - 2x`.
//!
//! Dropped hypothesis: the bound on the gain.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "acceleration-recovery",
    statement: "A joint that returns by a proportional law under bounded acceleration does not pass its reference if Kp times the speed limit is at most the deceleration limit and Kp Ts at most 1.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[Script {
        file: "acceleration-recovery.smt2",
        text: include_str!("../smt/acceleration-recovery.smt2"),
    }],
    twins: &[Twin {
        without: "moderate-gain",
        script: Script {
            file: "acceleration-recovery-without-moderate-gain.smt2",
            text: include_str!("../smt/acceleration-recovery-without-moderate-gain.smt2"),
        },
    }],
    engines: &[],
};
