//! Claim `switching`: exactly when the switch acts.
//!
//! Hypotheses: zero tracking error, `0 < a <= 1`, `f0` in [0, 1], `g > 0` (all unit 1).
//!
//! ```text
//! u[k] = 0 for the first time  <=>  k is the first sample with g[k] (1 - (1 - f0)(1 - a)^k) > 1
//! g <= 1 at every sample       =>   u = 1 for ever (equality included)
//! ```
//!
//! Source: `[G11] eq 21` asks for `g >= 1` and calls it both what the surfaces need to be reached and what makes one joint
//! saturate all along the path. The first half is right. The second is not: a run can end before the filter has risen far
//! enough, and at `g = 1` no switch ever happens.
//!
//! Derivation. While `u = 1`, `1 - f` is multiplied by `1 - a` every sample, so `f[k] = 1 - (1 - f0)(1 - a)^k` by induction;
//! `u[k] = 0` means `m = g[k] f[k] > 1`. With `g <= 1` and `f <= 1` (claim `factor-range`) `m <= 1`.
//! [`slideway_conditioner::bounds::switches_by`] is the criterion for constant `g`: `f` does not fall while `u = 1`, so the
//! last sample decides.
//!
//! Dropped hypothesis: that there are enough samples.

use slideway_conditioner::bounds::switches_by;

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{Proportional, filter_step, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop, exactly};
use crate::subject::{Regulator, Subject};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "switching",
    statement: "With zero error u switches exactly if some sample of the run with u = 1 has g (1 - (1 - f0)(1 - a)^k) > 1; g > 1 (eq 21) is necessary and not sufficient, and equality never switches.",
    source: "[G11] eq 21",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[Script { file: "switching.smt2", text: include_str!("../smt/switching.smt2") }],
    twins: &[Twin {
        without: "enough-samples",
        script: Script {
            file: "switching-without-enough-samples.smt2",
            text: include_str!("../smt/switching-without-enough-samples.smt2"),
        },
    }],
    engines: &[
        Engine {
            name: "the_first_switch_falls_where_the_criterion_says",
            unit: "yes or no",
            about: About::SpeedRegulator,
            cost: Cost::Sample,
            trial: switches_where_said,
        },
        Engine {
            name: "below_eq_21_and_at_equality_nothing_switches",
            unit: "yes or no",
            about: About::SpeedRegulator,
            cost: Cost::Sample,
            trial: nothing_switches,
        },
    ],
};

/// The first sample with `u = 0` among the first `samples`.
fn first_brake(regulator: &mut Regulator<2>, arm: &Proportional<2>, samples: u32) -> Option<u32> {
    (0..samples).find(|_| {
        let desired = arm.at(regulator.requested_rate());
        regulator.step(&desired).switch == 0.0
    })
}

/// Puts the threshold `1 / g` between the factors of two consecutive samples, off both ends by a hundredth of the gap.
///
/// The gap between neighbouring factors is `(1 - f0) a (1 - a)^(k-1) >= 0.1 * 1e-3 * 0.4^20 = 1e-12` (for `a = 0.6` the cap is
/// `k = 20`; `(1 - a)^(12 / a)` is smallest there), and a hundredth of it 1e-14. The factor's own rounding: each sample adds at
/// most 2 roundoffs and contracts what it inherits by `1 - a`, so `2^-53 * 2 * min(k, 1/a) <= 1.4e-14` for `a = 1/60`; there the
/// gap is `0.1 * a * exp(-1) = 6e-4`. At `a = 0.6` it is `2^-53 * 4 = 4e-16` against `0.1 * 0.6 * 0.4^19 / 100 = 1.6e-11`. The
/// threshold is never in doubt.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn switches_where_said(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    let arm = Proportional::<2>::draw(choices)?;
    let (a, start) = (choices.between(1e-3, 0.6), choices.between(0.0, 0.9));
    // Past `a k = 12` the factors of neighbouring samples are closer than rounding lets one tell.
    let sample = (1 + choices.below(59) as u32).min((12.0 / a) as u32).max(1);
    let factor = |k: u32| 1.0 - (1.0 - start) * (1.0 - a).powi(k.cast_signed());
    let threshold = factor(sample - 1) + choices.between(0.01, 0.99) * (factor(sample) - factor(sample - 1));
    let g = 1.0 / threshold;
    let found = first_brake(&mut subject.regulator(settings(arm.limits, a, g), start)?, &arm, sample + 1);
    Ok(exactly(found == Some(sample) && !switches_by(a, g, start, sample - 1) && switches_by(a, g, start, sample)))
}

/// No slack: with `g <= 1` and `f <= 1` the products `g f`, `limit (g f)` round to at most 1 and the limit, because 1 and the limit
/// are doubles and rounding is monotonic.
fn nothing_switches(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    let arm = Proportional::<2>::draw(choices)?;
    let (a, start) = (filter_step(choices), choices.share());
    let g = choices.share().max(1e-3);
    let found = first_brake(&mut subject.regulator(settings(arm.limits, a, g), start)?, &arm, 50);
    Ok(exactly(found.is_none() && !switches_by(a, g, start, 50)))
}
