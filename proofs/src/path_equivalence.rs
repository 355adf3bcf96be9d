//! Claim `path-equivalence`: the equivalent control of the sliding mode is the optimum of the safety filter.
//!
//! Hypotheses: `μ = (L_g L_gᵀ)⁻¹ L_f >= 0`, `u_eq = -L_gᵀ μ`.
//!
//! ```text
//! u_eq = argmin ‖u‖²   subject to   L_f + L_g u <= 0,   with multipliers μ
//! ```
//!
//! Source: this project; `φ <= 0` is a control-barrier condition of rate `1 / K`.
//!
//! Derivation. The optimality conditions of that convex program are `u = -L_gᵀ μ`, `μ >= 0`, `L_f + L_g u <= 0` and
//! `μᵀ (L_f + L_g u) = 0`. With every constraint at equality, `L_f - L_g L_gᵀ μ = 0`, they hold, and they are sufficient: for
//! an admissible `v = u + d` they give `uᵀd = -Σ μ_i g_iᵀd >= 0`, so `‖v‖² = ‖u‖² + 2 uᵀd + ‖d‖² >= ‖u‖²`.
//!
//! Dropped hypothesis: `μ_2 >= 0`. The optimum then lets that constraint go.

use slideway_baselines::safety_filter::enumeration::smallest;

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::path_world::{direction, dot};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "path-equivalence",
    statement: "Where μ = (L_g L_gᵀ)⁻¹ L_f >= 0, the equivalent control -L_gᵀ μ is the smallest u with L_f + L_g u <= 0, and μ are its multipliers.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[Script { file: "path-equivalence.smt2", text: include_str!("../smt/path-equivalence.smt2") }],
    twins: &[Twin {
        without: "positive-multiplier",
        script: Script {
            file: "path-equivalence-without-positive-multiplier.smt2",
            text: include_str!("../smt/path-equivalence-without-positive-multiplier.smt2"),
        },
    }],
    engines: &[Engine {
        name: "the_equivalent_control_is_the_optimum_of_the_program",
        unit: "m",
        about: About::Other,
        cost: Cost::Sample,
        trial: control_is_optimal,
    }],
};

/// `|n1 (n2 x n3)|`: the volume the normals span, 0 where they depend on one another.
fn volume([a, b, c]: &[[f64; 3]; 3]) -> f64 {
    let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
    dot(a, &cross).abs()
}

/// The twin enumerates every active set. Rows with a volume above 0.05 have a Gram matrix of condition below
/// `3³ / 0.05² = 1e4`; 1e-15 times it, times vectors up to 6, is below 1e-10.
fn control_is_optimal(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let normals = [direction(choices), direction(choices), direction(choices)];
    let multipliers: [f64; 3] = std::array::from_fn(|_| 2.0 * choices.share());
    if !(volume(&normals) > 0.05) {
        return Err(Stop::Skipped);
    }
    let mut control = [0.0; 3];
    for (normal, mu) in normals.iter().zip(&multipliers) {
        control = std::array::from_fn(|i| control[i] - mu * normal[i]);
    }
    // L_f = L_g L_gᵀ μ = -L_g u_eq makes μ the multipliers; the program asks for L_g u <= -L_f.
    let rows: Vec<Vec<f64>> = normals.iter().map(|n| n.to_vec()).collect();
    let bounds: Vec<f64> = normals.iter().map(|n| dot(n, &control)).collect();
    let found = smallest(&rows, &bounds).ok_or_else(|| Stop::Refused("no admissible control".to_owned()))?;
    Ok(found.iter().zip(&control).fold(f64::INFINITY, |margin, (f, u)| worse(margin, 1e-10 - (f - u).abs())))
}
