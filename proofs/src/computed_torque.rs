//! Claim `computed-torque`: under computed torque the error of every joint obeys the same linear equation.
//!
//! Hypotheses: the model is the arm's (`M`, `c`, `g`), `M` positive definite, torques inside their limits (N·m).
//!
//! ```text
//! M q̈ + c + g = τ = M (q̈d + Kp e + Kd ė) + c + g  =>  ë + Kd ė + Kp e = 0
//! ```
//!
//! Source: `[R16]`, computed torque control, whose acceleration has the errors `q - q_D` and the minus signs that go with them.
//!
//! Derivation. `M` is regular, so the two sides have the same acceleration; `e = qd - q`.
//!
//! Dropped hypothesis: the model is exact.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "computed-torque",
    statement: "With an exact model the acceleration under computed torque is q̈d + Kp e + Kd ė: the error of every joint obeys ë + Kd ė + Kp e = 0.",
    source: "[R16] feed-forward torque control",
    verdict: Verdict::Holds,
    negations: &[Script { file: "computed-torque.smt2", text: include_str!("../smt/computed-torque.smt2") }],
    twins: &[Twin {
        without: "exact-model",
        script: Script {
            file: "computed-torque-without-exact-model.smt2",
            text: include_str!("../smt/computed-torque-without-exact-model.smt2"),
        },
    }],
    engines: &[],
};
