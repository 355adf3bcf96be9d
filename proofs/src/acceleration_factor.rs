//! Claim `acceleration-factor`: the direction of the demand is kept whenever some factor allows it.
//!
//! Hypotheses: the box of a sample (rad/s), `q̇d(f) = A + f B` (rad/s), and `F = { f in [0, 1] : q̇d(f) in the box }` not empty.
//!
//! ```text
//! F = [f_least, f_greatest] in closed form,   f = max(f_least, min((1 - a) f_prev + a, f_greatest)),   q̇d(f) in the box
//! ```
//!
//! Source: this project, after Acary and Brogliato's implicit discretisation.
//!
//! Derivation. Joint by joint `low <= A + f B <= high` is an interval in `f`; their intersection with [0, 1] is one. The factor is its
//! point nearest to what the filter allows from below, or its least one where the filter allows less.
//!
//! Dropped hypothesis: a reachable point on the ray. This is also what no regulator without look-ahead can avoid: with `|p_1| > Ts a_1`
//! the path may go on without joint 1, and `A_1 + f B_1 = 0` is out of reach for every `f`. The command is then the point of the box
//! nearest to the demand that exceeds it least.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "acceleration-factor",
    statement: "Whenever some factor in [0, 1] makes the demand reachable the command is the demand, and its factor is the largest that limits and filter allow, or the least that the limits demand.",
    source: "this project, after Acary and Brogliato",
    verdict: Verdict::Ours,
    negations: &[Script { file: "acceleration-factor.smt2", text: include_str!("../smt/acceleration-factor.smt2") }],
    twins: &[Twin {
        without: "reachable-ray",
        script: Script {
            file: "acceleration-factor-without-reachable-ray.smt2",
            text: include_str!("../smt/acceleration-factor-without-reachable-ray.smt2"),
        },
    }],
    engines: &[],
};
