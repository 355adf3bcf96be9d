//! Claim `acceleration-factor`: the direction of the demand is kept whenever some factor allows it.
//!
//! Hypotheses: the box of a sample (rad/s), `q̇d(f) = A + f B` (rad/s), and `F = { f in [0, 1] : q̇d(f) in the box }` not empty.
//!
//! ```text
//! F = [f_least, f_greatest] in closed form,   f = max(f_least, min((1 - a) f_prev + a, f_greatest)),   q̇d(f) in the box
//! ```
//!
//! Source: this project, after Acary and Brogliato's implicit discretisation.
//!
//! Derivation. Joint by joint `low <= A + f B <= high` is an interval in `f`; their intersection with [0, 1] is one. The factor is its
//! point nearest to what the filter allows from below, or its least one where the filter allows less.
//!
//! Dropped hypothesis: a reachable point on the ray. This is also what no regulator without look-ahead can avoid: with `|p_1| > Ts a_1`
//! the path may go on without joint 1, and `A_1 + f B_1 = 0` is out of reach for every `f`. The command is then the point of the box
//! nearest to the demand that exceeds it least.

use slideway_conditioner::acceleration::{AccelerationLimits, AccelerationState, PathKeeping};
use slideway_conditioner::{AffineSpeed, FirstOrderFilter, SpeedLimits};

use crate::acceleration_box::regulator;
use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{TS, filter_step};
use crate::engine::{About, Choices, Cost, Engine, Stop, exactly};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "acceleration-factor",
    statement: "Whenever some factor in [0, 1] makes the demand reachable the command is the demand, and its factor is the largest that limits and filter allow, or the least that the limits demand.",
    source: "this project, after Acary and Brogliato",
    verdict: Verdict::Ours,
    negations: &[Script { file: "acceleration-factor.smt2", text: include_str!("../smt/acceleration-factor.smt2") }],
    twins: &[Twin {
        without: "reachable-ray",
        script: Script {
            file: "acceleration-factor-without-reachable-ray.smt2",
            text: include_str!("../smt/acceleration-factor-without-reachable-ray.smt2"),
        },
    }],
    engines: &[Engine {
        name: "a_reachable_ray_is_kept_with_the_largest_factor_that_limits_and_filter_allow",
        unit: "yes or no",
        about: About::Other,
        cost: Cost::Sample,
        trial: largest_factor,
    }],
};

/// A previous command near the demand at some factor, so that the ray meets the box. A millionth above the factor found none is both
/// allowed by the filter and reachable; a millionth of `B` is far above rounding.
fn largest_factor(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let desired = AffineSpeed::<3> { feedback: choices.numbers(-0.3, 0.3), feedforward: choices.numbers(-0.6, 0.6) };
    let (near, before, a) = (choices.share(), choices.share(), filter_step(choices));
    let limits = SpeedLimits::symmetric([1.0; 3])?;
    let regulator = regulator(limits, AccelerationLimits::symmetric([2.0; 3])?, a)?;
    let mut speed = desired.at(near);
    for v in &mut speed {
        *v += 2.0 * TS * choices.between(-0.999, 0.999);
    }
    let mut state = AccelerationState::moving(before, speed, &limits)?;
    let command = regulator.step(&mut state, &desired);
    let risen = FirstOrderFilter::new(a / TS, TS)?.next(before, 1.0);
    let above = command.factor + 1e-6;
    let reaches =
        |factor: f64| desired.at(factor).iter().zip(&speed).all(|(v, p)| (v - p).abs() <= 2.0 * TS && v.abs() <= 1.0);
    let size = desired.feedforward.iter().fold(0.0_f64, |s, b| s.max(b.abs()));
    let largest = above > risen.min(1.0) || size < 1e-6 || !reaches(above) || !reaches(command.factor);
    Ok(exactly(command.keeping == PathKeeping::OnPath && largest))
}
