//! Claim `implicit-band`: the implicit form does not chatter.
//!
//! Hypotheses: `q̇d(f) = A + f B` (rad/s), `lower <= A <= upper` for every joint, `lower < 0 < upper`, `0 < a <= 1`, `f_before` in
//! [0, 1].
//!
//! ```text
//! f* = max { f in [0, 1] : lower <= A + f B <= upper },   f = min((1 - a) f_before + a, f*)
//! m = ‖F_N (A + f B)‖∞ <= 1,   f <= (1 - a) f_before + a
//! ```
//!
//! Source: this project, after Acary and Brogliato's implicit discretisation of set-valued controllers.
//!
//! Derivation. Joint by joint the closed form `f <= (limit - A) / B`, with the limit the joint moves towards, is exactly
//! `A + f B <= limit` (or `>=`); the limits are convex, so every smaller `f >= 0` is admissible too, and none above `f*` is.
//!
//! Rounding. Over doubles the difference, the quotient and the product each add one rounding `e = 2^-53` relative to
//! `limit - A`, the sum and the final ratio one each relative to the limit, so
//!
//! ```text
//! m <= 1 + e (2 + 3 (1 + κ)) + O(e²),   κ = largest of |lower / upper| and |upper / lower| over the joints
//! ```
//!
//! which is four units in the last place of 1 for symmetric limits and **grows with the asymmetry of the limits**: a joint allowed
//! 1 rad/s one way and 1000 rad/s the other can overshoot the narrow limit by 3e-13 of it. It holds while nothing underflows;
//! feedforwards of more than 1e100 times a limit are outside it. The commanded speed is saturated afterwards and keeps the limits
//! to the last bit regardless (claim [`crate::command_within_limits`]).
//!
//! Dropped hypothesis: that `A` lies inside. Then the reference stands still, `f = 0`, and `m > 1`.

use slideway_conditioner::{AffineSpeed, FirstOrderFilter, ImplicitSpeedRegulator, SpeedLimits, SpeedState};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{ROUNDOFF, TS, filter_step, limits, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop, exactly, worse};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "implicit-band",
    statement: "Whenever the feedback part A lies inside the limits, so does A + f B: m <= 1 (to 4 units in the last place for symmetric limits), and f rises no faster than the filter.",
    source: "this project, after Acary and Brogliato",
    verdict: Verdict::Ours,
    negations: &[Script { file: "implicit-band.smt2", text: include_str!("../smt/implicit-band.smt2") }],
    twins: &[Twin {
        without: "feedback-inside",
        script: Script {
            file: "implicit-band-without-feedback-inside.smt2",
            text: include_str!("../smt/implicit-band-without-feedback-inside.smt2"),
        },
    }],
    engines: &[
        Engine {
            name: "feedback_inside_the_limits_keeps_the_whole_inside",
            unit: "share of a limit",
            about: About::Other,
            cost: Cost::Sample,
            trial: whole_stays_inside,
        },
        Engine {
            name: "symmetric_limits_are_kept_to_four_units_in_the_last_place",
            unit: "share of a limit",
            about: About::Other,
            cost: Cost::Sample,
            trial: symmetric_limits_are_kept,
        },
    ],
};

/// A feedback part inside the limits and a feedforward of up to a thousand limits.
fn desired(choices: &mut Choices, limits: &SpeedLimits<3>) -> AffineSpeed<3> {
    let (mut feedback, mut feedforward) = ([0.0; 3], [0.0; 3]);
    let size = choices.decade(-3.0, 3.0);
    for (((a, b), &lo), &up) in feedback.iter_mut().zip(&mut feedforward).zip(limits.lower()).zip(limits.upper()) {
        // Rounding may not put it outside.
        *a = (lo + choices.share() * (up - lo)).max(lo).min(up);
        *b = choices.between(-1.0, 1.0) * up.max(-lo) * size;
    }
    AffineSpeed { feedback, feedforward }
}

/// `e (2 + 3 (1 + κ))` as derived above; a thousandth covers the products of roundings.
fn slack(limits: &SpeedLimits<3>) -> f64 {
    let ratios = limits.lower().iter().zip(limits.upper()).map(|(lo, up)| (lo / up).abs().max((up / lo).abs()));
    1.001 * ROUNDOFF * (2.0 + 3.0 * (1.0 + ratios.fold(1.0, f64::max)))
}

fn whole_stays_inside(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let limits = limits::<3>(choices, -3.0, 3.0)?;
    let (a, start) = (filter_step(choices), choices.share());
    let mut state = SpeedState::moving(start)?;
    let command = ImplicitSpeedRegulator::new(settings(limits, a, 5.0))?.step(&mut state, &desired(choices, &limits));
    // m - 1 is exact near 1.
    let mut margin = slack(&limits) - (command.limit_ratio - 1.0);
    // Exact: the factor is the smaller of the filter's output and f*.
    let risen = FirstOrderFilter::new(a / TS, TS)?.next(start, 1.0);
    margin = worse(margin, exactly(command.factor == state.factor() && command.factor <= risen));
    // Not needlessly slow: a factor below the filter's uses a limit fully, to the same rounding.
    if command.factor < risen.min(1.0) {
        margin = worse(margin, slack(&limits) - (1.0 - command.limit_ratio));
    }
    Ok(margin)
}

fn symmetric_limits_are_kept(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let limits = SpeedLimits::symmetric(std::array::from_fn(|_| choices.decade(-3.0, 3.0)))?;
    let (a, start) = (filter_step(choices), choices.share());
    let regulator = ImplicitSpeedRegulator::new(settings(limits, a, 5.0))?;
    let command = regulator.step(&mut SpeedState::moving(start)?, &desired(choices, &limits));
    Ok(4.0 * f64::EPSILON - (command.limit_ratio - 1.0))
}
