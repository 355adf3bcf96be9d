//! Claim `chattering-band`: how much one joint's desired speed can change from one sample to the next.
//!
//! Hypotheses: `q̇d = A + f B` (rad/s) at both samples, `0 < a <= 1`, `f` in [0, 1], `u` in {0, 1}. Nothing else: `A` and `B` are
//! arbitrary.
//!
//! ```text
//! |q̇d[k+1] - q̇d[k]| <= |B[k+1]| a s + f |B[k+1] - B[k]| + |A[k+1] - A[k]|,   s = 1 - f if u = 1, f if u = 0
//! ```
//!
//! With zero error and `B = v(λ) λ̇d`, the second term is at most `Ts λ̇² sup |dv/dλ|` (rad/s), because `Δλ = Ts λ̇`.
//!
//! Source: `[G11] eq 23` estimates the change by `|B| a` alone. It is an estimate: it leaves out the drift of `B`, which for a
//! joint that does not limit, or where the drift beats the filter, is most of the change.
//!
//! Derivation. `q̇d' - q̇d = (f' - f) B' + f (B' - B) + (A' - A)`, `f' - f = a (u - f)`, and the triangle inequality. The function
//! is [`slideway_conditioner::bounds::chattering_bound`].
//!
//! Dropped hypothesis: the drift terms, which is eq 23 read as a bound.

use slideway_conditioner::bounds::chattering_bound;
use slideway_conditioner::{AffineSpeed, SpeedLimits};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{TS, filter_step, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "chattering-band",
    statement: "The desired speed of a joint changes by at most |B'| a |u - f| + f |ΔB| + |ΔA| over one sample; without the drift terms (eq 23) this is an estimate, not a bound.",
    source: "[G11] eq 23",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[Script { file: "chattering-band.smt2", text: include_str!("../smt/chattering-band.smt2") }],
    twins: &[Twin {
        without: "drift-term",
        script: Script {
            file: "chattering-band-without-drift-term.smt2",
            text: include_str!("../smt/chattering-band-without-drift-term.smt2"),
        },
    }],
    engines: &[
        Engine {
            name: "the_change_of_a_desired_speed_keeps_the_bound",
            unit: "rad/s",
            about: About::SpeedRegulator,
            cost: Cost::Sample,
            trial: change_keeps,
        },
        Engine {
            name: "along_a_path_the_drift_is_the_derivative_times_the_way",
            unit: "share of the largest speed asked for",
            about: About::SpeedRegulator,
            cost: Cost::Sample,
            trial: drift_is_bounded,
        },
    ],
};

/// Of either sign or zero, over six decades.
fn sized<const N: usize>(choices: &mut Choices) -> [f64; N] {
    std::array::from_fn(|_| choices.pick([1.0, -1.0, 0.0]) * choices.decade(-3.0, 3.0))
}

/// Rounding, with `S = |A| + |A'| + |B| + |B'|`. Left: two products and two sums, `2 S` roundoffs; the filter, `3 |B'|`; the
/// difference, `S`. Right, at most `2 S`: seven operations, none deeper than five, `10 S`. Less than `16 S` roundoffs = `8 eps S`.
fn change_keeps(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    let upper = choices.numbers::<2>(0.01, 10.0);
    let lower = choices.numbers::<2>(-10.0, -0.01);
    let (a, start) = (filter_step(choices), choices.share());
    let [one, two] = [0, 1].map(|_| AffineSpeed::<2> { feedback: sized(choices), feedforward: sized(choices) });
    let mut regulator = subject.regulator(settings(SpeedLimits::new(lower, upper)?, a, 1.0), start)?;
    let before = one.at(start);
    let command = regulator.step(&before);
    let after = two.at(regulator.factor());
    let mut margin = f64::INFINITY;
    for joint in 0..2 {
        let (fb, ff) = (one.feedback[joint], one.feedforward[joint]);
        let (fb_next, ff_next) = (two.feedback[joint], two.feedforward[joint]);
        let drift = start * (ff_next - ff).abs() + (fb_next - fb).abs();
        let bound = chattering_bound(ff_next, a * (command.switch - start), drift);
        let slack = 8.0 * f64::EPSILON * (fb.abs() + fb_next.abs() + ff.abs() + ff_next.abs());
        margin = worse(margin, bound + slack - (after[joint] - before[joint]).abs());
    }
    Ok(margin)
}

/// On the path, zero error: `v(λ) = c sin(w λ + p)`, `sup |dv/dλ| = |c w|`. Rounding: the sine's argument is off by three
/// roundings of itself and of `w λ`, at both samples; the rest as above with `S = 2 |c| λ̇d`.
fn drift_is_bounded(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    let (size, frequency, phase) =
        (choices.between(0.01, 10.0), choices.between(0.1, 500.0), choices.between(0.0, 6.0));
    let (a, start, target_rate) = (filter_step(choices), choices.share(), choices.between(0.5, 20.0));
    let mut regulator = subject.regulator(settings(SpeedLimits::symmetric([1.0])?, a, target_rate), start)?;
    let joint_rate = |place: f64| -> f64 { size * (frequency * place + phase).sin() };
    let (mut place, mut margin) = (0.0, f64::INFINITY);
    for _ in 0..30 {
        let (factor, before) = (regulator.factor(), joint_rate(place) * regulator.requested_rate());
        let command = regulator.step(&[before]);
        place += TS * command.path_rate;
        let after = joint_rate(place) * regulator.requested_rate();
        let drift = TS * command.path_rate * command.path_rate * size * frequency;
        let bound = chattering_bound(joint_rate(place) * target_rate, a * (command.switch - factor), drift);
        let slack = f64::EPSILON * size * target_rate * (16.0 + 3.0 * (2.0 * frequency * place + phase));
        margin = worse(margin, (bound + slack - (after - before).abs()) / (size * target_rate));
    }
    Ok(margin)
}
