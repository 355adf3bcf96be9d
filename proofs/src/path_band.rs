//! Claim `path-band`: how far `φ` leaves zero on one constraint in the explicit form.
//!
//! Hypotheses: zero-order hold or Euler's rule, full push `G` and drift `D_min <= D <= D̄` per sample (units of `σ`),
//! `0 <= D̄ <= G`, `φ[0] <= D̄`; for the lower end `0 <= D_min` and `φ[0] >= -(G - D_min)⁺` as well.
//!
//! ```text
//! φ[k+1] = φ[k] + D[k] - G [φ[k] >= 0],     -(G - D_min)⁺ <= φ[k] <= D̄
//! ```
//!
//! Source: `[G12] eq 22` gives the width `G` as an estimate for both ends.
//!
//! Derivation. From `φ < 0` one drift leads to at most `D̄`; from `0 <= φ <= D̄` the push takes back at least the drift.
//! From `φ >= 0` the fall is at most `G - D_min`; from below zero `φ` does not fall if `D >= 0`. On a curved boundary `G`
//! is different at every sample, and all that is used is `D[k] <= G[k]`. The function is
//! [`slideway_conditioner::path::bounds::band`].
//!
//! Dropped hypotheses: `D̄ <= G`, and `0 <= D_min`.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "path-band",
    statement: "Explicit form, one constraint, drifts D_min <= D <= D̄ <= G per sample: φ <= D̄, and for D_min >= 0 also φ >= -(G - D_min)⁺.",
    source: "[G12] eq 22",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[
        Script { file: "path-band.smt2", text: include_str!("../smt/path-band.smt2") },
        Script { file: "path-band-lower.smt2", text: include_str!("../smt/path-band-lower.smt2") },
    ],
    twins: &[
        Twin {
            without: "push-beating-drift",
            script: Script {
                file: "path-band-without-push-beating-drift.smt2",
                text: include_str!("../smt/path-band-without-push-beating-drift.smt2"),
            },
        },
        Twin {
            without: "rising-drift",
            script: Script {
                file: "path-band-without-rising-drift.smt2",
                text: include_str!("../smt/path-band-without-rising-drift.smt2"),
            },
        },
    ],
    engines: &[],
};
