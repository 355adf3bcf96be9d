//! Claim `command-within-limits`: the saturated command keeps the limits, to the last bit, for every input.
//!
//! Hypotheses: finite limits `lower < 0 < upper` (rad/s), not necessarily symmetric. The desired speed is arbitrary, NaN and
//! infinities included; so are state and parameters.
//!
//! ```text
//! command = min(max(fdir q̇d, lower), upper),   fdir = min(1, 1 / ‖F_N q̇d‖∞)
//! ```
//!
//! Source: `[G11] eq 6-8`, where the bounded command is what the equations are for; the paper computes with real numbers.
//!
//! Derivation. `max` with `lower` gives a number of at least `lower` (the other operand, where one is NaN), `min` with `upper` one
//! between both because `lower < upper`. The script is exact to the bit. Over the reals scaling alone would do; over doubles it
//! does not, which the twin shows.
//!
//! Dropped hypothesis: the clamp after the scaling.

use slideway_conditioner::{AffineSpeed, ImplicitSpeedRegulator, SpeedState};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{self, filter_step, limits, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop, exactly};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "command-within-limits",
    statement: "The saturated command lies inside the limits, to the last bit, for every finite or non-finite input.",
    source: "[G11] eq 6-8",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[Script {
        file: "command-within-limits.smt2",
        text: include_str!("../smt/command-within-limits.smt2"),
    }],
    twins: &[Twin {
        without: "clamp",
        script: Script {
            file: "command-within-limits-without-clamp.smt2",
            text: include_str!("../smt/command-within-limits-without-clamp.smt2"),
        },
    }],
    engines: &[
        Engine {
            name: "every_command_lies_inside_the_limits",
            unit: "yes or no",
            about: About::SpeedRegulator,
            cost: Cost::Sample,
            trial: inside,
        },
        Engine {
            name: "inside_the_limits_is_a_ratio_of_at_most_one",
            unit: "yes or no",
            about: About::Other,
            cost: Cost::Sample,
            trial: ratio_agrees,
        },
    ],
};

/// No slack anywhere: the claim is exact. Limits from 1e-300 to 1e300, speeds of every bit pattern, so ratios that
/// overflow and underflow are among the cases.
fn inside(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    let reach = choices.pick([300.0, 2.0]);
    let limits = limits::<3>(choices, -reach, reach)?;
    let mut settings = settings(limits, filter_step(choices), 5.0);
    (settings.saturation, settings.advance) = (draw::saturation(choices), draw::advance(choices));
    let start = choices.share();
    let desired = AffineSpeed { feedback: draw::wild(choices, 100.0), feedforward: draw::wild(choices, 100.0) };
    let explicit = subject.regulator(settings, start)?.step(&desired.feedback);
    let implicit = ImplicitSpeedRegulator::new(settings)?.step(&mut SpeedState::moving(start)?, &desired);
    Ok(exactly([explicit, implicit].iter().all(|command| {
        limits.contain(&command.joint_speed)
            && (0.0..=1.0).contains(&command.direction_factor)
            && (0.0..=5.0).contains(&command.path_rate)
    })))
}

/// The switch and the ratio agree to the bit. A quotient of at most 1 rounds to at most 1. The next double beyond a limit
/// of `2^k s`, `1 <= s < 2`, is larger by a relative `2^-52 / s`, more than half a unit in the last place of 1, so that quotient
/// rounds to more than 1. (Normal limits only.)
fn ratio_agrees(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let limits = limits::<1>(choices, -3.0, 3.0)?;
    let limit = if choices.flag() { limits.lower() } else { limits.upper() };
    let neighbours = i64::try_from(choices.below(9)).unwrap_or(0) - 4;
    let speed = limit.map(|limit| f64::from_bits(limit.to_bits().wrapping_add_signed(neighbours)));
    Ok(exactly(limits.contain(&speed) == (limits.ratio(&speed) <= 1.0)))
}
