//! Claim `weak-duality`: the certificate's lower bound on the travel time is valid for every profile and every multipliers.
//!
//! Hypotheses: a discretised program of [`slideway_baselines::time_optimal`] (`h > 0`, `0 <= x <= cap`, rows `A x <= c`), any profile `x̂ > 0`;
//! multipliers are arbitrary numbers, NaN, infinities and negative ones included.
//!
//! ```text
//! T(x) >= T(x̂) - ∇T(x̂)·x̂ - μ⁺·c + Σ_k min over 0 <= x_k <= cap_k of (∇T(x̂) + Aᵀμ⁺)_k x_k   for every feasible x
//! ```
//!
//! Source: Verscheure et al. 2009 for the program; the bound is this project's.
//!
//! Derivation. `T` is a sum of convex functions `2 h / (√x_k + √x_{k+1})`, each above its tangent (first script). For feasible `x` and
//! `μ >= 0`, `μ·(A x - c) <= 0` may be added, and the minimum over the box is no larger than the value at `x` (second script).
//! Where the arithmetic overflows the bound is not a number, which no comparison accepts.
//!
//! Dropped hypothesis: that multipliers are at least 0. The shipped function takes negative ones, and NaN, for 0.

use slideway_baselines::time_optimal::{PieceProgram, feasible_time, lower_bound, repair};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop};
use crate::random_program::{nonsense, random_path};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "weak-duality",
    statement: "The dual bound of the time optimum is valid whatever the profile and the multipliers are, nonsense included.",
    source: "Verscheure et al. 2009",
    verdict: Verdict::Ours,
    negations: &[
        Script { file: "weak-duality-tangent.smt2", text: include_str!("../smt/weak-duality-tangent.smt2") },
        Script { file: "weak-duality-rows.smt2", text: include_str!("../smt/weak-duality-rows.smt2") },
    ],
    twins: &[Twin {
        without: "signs",
        script: Script {
            file: "weak-duality-without-signs.smt2",
            text: include_str!("../smt/weak-duality-without-signs.smt2"),
        },
    }],
    engines: &[Engine {
        name: "no_multipliers_lift_the_bound_above_a_feasible_time",
        unit: "share of the time",
        about: About::Other,
        cost: Cost::Run,
        trial: bound_is_below,
    }],
};

/// No slack: the bound is rounded downwards, the time upwards.
fn bound_is_below(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let path = random_path(choices);
    let program = PieceProgram::new(&path, 0).map_err(|_| Stop::Skipped)?;
    let size = choices.decade(-3.0, 1.0);
    let at_cap = choices.flag();
    let wanted: Vec<f64> = program.cap.iter().map(|cap| if at_cap { *cap } else { cap * choices.unit() }).collect();
    let feasible = repair(&program, &wanted).map_err(|_| Stop::Skipped)?;
    let tangent_at: Vec<f64> = match choices.below(3) {
        0 => feasible.clone(),
        1 => program.cap.iter().map(|cap| cap.max(f64::MIN_POSITIVE) * (1e-6 + choices.unit())).collect(),
        _ => program.cap.iter().map(|_| choices.decade(-6.0, 6.0)).collect(),
    };
    let kind = choices.below(3);
    let multipliers: Vec<f64> = (0..program.row_count())
        .map(|_| match kind {
            0 => 0.0,
            1 => (choices.unit() - 0.5) * size,
            _ => nonsense(choices, size),
        })
        .collect();
    let (time, bound) = (feasible_time(&program, &feasible).hi, lower_bound(&program, &tangent_at, &multipliers).lo);
    // Not a number is not a bound: whoever compares with it gets no certificate.
    Ok(if bound.is_nan() { f64::INFINITY } else { (time - bound) / time })
}
