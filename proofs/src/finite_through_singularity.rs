//! Claim `finite-through-singularity`: joint speeds stay finite where the Jacobian is singular.
//!
//! Hypotheses: entries of `J` and `t` in [-1, 1] (any scale), `J` singular, `[J, -t]` of full rank: a singularity of
//! codimension one. `b` finite.
//!
//! ```text
//! n̄ ≠ 0, |n_i| <= 2 (two joints), q̇* = 0;    J v = t s has no solution with s ≠ 0
//! ```
//!
//! Source: `[N] section II A`.
//!
//! Derivation. The entries of `n̄` are the minors of `[J, -t]`: bounded like every polynomial (by the product of the lengths
//! of its rows, for any number of joints), and not all zero at full rank. The path stands where `det J = 0` while the joints
//! go on. The second script is the other side: there `t` is not in the range of `J`, so constant speed has no joint speed at all.
//!
//! Dropped hypothesis: codimension one. `n̄` is then zero: the arm stands, still finite.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "finite-through-singularity",
    statement: "At a singularity of codimension one the null vector is finite and not zero while its path speed is zero; no finite joint speed follows the path at another path speed.",
    source: "[N] section II A",
    verdict: Verdict::Holds,
    negations: &[
        Script {
            file: "finite-through-singularity.smt2",
            text: include_str!("../smt/finite-through-singularity.smt2"),
        },
        Script {
            file: "finite-through-singularity-constant-speed.smt2",
            text: include_str!("../smt/finite-through-singularity-constant-speed.smt2"),
        },
    ],
    twins: &[Twin {
        without: "codimension-one",
        script: Script {
            file: "finite-through-singularity-without-codimension-one.smt2",
            text: include_str!("../smt/finite-through-singularity-without-codimension-one.smt2"),
        },
    }],
    engines: &[],
};
