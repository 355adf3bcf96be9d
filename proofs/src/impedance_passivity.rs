//! Claim `impedance-passivity`: impedance control stores no more energy than pushes put in.
//!
//! Hypotheses: `τ = Jᵀ (K e - D ẋ) + g(q)` with the arm's own `g` (N·m), `K` and `D` diagonal, `D >= 0`, the reference at rest, torques inside
//! their limits; for rotations one stiffness, and an error below half a turn.
//!
//! ```text
//! V = ½ q̇ᵀ M q̇ + ½ eᵀ K e          V̇ = q̇ᵀ p - ẋᵀ D ẋ <= q̇ᵀ p          p torques of what pushes the arm
//! ```
//!
//! Source: `[R16]` has the mass-spring-damper only, its spring and damper with the wrong signs, and no passivity.
//!
//! Derivation. `M q̈ = Jᵀ (K e - D ẋ) + p - C q̇`; `Ṁ = C + Cᵀ`, so that `½ q̇ᵀ Ṁ q̇` cancels `q̇ᵀ C q̇`; `ė = -J q̇`, so that the spring's rate
//! cancels `ẋᵀ K e`. For a rotation `½ k |log R|²` has the gradient `k log R`, the argument of the claim's linear rows again.
//!
//! Dropped hypothesis: the weight is exact.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "impedance-passivity",
    statement: "Under impedance control with exact gravity compensation and a reference at rest, kinetic and spring energy grow by no more than the work of what pushes the arm.",
    source: "ours; [R16] force and impedance control has the equation",
    verdict: Verdict::Ours,
    negations: &[Script { file: "impedance-passivity.smt2", text: include_str!("../smt/impedance-passivity.smt2") }],
    twins: &[Twin {
        without: "exact-weight",
        script: Script {
            file: "impedance-passivity-without-exact-weight.smt2",
            text: include_str!("../smt/impedance-passivity-without-exact-weight.smt2"),
        },
    }],
    engines: &[],
};
