//! Claim `frozen-band`: the width of the chattering on a frozen path.
//!
//! Hypotheses: zero tracking error, `0 < a <= 1`, `g >= 1` constant, `m[0] <= 1 + a (g - 1)` (all unit 1; a start with
//! `m[0] <= 1` is a special case).
//!
//! ```text
//! m[k] <= 1 + a (g - 1)   at every sample,   m = g f
//! ```
//!
//! Source: this project; `[G11] eq 23` estimates the same amplitude joint by joint.
//!
//! Derivation. If `m <= 1` then `u = 1` and `m' = (1 - a) m + a g <= 1 - a + a g`. If `m > 1` then `u = 0` and
//! `m' = (1 - a) m <= m`. For `g < 1`, `m = g f <= 1` already (claim `factor-range`). The function is
//! [`slideway_conditioner::bounds::frozen_band`].
//!
//! Dropped hypotheses: that `g` is constant (the drift of a real path: see [`crate::drifting_band`]), and zero error.

use slideway_conditioner::bounds::frozen_band;

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{Proportional, filter_step, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "frozen-band",
    statement: "On a frozen path with zero error and g >= 1, a start with m <= 1 + a (g - 1) keeps m <= 1 + a (g - 1) for ever.",
    source: "section 3.3.1 of [G11]; the bound is this project's",
    verdict: Verdict::Ours,
    negations: &[Script { file: "frozen-band.smt2", text: include_str!("../smt/frozen-band.smt2") }],
    twins: &[
        Twin {
            without: "frozen-path",
            script: Script {
                file: "frozen-band-without-frozen-path.smt2",
                text: include_str!("../smt/frozen-band-without-frozen-path.smt2"),
            },
        },
        Twin {
            without: "zero-error",
            script: Script {
                file: "frozen-band-without-zero-error.smt2",
                text: include_str!("../smt/frozen-band-without-zero-error.smt2"),
            },
        },
    ],
    engines: &[
        Engine {
            name: "one_joint_keeps_the_band",
            unit: "share of the band",
            about: About::SpeedRegulator,
            cost: Cost::Sample,
            trial: keeps::<1>,
        },
        Engine {
            name: "three_joints_keep_the_band",
            unit: "share of the band",
            about: About::SpeedRegulator,
            cost: Cost::Sample,
            trial: keeps::<3>,
        },
    ],
};

/// Rounding. The measured `m` is `g f` with at most four roundings (rate, share of the limit, product, ratio), 2 eps. While
/// `u = 1` the filter adds three more to `(1 - a) m + a g <= band`; while `u = 0` it cannot raise `f`, nor then `m`, because
/// every operation is monotonic: nothing accumulates. Start and band cost three roundings each. In all less than
/// 2 (inherited) + 2 (measured) + 1.5 (filter) + 1.5 (band) = 7 eps of the band.
const SLACK: f64 = 8.0 * f64::EPSILON;

fn keeps<const N: usize>(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    let arm = Proportional::<N>::draw(choices)?;
    let (a, g, place) = (filter_step(choices), choices.between(1.0, 50.0), choices.share());
    let band = frozen_band(a, g);
    let mut regulator = subject.regulator(settings(arm.limits, a, g), (place * band / g).min(1.0))?;
    let mut margin = f64::INFINITY;
    for _ in 0..100 {
        let desired = arm.at(regulator.requested_rate());
        margin = worse(margin, 1.0 + SLACK - regulator.step(&desired).limit_ratio / band);
    }
    Ok(margin)
}
