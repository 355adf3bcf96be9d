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

use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{Motion, PathOutcome};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop, exactly, worse};
use crate::path_world::{APPROACH, Body, Sketch, Swing, implicit, norm, settings};
use crate::subject::Subject;

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
    engines: &[
        Engine {
            name: "one_wall_or_ball_is_kept_at_every_sample",
            unit: "m",
            about: About::Other,
            cost: Cost::Run,
            trial: stays_inside::<1>,
        },
        Engine {
            name: "triples_of_walls_and_balls_are_kept_at_every_sample",
            unit: "m",
            about: About::Other,
            cost: Cost::Run,
            trial: stays_inside::<3>,
        },
    ],
};

/// Bodies around the start of a random reference, nearer to it than those of other claims: a run that meets none does not count.
pub(crate) fn bodies<const M: usize>(choices: &mut Choices, swing: &Swing) -> Result<[Body; M], Stop> {
    let near = |sketch: Sketch| Sketch { room: 0.25 * sketch.room, ..sketch };
    let found: [Option<Body>; M] = std::array::from_fn(|_| near(Sketch::draw(choices, 3)).around(&swing.at(0)));
    let bodies: Vec<Body> = found.into_iter().flatten().collect();
    bodies.try_into().map_err(|_| Stop::Skipped)
}

/// The motions of a reference from the sample before the first that touches a body; a run that touches none does not count.
///
/// Until then a conditioner leaves the reference as it is, and its state with it: it may as well begin there.
pub(crate) fn from_first_contact<const M: usize>(swing: &Swing, bodies: &[Body; M]) -> Result<Vec<Motion<3>>, Stop> {
    let touches = |m: &Motion<3>| bodies.iter().any(|body| body.sample(m).phi(APPROACH, &m.velocity) >= 0.0);
    let mut motions: Vec<Motion<3>> = swing.samples().take(300).collect();
    let first = motions.iter().position(touches).ok_or(Stop::Skipped)?;
    Ok(motions.split_off(first.saturating_sub(1)))
}

/// A run from an admissible start with the reference's velocity. Only runs in which something acted count.
///
/// Rounding of `φ`: rows of condition up to 1e3, times 1e-16, times positions and `K` times velocities as they occur.
fn stays_inside<const M: usize>(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let swing = Swing::draw(choices);
    let bodies = bodies::<M>(choices, &swing)?;
    let conditioner = PathConditioner::<3, M>::new(settings(implicit()))?;
    let mut state = conditioner.on_reference();
    let (mut margin, mut acted) = (f64::INFINITY, false);
    for reference in &from_first_contact(&swing, &bodies)? {
        let step = conditioner.step(&mut state, reference, |m| bodies.each_ref().map(|body| body.sample(m)));
        let held = matches!(step.outcome, PathOutcome::Held(_));
        acted |= step.outcome == PathOutcome::Acting;
        let rounding = 1e-12 * (1.0 + norm(&step.motion.position) + APPROACH * norm(&step.motion.velocity));
        for phi in &step.phi {
            margin = worse(margin, if held { exactly(M > 1) } else { rounding - phi });
        }
    }
    if acted { Ok(margin) } else { Err(Stop::Skipped) }
}
