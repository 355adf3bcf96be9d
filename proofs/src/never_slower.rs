//! Claim `never-slower`: sliding-mode regulation is never slower than natural motion under the same joint-speed limits.
//!
//! Hypotheses: the robot on the path (`A = 0`), limits `l > 0` (rad/s), joint speed `v` per unit of path rate; natural motion at
//! a path rate `s` within the limits and not above the target rate `λ̇d` (1/s); the implicit form with its filter settled: the
//! factor is the largest the limits allow, not held down by `(1 - a) f_before + a`.
//!
//! ```text
//! |v_i| s <= l_i,  s <= λ̇d,  f = f*   =>   s <= f λ̇d
//! ```
//!
//! Source: this project.
//!
//! Derivation. Either `f* = 1`, then `f λ̇d = λ̇d >= s`; or one joint is at its limit, `f λ̇d |v_i| = l_i >= s |v_i|` with `v_i ≠ 0`.
//! It holds place by place, so over any stretch in which the filter stays settled the regulated motion takes no longer. The
//! explicit form chatters about the same rate and falls short of it by its band (claims [`crate::frozen_band`],
//! [`crate::drifting_band`]).
//!
//! Dropped hypothesis: the filter has settled.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "never-slower",
    statement: "On the path and with its filter settled, the implicit form runs at least as fast as natural motion at every place, if natural motion keeps the same joint-speed limits and the target rate is no lower than its rate.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[Script { file: "never-slower.smt2", text: include_str!("../smt/never-slower.smt2") }],
    twins: &[Twin {
        without: "settled-filter",
        script: Script {
            file: "never-slower-without-settled-filter.smt2",
            text: include_str!("../smt/never-slower-without-settled-filter.smt2"),
        },
    }],
    engines: &[],
};
