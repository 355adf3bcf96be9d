//! Claim `path-lag`: `σ` never exceeds the largest `φ` so far, if it starts below it.
//!
//! Hypotheses: `K > 0` (s), `φ = σ + K σ̇`.
//!
//! ```text
//! σ(t) <= max(σ(0), sup φ over [0, t])
//! ```
//!
//! Source: `[G12] eq 3`, which calls `φ <= 0` the modified constraint; the bound for a `φ` that chatters is this project's.
//!
//! Derivation. `K σ̇ + σ = φ` is a first-order lag of unit gain: over any interval `σ' = e σ + (1 - e) m` with
//! `e = exp(-T/K)` and `m` a mean of `φ` over the interval. The supremum is over time, not over samples: between samples
//! `φ` can bulge by `T² sup |φ̈| / 8`, see [`slideway_conditioner::path::bounds::between_samples`].
//!
//! Dropped hypothesis: `K > 0` (a parameter the conditioner refuses).

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "path-lag",
    statement: "With φ = σ + K σ̇ and K > 0, σ never exceeds the larger of its start and the supremum of φ over time.",
    source: "[G12] eq 3",
    verdict: Verdict::Holds,
    negations: &[Script { file: "path-lag.smt2", text: include_str!("../smt/path-lag.smt2") }],
    twins: &[Twin {
        without: "approach",
        script: Script {
            file: "path-lag-without-approach.smt2",
            text: include_str!("../smt/path-lag-without-approach.smt2"),
        },
    }],
    engines: &[],
};
