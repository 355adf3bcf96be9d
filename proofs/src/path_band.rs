//! Claim `path-band`: how far `φ` leaves zero on one constraint in the explicit form.
//!
//! Hypotheses: zero-order hold or Euler's rule, full push `G` and drift `D_min <= D <= D̄` per sample (units of `σ`),
//! `0 <= D̄ <= G`, `φ[0] <= D̄`; for the lower end `0 <= D_min` and `φ[0] >= -(G - D_min)⁺` as well.
//!
//! ```text
//! φ[k+1] = φ[k] + D[k] - G [φ[k] >= 0],     -(G - D_min)⁺ <= φ[k] <= D̄
//! ```
//!
//! Source: `[G12] eq 22` gives the width `G` as an estimate for both ends.
//!
//! Derivation. From `φ < 0` one drift leads to at most `D̄`; from `0 <= φ <= D̄` the push takes back at least the drift.
//! From `φ >= 0` the fall is at most `G - D_min`; from below zero `φ` does not fall if `D >= 0`. On a curved boundary `G`
//! is different at every sample, and all that is used is `D[k] <= G[k]`. The function is
//! [`slideway_conditioner::path::bounds::band`].
//!
//! Dropped hypotheses: `D̄ <= G`, and `0 <= D_min`.

use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::bounds::band;
use slideway_conditioner::path::{Constraint, Motion};
use slideway_conditioner::shapes::HalfSpace;

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop, exactly, worse};
use crate::path_world::{APPROACH, direction, dot, explicit, per_push, settings};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "path-band",
    statement: "Explicit form, one constraint, drifts D_min <= D <= D̄ <= G per sample: φ <= D̄, and for D_min >= 0 also φ >= -(G - D_min)⁺.",
    source: "[G12] eq 22",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[
        Script { file: "path-band.smt2", text: include_str!("../smt/path-band.smt2") },
        Script { file: "path-band-lower.smt2", text: include_str!("../smt/path-band-lower.smt2") },
    ],
    twins: &[
        Twin {
            without: "push-beating-drift",
            script: Script {
                file: "path-band-without-push-beating-drift.smt2",
                text: include_str!("../smt/path-band-without-push-beating-drift.smt2"),
            },
        },
        Twin {
            without: "rising-drift",
            script: Script {
                file: "path-band-without-rising-drift.smt2",
                text: include_str!("../smt/path-band-without-rising-drift.smt2"),
            },
        },
    ],
    engines: &[Engine {
        name: "one_sample_keeps_the_band",
        unit: "m",
        about: About::Other,
        cost: Cost::Sample,
        trial: one_sample_keeps,
    }],
};

/// Rounding: some 30 operations on numbers below 10 (positions of 1, velocities of 1 over the push of a sample).
fn one_sample_keeps(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let (normal, offset, push) = (direction(choices), choices.between(-1.0, 1.0), choices.between(0.01, 1.0));
    let velocity: [f64; 3] = choices.numbers(-1.0, 1.0);
    // D_min <= D <= D̄ <= G, and φ anywhere in the band.
    let (smallest, place, start) = (choices.share(), choices.share(), choices.share());
    let largest = push * smallest.max(0.5);
    let (least, drift) = (smallest * largest, largest * (smallest + place * (1.0 - smallest)));
    let band = band(push, least, largest);
    let phi = band.lower + start * (band.upper - band.lower);
    let wall = HalfSpace::new(&normal, offset)?;
    let conditioner = PathConditioner::<3, 1>::new(settings(explicit(push / per_push())))?;
    let mut state = conditioner.on_reference();
    // A reference anywhere on the plane φ = wanted, with any velocity.
    let mut at = |wanted: f64, velocity: [f64; 3]| {
        let along = offset + wanted - APPROACH * dot(&normal, &velocity);
        let reference = Motion { time: 0.0, position: normal.map(|n| along * n), velocity };
        let [phi] = conditioner.step(&mut state, &reference, |m| [wall.sample(m)]).phi;
        phi
    };
    let before = at(phi, velocity);
    let after = at(before + drift, velocity.map(|v| -v));
    let margin = worse(band.upper + 1e-13 - after, after - band.lower + 1e-13);
    Ok(worse(margin, exactly((before - phi).abs() <= 1e-14)))
}
