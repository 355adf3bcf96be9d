//! Claim `path-gain`: the smallest gain of the sum law that makes several constraints slide together.
//!
//! Hypotheses: `φ̇ = L_f + L_g u` with independent rows of `L_g`, `u = -u⁺ L_gᵀ s`, `s_i = [φ_i >= 0]`,
//! `μ = (L_g L_gᵀ)⁻¹ L_f >= 0`.
//!
//! ```text
//! u⁺ > max μ_i   implies   V̇ <= -(u⁺ - max μ_i) Σ φ_i⁺ < 0 outside the set,   V = ½ φᵀ (L_g L_gᵀ)⁻¹ φ
//! ```
//!
//! and with `u⁺ < max μ_i` the set of all `φ_i = 0` cannot be held.
//!
//! Source: `[G12] eq 21`, which is sufficient and can be twelve times larger.
//!
//! Derivation. `V̇ = φᵀ (μ - u⁺ s)`. For `φ_i >= 0` the term is `φ_i (μ_i - u⁺)`, for `φ_i < 0` it is `φ_i μ_i <= 0`. That the
//! gain is sharp: on the surface the mean push of each constraint would have to be `μ_i`, and a switch gives at most `u⁺`.
//! The function is [`slideway_conditioner::path::bounds::required_gain`].
//!
//! Dropped hypothesis: that the gain exceeds the largest multiplier, not just the others.

use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::bounds::required_gain;
use slideway_conditioner::path::{Constraint, Motion, PathForm, PathOutcome, PathSettings, Reserve, SwitchingLaw};
use slideway_conditioner::shapes::HalfSpace;

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop};
use crate::path_world::{APPROACH, CUTOFF, direction, dot, norm, settings};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "path-gain",
    statement: "With the sum law, u⁺ > max μ_i makes any number of independent constraints slide, however small the angles; below it they do not.",
    source: "[G12] eq 21",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[Script { file: "path-gain.smt2", text: include_str!("../smt/path-gain.smt2") }],
    twins: &[Twin {
        without: "largest-multiplier",
        script: Script {
            file: "path-gain-without-largest-multiplier.smt2",
            text: include_str!("../smt/path-gain-without-largest-multiplier.smt2"),
        },
    }],
    engines: &[Engine {
        name: "the_push_lowers_the_function_by_what_the_gain_exceeds",
        unit: "m",
        about: About::Other,
        cost: Cost::Sample,
        trial: push_lowers,
    }],
};

/// `V̇ = φᵀμ + φᵀ (L_g L_gᵀ)⁻¹ L_g u`, and with as many walls as dimensions `φ = N p` makes the second term `pᵀu / (α1² K)`: no
/// system is solved, and walls at any angle take part. `u` is the shipped conditioner's push. Rounding: some ten operations on
/// terms whose sizes are added up in `scale`.
fn push_lowers(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let normals = [direction(choices), direction(choices), direction(choices)];
    let position: [f64; 3] = choices.numbers(-1.0, 1.0);
    let multipliers: [f64; 3] = choices.numbers(0.0, 1.0);
    let gain = required_gain(&multipliers) * (1.0 + choices.decade(-3.0, 0.3));
    if !(gain > 1e-3) {
        return Err(Stop::Skipped);
    }
    let form = PathForm::Sliding { law: SwitchingLaw::Sum { gain }, reserve: Reserve::Off };
    let conditioner = PathConditioner::<3, 3>::new(PathSettings { sampling_period: 1e-3, ..settings(form) })?;
    let [one, two, three] = &normals;
    let walls = [HalfSpace::new(one, 0.0)?, HalfSpace::new(two, 0.0)?, HalfSpace::new(three, 0.0)?];
    let mut state = conditioner.at_rest(&position)?;
    let reference = Motion { time: 0.0, position, velocity: [0.0; 3] };
    let step = conditioner.step(&mut state, &reference, |m| walls.each_ref().map(|wall| wall.sample(m)));
    // Gradients that cancel to a share of 1e-9 are held.
    if matches!(step.outcome, PathOutcome::Held(_)) {
        return Err(Stop::Skipped);
    }
    let phi = normals.map(|n| dot(&n, &position));
    let falls = dot(&phi, &multipliers) + dot(&position, &step.push) / (CUTOFF * CUTOFF * APPROACH);
    let outside: f64 = phi.iter().map(|p| p.max(0.0)).sum();
    let scale = (1.0 + gain) * 10.0 * norm(&position);
    Ok(10.0 * f64::EPSILON * scale - (gain - required_gain(&multipliers)) * outside - falls)
}
