//! Claim `queue-continuity`: under any sequence of commands the set-points of a queue are continuous and keep their limits.
//!
//! Hypotheses: each motion `Q(s)` keeps speed and acceleration limits by plan, from rest to rest or from the present state. A change of
//! the pace `r = ṡ`, with slope `w`, is accepted only if over each of its spans, in which `r`, `w`, `Q'` and `Q''` cover intervals,
//!
//! ```text
//! -A <= min(r r Q'') + min(w Q'),   max(r r Q'') + max(w Q') <= A        extremes over the corners of the intervals
//! ```
//!
//! Then `|r² Q'' + w Q'| <= A` at every instant (`q̈` of the set-point `q = Q(s)`), so that over `h` seconds no joint's speed changes by
//! more than `A h` and its position by no more than `A h² / 2` beside `q̇ h`. On the way the set-point is a point of the planned path: a brake
//! on the path stays on it.
//!
//! Source: this project; `[R16]` asks for it.
//!
//! Derivation. A bilinear function over a box has its extremes in the corners, `r r Q''` by two such steps; sums of bounds bound the
//! sum; the mean value theorem gives the rest. An interruption starts from the set-point given out last.
//!
//! Rounding. Intervals are rounded to nearest and compared with a slack of 1e-9 of the limit. Motions that begin in motion end within
//! 2e-8 of their target, the accuracy of their planner.
//!
//! Dropped hypothesis: that the limit is checked over the whole span, not at its ends alone.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "queue-continuity",
    statement: "Under any sequence of commands, interruptions and changes of pace the set-points of a motion queue are continuous with their velocities, and no joint's acceleration exceeds its limit.",
    source: "this project; asked for by [R16]",
    verdict: Verdict::Ours,
    negations: &[
        Script { file: "queue-continuity.smt2", text: include_str!("../smt/queue-continuity.smt2") },
        Script { file: "queue-continuity-sum.smt2", text: include_str!("../smt/queue-continuity-sum.smt2") },
    ],
    twins: &[Twin {
        without: "whole-span",
        script: Script {
            file: "queue-continuity-without-whole-span.smt2",
            text: include_str!("../smt/queue-continuity-without-whole-span.smt2"),
        },
    }],
    engines: &[],
};
