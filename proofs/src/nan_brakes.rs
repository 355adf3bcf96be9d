//! Claim `nan-brakes`: an input that is not finite brakes.
//!
//! Hypotheses: finite limits `lower < 0 < upper` (rad/s), `f` in [0, 1]; at least one number of the input is NaN or infinite.
//!
//! ```text
//! explicit forms:  u = 0
//! implicit form:   f = 0, u <= 0
//! all forms:       q̇ds = 0 for every joint, λ̇ = 0, f does not rise
//! ```
//!
//! Source: this project.
//!
//! Derivation. "Inside" is `lower <= v and v <= upper`; a comparison with NaN is false and an infinity lies beyond every finite
//! limit, so `u = 0`, and `u = 0` cannot raise `f` (claim `factor-range`). The saturation looks for a number that is not finite
//! before it divides. In the implicit form `f*` does not exist and 0 stands for it; `A + 0 B` is then not finite, whether `A` or
//! `B` was the culprit. A factor is set through `max(0)` and `min(1)`, which turn NaN into 0. The script is exact to the bit.
//!
//! Dropped hypotheses: that the comparison is written so that NaN fails it, and that the limits are finite (limits the shipped
//! code refuses).

use slideway_conditioner::{AffineSpeed, ImplicitSpeedRegulator, SpeedCommand, SpeedState};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{self, filter_step, limits, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop, exactly};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "nan-brakes",
    statement: "A NaN or an infinity anywhere in the input: the joints are commanded to stand still, λ̇ = 0, u = 0 (at most 0 in the implicit form) and the factor does not rise.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[Script { file: "nan-brakes.smt2", text: include_str!("../smt/nan-brakes.smt2") }],
    twins: &[
        Twin {
            without: "ordered-comparison",
            script: Script {
                file: "nan-brakes-without-ordered-comparison.smt2",
                text: include_str!("../smt/nan-brakes-without-ordered-comparison.smt2"),
            },
        },
        Twin {
            without: "finite-limits",
            script: Script {
                file: "nan-brakes-without-finite-limits.smt2",
                text: include_str!("../smt/nan-brakes-without-finite-limits.smt2"),
            },
        },
    ],
    engines: &[Engine {
        name: "an_input_that_is_not_finite_brakes",
        unit: "yes or no",
        about: About::SpeedRegulator,
        cost: Cost::Sample,
        trial: brakes,
    }],
};

fn stands_still(command: &SpeedCommand<3>) -> bool {
    command.joint_speed == [0.0; 3] && command.path_rate == 0.0
}

/// The explicit claims are exact. The implicit u is `1 - f' / a` with `f' = f + a (1 - f) >= a`, whose three roundings and
/// the quotient's can leave it 2 eps above 0.
fn brakes(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    let limits = limits::<3>(choices, -3.0, 3.0)?;
    let mut settings = settings(limits, filter_step(choices), 5.0);
    (settings.saturation, settings.advance) = (draw::saturation(choices), draw::advance(choices));
    let start = choices.share();
    let bad = choices.pick([f64::NAN, f64::INFINITY, f64::NEG_INFINITY]);
    let (place, in_feedforward) = (choices.below(3), choices.flag());
    let mut speeds = [draw::wild::<3>(choices, 1.0), draw::wild::<3>(choices, 1.0)];
    speeds[usize::from(in_feedforward)][place] = bad;
    let [feedback, feedforward] = speeds;

    let mut state = SpeedState::moving(start)?;
    let command = ImplicitSpeedRegulator::new(settings)?.step(&mut state, &AffineSpeed { feedback, feedforward });
    let implicit = stands_still(&command) && command.switch <= 2.0 * f64::EPSILON && state.factor() == 0.0;

    let mut regulator = subject.regulator(settings, start)?;
    let command = regulator.step(if in_feedforward { &feedforward } else { &feedback });
    let explicit = stands_still(&command) && command.switch == 0.0 && regulator.factor() <= start;
    Ok(exactly(implicit && explicit))
}
