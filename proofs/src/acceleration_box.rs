//! Claim `acceleration-box`: speeds and accelerations stay inside their limits, whatever is asked.
//!
//! Hypotheses: `lower < 0 < upper` (rad/s), `a_lower < 0 < a_upper` (rad/s²), `Ts > 0` (s), the previous command `p` inside the speed
//! limits. The demand is arbitrary; NaN and infinities brake.
//!
//! ```text
//! low = clamp(p + Ts a_lower), high = clamp(p + Ts a_upper),  clamp(v) = min(max(v, lower), upper)
//! command = min(max(demand, low), high)
//! ```
//!
//! Source: this project.
//!
//! Derivation. `p + Ts a_lower < p < p + Ts a_upper` and `lower <= p <= upper`, so `low <= p <= high`: the box is not empty, and its
//! ends are no further from `p` than the acceleration limits allow. By induction every command is the next sample's `p`.
//!
//! Rounding. The speed limits hold to the last bit, for the clamp comes last. `Ts a` and `p + Ts a` round once each, so the change holds
//! to one unit in the last place of `|p| + Ts |a|`.
//!
//! Dropped hypothesis: that the previous command is inside the speed limits.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "acceleration-box",
    statement: "For any demand whatever the acceleration-limited command lies inside the speed limits and within the acceleration limits of the command before.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[Script { file: "acceleration-box.smt2", text: include_str!("../smt/acceleration-box.smt2") }],
    twins: &[Twin {
        without: "previous-inside",
        script: Script {
            file: "acceleration-box-without-previous-inside.smt2",
            text: include_str!("../smt/acceleration-box-without-previous-inside.smt2"),
        },
    }],
    engines: &[],
};
