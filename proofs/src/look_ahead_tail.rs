//! Claim `look-ahead-tail`: a stop that exists in the window at one sample exists at the next.
//!
//! Hypotheses: between two nodes `v = dq/dλ` and `b = λ̇²` are linear in `λ`; the joint acceleration `v λ̈ + v' b` keeps its limits
//! `a_lower < 0 < a_upper` at both ends. Rates `w`, `w2` are held for one sample each, and evaluated at `x = λ + Ts w / 2`.
//!
//! ```text
//! x2 - x = Ts (w + w2) / 2,   w2 = w + Ts λ̈   =>   w2² = w² + 2 λ̈ (x2 - x)        the samples lie on the plan
//! Ts a_lower <= v(x2) w2 - v(x) w <= Ts a_upper                                    and keep the acceleration limits
//! c (v λ̈ + v' b) inside as well for 0 <= c <= 1                                   as does any profile scaled towards rest
//! ```
//!
//! Source: this project, after the controllable sets of Pham and Pham 2018.
//!
//! Derivation. The joint acceleration along the piece is linear in `x`, so it keeps its limits between the ends, and the change of the
//! joint speed is its integral over `Ts`. A plan over several intervals is a chain of such pieces. Rest is admissible everywhere, so a
//! window that grows at its far end keeps every old plan, followed by a stand.
//!
//! Not covered: a sample in which the plan's `λ̈` jumps, at a node, where the two halves of the sample belong to two pieces and the
//! place is off the plan by up to `Ts² |Δλ̈| / 8` (random zigzag paths: an excess of some thousandths of the limit). And the joints are
//! commanded `v(λ) w`, not `v(x) w`, and `v` bends between the nodes. The margin is for all three.
//!
//! Dropped hypothesis: the midpoint. Evaluated at `λ` itself the rate falls faster than the plan's deceleration.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "look-ahead-tail",
    statement: "If a stop inside the window exists at one sample, the plan cut at its front is one at the next: between two nodes of the preview it changes the joint speeds at the midpoints of the samples by no more than the acceleration limits allow, and slower profiles keep them too.",
    source: "this project, after the controllable sets of Pham and Pham 2018",
    verdict: Verdict::Ours,
    negations: &[Script { file: "look-ahead-tail.smt2", text: include_str!("../smt/look-ahead-tail.smt2") }],
    twins: &[Twin {
        without: "midpoint",
        script: Script {
            file: "look-ahead-tail-without-midpoint.smt2",
            text: include_str!("../smt/look-ahead-tail-without-midpoint.smt2"),
        },
    }],
    engines: &[],
};
