//! Claim `feedback-band`: the width of the chattering on a frozen path when there is a tracking error.
//!
//! Hypotheses: `q_d'` constant along the path, `g >= 1`, a joint-space controller `q̇d = q_d' f λ̇d + Kp η` with the lag `η = q_d(λ) - q`
//! (rad), direction-preserving saturation, `0 <= Kp Ts <= a <= 1`, `m[0] <= M`, and a robot that trails: `η_i q_d,i' >= 0` for every
//! joint at the start (zero error is a special case). Either advance.
//!
//! ```text
//! m[k] <= M = 1 + a g - Kp Ts   at every sample
//! ```
//!
//! Source: this project; `[G11]` estimates the chattering without feedback.
//!
//! Derivation. Per joint, in shares of the limit it moves towards: `y = x + f b` with the feedback `x >= 0` and `0 <= b <= g`. Over one
//! sample `x' = (1 - Kp Ts fdir) x + s Kp Ts (1 - fdir) f b`, `s` = 1 in the paper's advance and 0 in the synchronised one, so the robot keeps
//! trailing.
//!
//! - `m <= 1`: `fdir = 1`, `y' = (1 - Kp Ts) y + (Kp Ts - a) f b + a b <= 1 - Kp Ts + a g`.
//! - `m > 1`: `y' <= (1 - Kp Ts fdir) y + (Kp Ts - a) f b <= y`.
//!
//! Both use `a >= Kp Ts`. The function is [`slideway_conditioner::bounds::frozen_band_with_feedback`].
//!
//! Dropped hypotheses: that the robot trails (a feedback that opposes the feedforward holds the switch on while `f` falls), and `a >= Kp Ts`.

use slideway_conditioner::bounds::frozen_band_with_feedback;

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{self, Proportional, TS, filter_step, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "feedback-band",
    statement: "On a frozen path with feedback, Kp Ts <= a and a robot that trails in every joint: m <= 1 + a g - Kp Ts at every sample, in either advance.",
    source: "this project; [G11] section 3.3.1 leaves feedback out",
    verdict: Verdict::Ours,
    negations: &[Script { file: "feedback-band.smt2", text: include_str!("../smt/feedback-band.smt2") }],
    twins: &[
        Twin {
            without: "trailing",
            script: Script {
                file: "feedback-band-without-trailing.smt2",
                text: include_str!("../smt/feedback-band-without-trailing.smt2"),
            },
        },
        Twin {
            without: "fast-filter",
            script: Script {
                file: "feedback-band-without-fast-filter.smt2",
                text: include_str!("../smt/feedback-band-without-fast-filter.smt2"),
            },
        },
    ],
    engines: &[Engine {
        name: "a_trailing_robot_keeps_the_band",
        unit: "share of the band",
        about: About::SpeedRegulator,
        cost: Cost::Sample,
        trial: keeps::<3>,
    }],
};

/// Rounding. Each sample rounds the lag by at most four roundings of its terms, which are below `3 M` limits; the loop contracts what
/// it inherits. The ratio costs ten more: `(100 * 12 + 10) 2^-53 < 2e-13` of the band.
const SLACK: f64 = 2e-13;

fn keeps<const N: usize>(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    let arm = Proportional::<N>::draw(choices)?;
    let (a, g) = (filter_step(choices), choices.between(1.0, 20.0));
    let gain_step = a * choices.share();
    let band = frozen_band_with_feedback(a, g, gain_step).ok_or(Stop::Skipped)?;
    let start = choices.share() * (band / g).min(1.0);
    let gain = gain_step / TS;
    // What the limits leave of the band beside the feedforward, and a share of it.
    let (moving, full) = (arm.at(g * start), arm.at(1.0));
    let mut lag = [0.0; N];
    for (((lag, v), lower), upper) in lag.iter_mut().zip(&moving).zip(arm.limits.lower()).zip(arm.limits.upper()) {
        let room = if *v < 0.0 { band * lower - v } else { band * upper - v };
        *lag = if gain > 0.0 { choices.share() * room / gain } else { 0.0 };
    }
    let mut settings = settings(arm.limits, a, g);
    settings.advance = draw::advance(choices);
    let mut regulator = subject.regulator(settings, start)?;
    let mut margin = f64::INFINITY;
    for _ in 0..100 {
        let mut desired = arm.at(regulator.requested_rate());
        for (v, lag) in desired.iter_mut().zip(&lag) {
            *v += gain * lag;
        }
        let command = regulator.step(&desired);
        margin = worse(margin, 1.0 + SLACK - command.limit_ratio / band);
        for ((lag, v), speed) in lag.iter_mut().zip(&full).zip(&command.joint_speed) {
            *lag += TS * (v * command.path_rate - speed);
        }
    }
    Ok(margin)
}
