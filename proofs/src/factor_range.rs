//! Claim `factor-range`: the factor stays in [0, 1], to the last bit, whatever the inputs.
//!
//! Hypotheses: filter step `0 < a <= 1` (unit 1), `f[0]` in [0, 1], `u` in [0, 1].
//!
//! ```text
//! f[k+1] = f[k] + a (u[k] - f[k])
//! ```
//!
//! Source: `[G11] eq 19, 22`, which states the filter and its unit gain; the range is implied there, not stated.
//!
//! Derivation. Over the reals the step is a convex combination of `f` and `u`. In doubles, for `u = 1`: the rounded
//! difference `d = fl(1 - f)` is a double, so `fl(a d) <= d` because rounding is monotonic. If `f >= 1/2`, `d` is exact
//! (Sterbenz) and `f + d = 1`; if `f < 1/2`, `d` lies in (1/2, 1] and is off by at most 2^-54, so `f + d <= 1 + 2^-54`,
//! which rounds to 1. For `u = 0`: `fl(0 - f) = -f` exactly and `fl(a f) <= f`. An input between 0 and 1 gives a difference
//! between those two. The script over doubles checks this for every bit pattern. NaN cannot enter through the switch, which
//! is 0 or 1; in the implicit form it is turned into 0 where the state is set, see [`crate::nan_brakes`].
//!
//! Dropped hypotheses: `a <= 1` (a set of parameters the shipped filter refuses), and `u` in [0, 1].

use slideway_conditioner::{AffineSpeed, ImplicitSpeedRegulator, SpeedState};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{self, TS, filter_step, limits, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "factor-range",
    statement: "The factor f stays in [0, 1], to the last bit, for every input, NaN and infinities included.",
    source: "[G11] eq 19, 22",
    verdict: Verdict::Holds,
    negations: &[
        Script { file: "factor-range.smt2", text: include_str!("../smt/factor-range.smt2") },
        Script { file: "factor-range-float64.smt2", text: include_str!("../smt/factor-range-float64.smt2") },
    ],
    twins: &[
        Twin {
            without: "step-at-most-one",
            script: Script {
                file: "factor-range-without-step-at-most-one.smt2",
                text: include_str!("../smt/factor-range-without-step-at-most-one.smt2"),
            },
        },
        Twin {
            without: "input-in-range",
            script: Script {
                file: "factor-range-without-input-in-range.smt2",
                text: include_str!("../smt/factor-range-without-input-in-range.smt2"),
            },
        },
    ],
    engines: &[
        Engine {
            name: "the_filter_stays_in_range_to_the_last_bit",
            unit: "1",
            about: About::SpeedRegulator,
            cost: Cost::Sample,
            trial: filter_stays,
        },
        Engine {
            name: "the_regulators_stay_in_range_for_every_input",
            unit: "1",
            about: About::SpeedRegulator,
            cost: Cost::Sample,
            trial: regulators_stay,
        },
    ],
};

/// Numbers in [0, 1] with the ends, their neighbours and everything tiny well represented.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn unit(choices: &mut Choices) -> f64 {
    let (kind, number) = (choices.below(5), choices.unit());
    match kind {
        0 => number,
        1 => [0.0, 1.0, 0.5][(3.0 * number) as usize % 3],
        2 => f64::from_bits(1.0_f64.to_bits() - (64.0 * number) as u64),
        3 => f64::from_bits((64.0 * number) as u64),
        _ => f64::from_bits((1.0_f64.to_bits() as f64 * number) as u64),
    }
}

/// Distance of a number from the nearer end of [0, 1]; negative outside.
fn inside(factor: f64) -> f64 {
    factor.min(1.0 - factor)
}

/// No slack: the claim is exact.
fn filter_stays(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    let a = if choices.flag() { filter_step(choices) } else { unit(choices) };
    let (f, u) = (unit(choices), unit(choices));
    if !(a / TS > 0.0 && a / TS * TS > 0.0) {
        return Err(Stop::Skipped);
    }
    let next = subject.filter(a / TS, TS, f, u)?;
    Ok(if next.is_nan() { f64::NAN } else { inside(next) })
}

fn regulators_stay(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    let limits = limits::<2>(choices, -300.0, 300.0)?;
    let mut settings = settings(limits, filter_step(choices), 5.0);
    (settings.saturation, settings.advance) = (draw::saturation(choices), draw::advance(choices));
    let start = unit(choices);
    let mut explicit = subject.regulator(settings, start)?;
    let implicit = ImplicitSpeedRegulator::new(settings)?;
    let (mut state, mut margin) = (SpeedState::moving(start)?, f64::INFINITY);
    for _ in 0..8 {
        let desired = AffineSpeed { feedback: draw::wild(choices, 10.0), feedforward: draw::wild(choices, 10.0) };
        explicit.step(&desired.feedback);
        implicit.step(&mut state, &desired);
        margin = worse(margin, worse(inside(explicit.factor()), inside(state.factor())));
    }
    Ok(margin)
}
