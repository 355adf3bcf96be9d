//! Claim `energy-and-power`: kinetic energy is proportional to `b²`, mechanical power to `b³`.
//!
//! Hypotheses: natural motion, `b` constant in time; gravity balanced or absent; no friction. Compared are the same places of
//! the path at two values of `b`.
//!
//! ```text
//! E = ½ b² nᵀ M n (J)          P = τᵀq̇ = b³ nᵀ (M (∂n/∂q̄) n̄ + c(q, n)) (W)
//! ```
//!
//! Source: `[N] section II C`, which states it for the system of eq 11, gravity included in its `τ`. The weight's power
//! `b gᵀn` is linear in `b`, so gravity has to be left out.
//!
//! Derivation. `q̇ = b n`, `q̈ = b² (∂n/∂q̄) n̄`, and centrifugal torques are quadratic in `q̇`.
//!
//! Dropped hypotheses: gravity balanced; `b` constant.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "energy-and-power",
    statement: "Under natural motion without gravity and friction, k times b gives at every place k² times the kinetic energy and k³ times the mechanical power.",
    source: "[N] section II C",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[Script { file: "energy-and-power.smt2", text: include_str!("../smt/energy-and-power.smt2") }],
    twins: &[
        Twin {
            without: "balanced-gravity",
            script: Script {
                file: "energy-and-power-without-balanced-gravity.smt2",
                text: include_str!("../smt/energy-and-power-without-balanced-gravity.smt2"),
            },
        },
        Twin {
            without: "constant-b",
            script: Script {
                file: "energy-and-power-without-constant-b.smt2",
                text: include_str!("../smt/energy-and-power-without-constant-b.smt2"),
            },
        },
    ],
    engines: &[],
};
