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
//! Rounding. The solver's point `p` lies in the set to its violation `v` and comes with a lower bound `l` on the distance `d`. The distance squared is
//! strongly convex, so `‖p - P(x)‖² <= d² - l²` where `v <= 0`. A point with `v > 0` (the solver stops at 1e-12) is a point of the set widened by
//! `v`; its distance is counted as `d + 2 v`, semi-axes and normals being at most 2 long, and `2 v` is added.
//!
//! Dropped hypothesis: convexity.

use slideway_baselines::projection::Projection;
use slideway_baselines::projection::convex::{ConvexSet, project};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
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

/// How far the point can be from the nearest one. The roundings of `d² - l²`, some four of `d²`, are added.
fn doubt(projection: &Projection<3>) -> f64 {
    let outside = 2.0 * projection.violation.max(0.0);
    let (d, l) = (projection.distance + outside, projection.lower_bound);
    ((d - l).max(0.0) * (d + l) + 4.0 * f64::EPSILON * d * d).sqrt() + outside
}

fn non_expansive(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let ball = ConvexSet::Ellipsoid { centre: [0.0; 3], semi_axes: choices.numbers(0.2, 2.0) };
    let wall = ConvexSet::HalfSpace { normal: choices.numbers(-1.0, 1.0), offset: choices.between(0.01, 0.5) };
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
    let closer = distance(&x, &y) + doubt(&p) + doubt(&q) - distance(&p.point, &q.point);
    let stays = doubt(&again) + doubt(&p) + 12.0 * f64::EPSILON - distance(&p.point, &again.point);
    Ok(worse(closer, stays))
}
