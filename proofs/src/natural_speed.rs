//! Claim `natural-speed`: under natural motion the speed along the path is proportional to `|det J|`.
//!
//! Hypotheses: `q̇ = b adj(J) t*`, the tool on a path with `t* ≠ 0` (m, 1 per unit of the path parameter), `b` constant.
//!
//! ```text
//! J q̇ = t* q̇*  =>  q̇* = b det J          q̇*(1) det J(2) = q̇*(2) det J(1)
//! ```
//!
//! Source: `[N] eq 7, 8` and section II B.
//!
//! Derivation. `J q̇ = b J adj(J) t* = b det(J) t*` (claim [`crate::null_vector`]); where `t* ≠ 0` only one path speed fits. The
//! tool moves at `‖t*‖ |q̇*|`, which on a path parametrised by its length is `|b det J|`.
//!
//! Dropped hypothesis: `b` constant, as at constant speed.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "natural-speed",
    statement: "With q̇ = b adj(J) t* and t* ≠ 0 the path speed is b det J and nothing else; with b constant the speeds at two places are as the determinants.",
    source: "[N] eq 7, 8",
    verdict: Verdict::Holds,
    negations: &[
        Script { file: "natural-speed.smt2", text: include_str!("../smt/natural-speed.smt2") },
        Script { file: "natural-speed-places.smt2", text: include_str!("../smt/natural-speed-places.smt2") },
    ],
    twins: &[Twin {
        without: "constant-b",
        script: Script {
            file: "natural-speed-without-constant-b.smt2",
            text: include_str!("../smt/natural-speed-without-constant-b.smt2"),
        },
    }],
    engines: &[],
};
