//! Claim `projection`: projecting onto a convex set brings no two points further apart, and leaves the set's own points where they are.
//!
//! Hypotheses: `S` convex and not empty, `P(x)` its nearest point to `x` (m).
//!
//! ```text
//! ‖P(x) - P(y)‖ <= ‖x - y‖,   P(P(x)) = P(x)
//! ```
//!
//! Source: standard (Hiriart-Urruty and Lemaréchal 1993, section III.3); what is tested is the shipped projection.
//!
//! Derivation. `(x - P(x))·(z - P(x)) <= 0` for every `z` of `S`; with `z = P(y)` and the same with `x` and `y` exchanged, the sum is
//! `‖P(x) - P(y)‖² <= (x - y)·(P(x) - P(y))`, and Cauchy-Schwarz finishes. A point of the set is at distance 0 from itself.
//!
//! Rounding. The solver's point `p` comes with a lower bound `l` on the distance `d`, true in floating point. The distance squared is strongly
//! convex, so `‖p - P(x)‖² <= d² - l²` if `p` is in the set. If it violates the set by `v` (the solver stops at 1e-12), `p / (1 + v / b)` is in it,
//! `b <= 1` the wall's offset: by `|p| v / b` it is elsewhere, which is added to `d` and to the answer. Lengths are rounded by two units in
//! the last place, `v` by four of the numbers it is the difference of.
//!
//! Dropped hypothesis: convexity.

use slideway_baselines::projection::Projection;
use slideway_baselines::projection::convex::{ConvexSet, project};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::path_world::norm;
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "projection",
    statement: "The projection onto a convex set is non-expansive and idempotent, to what its certificate leaves open.",
    source: "standard; Hiriart-Urruty and Lemaréchal 1993",
    verdict: Verdict::Holds,
    negations: &[
        Script { file: "projection.smt2", text: include_str!("../smt/projection.smt2") },
        Script { file: "projection-idempotent.smt2", text: include_str!("../smt/projection-idempotent.smt2") },
    ],
    twins: &[Twin {
        without: "convexity",
        script: Script {
            file: "projection-without-convexity.smt2",
            text: include_str!("../smt/projection-without-convexity.smt2"),
        },
    }],
    engines: &[Engine {
        name: "projection_is_non_expansive_and_idempotent",
        unit: "m",
        about: About::Other,
        cost: Cost::Run,
        trial: non_expansive,
    }],
};

fn distance(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt()
}

/// Greatest distance that the point can have from the nearest one, m, for a wall of this normal and offset.
fn doubt(projection: &Projection<3>, normal: &[f64; 3], offset: f64) -> f64 {
    let length = norm(&projection.point);
    let rounding = 4.0 * f64::EPSILON * (2.0 + length * norm(normal));
    let outside = length * (projection.violation + rounding).max(0.0) / offset;
    let (d, l) = (projection.distance * (1.0 + 2.0 * f64::EPSILON) + outside, projection.lower_bound);
    (((d - l).max(0.0) * (d + l)).sqrt() + outside) * (1.0 + 8.0 * f64::EPSILON)
}

fn non_expansive(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let ball = ConvexSet::Ellipsoid { centre: [0.0; 3], semi_axes: choices.numbers(0.2, 2.0) };
    let (normal, offset) = (choices.numbers(-1.0, 1.0), choices.between(0.01, 0.5));
    let wall = ConvexSet::HalfSpace { normal, offset };
    let both = [ball, wall];
    let sets = match choices.below(3) {
        0 => &both[..1],
        1 => &both[1..],
        _ => &both[..],
    };
    let x = choices.numbers::<3>(-3.0, 3.0);
    let apart = choices.decade(-3.0, 0.5);
    let y = x.map(|x| x + apart * choices.between(-1.0, 1.0));
    let projected = |x: &[f64; 3]| project(x, sets).map_err(|error| Stop::Refused(error.to_string()));
    let (p, q) = (projected(&x)?, projected(&y)?);
    let again = projected(&p.point)?;
    let doubt = |projection: &Projection<3>| doubt(projection, &normal, offset);
    // Two lengths and their sums, rounded.
    let keeps = |before: f64, after: f64| before + 4.0 * f64::EPSILON * (before + after) - after;
    let closer = keeps(distance(&x, &y) + doubt(&p) + doubt(&q), distance(&p.point, &q.point));
    let stays = keeps(doubt(&again) + doubt(&p), distance(&p.point, &again.point));
    Ok(worse(closer, stays))
}
