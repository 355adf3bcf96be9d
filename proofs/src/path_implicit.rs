//! Claim `path-implicit`: the implicit form keeps `φ_i <= 0` at every sample, from any admissible state.
//!
//! Hypotheses: `φ_i <= 0` at the first sample, rows `g_i = ∂φ_i/∂u` independent where more than one constraint acts and not
//! empty. References are arbitrary.
//!
//! ```text
//! φ_i[k] <= 0 for every i and k, to rounding;   σ_i <= max(σ_i[0], T² sup |φ̈_i| / 8)
//! ```
//!
//! Source: this project, after Acary and Brogliato's implicit discretisation of set-valued controllers.
//!
//! Derivation. One constraint: `u = -g φ⁺ / gᵀg` gives `φ + gᵀu = min(φ, 0)`. Two: one of the four active sets meets the
//! optimality conditions, so the smallest push exists and is a closed form. More: independent rows have a common solution of
//! all equations, so the half-spaces have a common point. Repeated linearisation reaches the curved boundaries. Where the
//! hypotheses fail the sample is held, at rest, and then `φ_i = σ_i <= 0` on every constraint that stands still. The bound on
//! `σ` is the claim [`crate::path_lag`].
//!
//! Dropped hypotheses: independence, and a gradient that is not empty.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "path-implicit",
    statement: "From any admissible state the implicit form has φ_i <= 0 at every sample on walls, balls, pairs and triples with independent rows, whatever the reference.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[
        Script { file: "path-implicit.smt2", text: include_str!("../smt/path-implicit.smt2") },
        Script { file: "path-implicit-pair.smt2", text: include_str!("../smt/path-implicit-pair.smt2") },
    ],
    twins: &[
        Twin {
            without: "independence",
            script: Script {
                file: "path-implicit-without-independence.smt2",
                text: include_str!("../smt/path-implicit-without-independence.smt2"),
            },
        },
        Twin {
            without: "gradient",
            script: Script {
                file: "path-implicit-without-gradient.smt2",
                text: include_str!("../smt/path-implicit-without-gradient.smt2"),
            },
        },
    ],
    engines: &[],
};
