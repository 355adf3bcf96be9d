//! Claim `path-reserve`: with the reserve the explicit form keeps its band from any state, so the safe walk does.
//!
//! Hypotheses: rows as in [`crate::path_implicit`]. Push, reference and walk are arbitrary; the band `G_i = (γ1 + K γ2) U ‖∇σ_i‖`
//! may differ from sample to sample. With `e_i` the part of `φ_i` plus margin that lies above the band, `ρ` the recovery rate:
//!
//! ```text
//! e_i[k+1] <= max(0, e_i[k] - ρ T)
//! ```
//!
//! so from inside `φ_i <= G_i` at every sample, and `φ_i <= 0` with the margin [`slideway_conditioner::path::Margin::Band`].
//!
//! Source: this project; `[G12] 7.2.1` asks the designer to choose a push that is large enough, and example 9.4 does not.
//!
//! Derivation. The reserve is the smallest additional push that brings `φ_i` plus margin to at most `G_i + max(0, e_i - ρ T)`. It
//! exists by [`crate::path_implicit`]; where it does not the sample is held. Nothing about the walk is used: its speed limit
//! only makes the reserve rare.
//!
//! Dropped hypothesis: the reserve. A drift greater than the push then leaves the band.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "path-reserve",
    statement: "With the reserve φ_i stays in its band from any state inside it, whatever push, walk and reference do; from outside it returns at the recovery rate.",
    source: "this project; [G12] 7.2.1",
    verdict: Verdict::Ours,
    negations: &[
        Script { file: "path-reserve.smt2", text: include_str!("../smt/path-reserve.smt2") },
        Script { file: "path-reserve-recovery.smt2", text: include_str!("../smt/path-reserve-recovery.smt2") },
    ],
    twins: &[Twin {
        without: "reserve",
        script: Script {
            file: "path-reserve-without-reserve.smt2",
            text: include_str!("../smt/path-reserve-without-reserve.smt2"),
        },
    }],
    engines: &[],
};
