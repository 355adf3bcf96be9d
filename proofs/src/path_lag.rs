//! Claim `path-lag`: `σ` never exceeds the largest `φ` so far, if it starts below it.
//!
//! Hypotheses: `K > 0` (s), `φ = σ + K σ̇`.
//!
//! ```text
//! σ(t) <= max(σ(0), sup φ over [0, t])
//! ```
//!
//! Source: `[G12] eq 3`, which calls `φ <= 0` the modified constraint; the bound for a `φ` that chatters is this project's.
//!
//! Derivation. `K σ̇ + σ = φ` is a first-order lag of unit gain: over any interval `σ' = e σ + (1 - e) m` with
//! `e = exp(-T/K)` and `m` a mean of `φ` over the interval. The supremum is over time, not over samples: between samples
//! `φ` can bulge by `T² sup |φ̈| / 8`, see [`slideway_conditioner::path::bounds::between_samples`].
//!
//! Dropped hypothesis: `K > 0` (a parameter the conditioner refuses).

use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::PathOutcome;

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::path_world::{Sketch, Suprema, Swing, explicit, settings};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "path-lag",
    statement: "With φ = σ + K σ̇ and K > 0, σ never exceeds the larger of its start and the supremum of φ over time.",
    source: "[G12] eq 3",
    verdict: Verdict::Holds,
    negations: &[Script { file: "path-lag.smt2", text: include_str!("../smt/path-lag.smt2") }],
    twins: &[Twin {
        without: "approach",
        script: Script {
            file: "path-lag-without-approach.smt2",
            text: include_str!("../smt/path-lag-without-approach.smt2"),
        },
    }],
    engines: &[
        Engine {
            name: "a_lag_of_held_values_stays_below_the_largest",
            unit: "1",
            about: About::Other,
            cost: Cost::Sample,
            trial: lag_stays_below,
        },
        Engine {
            name: "sigma_never_exceeds_the_largest_phi",
            unit: "m",
            about: About::Other,
            cost: Cost::Run,
            trial: sigma_stays_below,
        },
    ],
};

/// One rounding of a number up to 2 per sample, 60 samples.
fn lag_stays_below(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let memory = (-choices.between(0.001, 2.0)).exp();
    let (mut sigma, mut largest, mut margin) = (-1.0_f64, f64::NEG_INFINITY, f64::INFINITY);
    for _ in 0..1 + choices.below(60) {
        let phi = choices.between(-1.0, 1.0);
        largest = largest.max(phi);
        sigma += (1.0 - memory) * (phi - sigma);
        margin = worse(margin, largest + 1e-13 - sigma);
    }
    Ok(margin)
}

/// The explicit form on one wall or ball, pushes that suffice and pushes that do not. What `φ` does between samples is bounded by the
/// motion itself; rounding, 1e-12, is nothing beside it.
fn sigma_stays_below(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let (swing, amplitude) = (Swing::draw(choices), choices.between(0.02, 3.0));
    let body = Sketch::draw(choices, 3).around(&swing.at(0)).ok_or(Stop::Skipped)?;
    let conditioner = PathConditioner::<3, 1>::new(settings(explicit(amplitude)))?;
    let mut state = conditioner.on_reference();
    let (mut suprema, mut largest, mut closest) = (Suprema::default(), f64::NEG_INFINITY, f64::INFINITY);
    let mut margin = f64::INFINITY;
    for k in 0..300 {
        let reference = swing.at(k);
        let step = conditioner.step(&mut state, &reference, |m| [body.sample(m)]);
        let ([sigma], [phi]) = (step.sigma, step.phi);
        // Next to the centre of a ball the derivatives have no useful bound.
        closest = body.radius(sigma).min(closest);
        if matches!(step.outcome, PathOutcome::Held(_)) || closest < 0.02 {
            break;
        }
        let rate = std::array::from_fn(|i| step.motion.velocity[i] - reference.velocity[i]);
        suprema.see(&swing, &step.correction, &rate, &step.push);
        largest = if k == 0 { sigma } else { largest }.max(phi);
        margin = worse(margin, largest + suprema.bulge(1.0 / closest) - sigma);
    }
    Ok(margin)
}
