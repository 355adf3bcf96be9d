//! Claim `delayed-band`: the frozen band when the switch arrives late.
//!
//! Hypotheses: zero tracking error, `0 < a <= 1`, `g >= 1` constant, `m[0] <= 1`, and the filter receives `u[k - D]` at sample
//! `k`, with `D >= 0` whole samples of delay; what it receives before sample `D` is arbitrary.
//!
//! ```text
//! m[k] <= 1 + (1 - (1 - a)^(D+1)) (g - 1)   at every sample
//! ```
//!
//! Source: this project. For `D = 0` it is the claim [`crate::frozen_band`].
//!
//! Derivation. Let `n` count the samples since the last one with `m <= 1`, where `1 - f >= 1 - 1/g`. A rise multiplies `1 - f` by
//! `1 - a`, a fall increases it, so `1 - f >= (1 - a)^n (1 - 1/g)`. From `n = D + 1` on, the switch that arrives was decided at a
//! sample with `m > 1`: it is 0 and `f` falls. Hence `g (1 - f) >= (1 - a)^(D+1) (g - 1)` always, which is the bound. The counting
//! is done here by hand; the script checks that every step keeps the invariant, with the power of `1 - a` as a real.
//! The function is [`slideway_conditioner::bounds::delayed_frozen_band`].
//!
//! Dropped hypothesis: that the delay is at most the `D` of the bound.

use std::collections::VecDeque;

use slideway_conditioner::bounds::delayed_frozen_band;
use slideway_conditioner::{FirstOrderFilter, SpeedRegulator, SpeedState};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{Proportional, TS, filter_step, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "delayed-band",
    statement: "On a frozen path with zero error, m[0] <= 1 and u arriving D samples late: m <= 1 + (1 - (1 - a)^(D+1)) (g - 1).",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[Script { file: "delayed-band.smt2", text: include_str!("../smt/delayed-band.smt2") }],
    twins: &[Twin {
        without: "bounded-delay",
        script: Script {
            file: "delayed-band-without-bounded-delay.smt2",
            text: include_str!("../smt/delayed-band-without-bounded-delay.smt2"),
        },
    }],
    engines: &[Engine {
        name: "a_delayed_switch_keeps_the_band",
        unit: "share of the band",
        about: About::Other,
        cost: Cost::Sample,
        trial: late_switch_keeps,
    }],
};

/// Rounding. As for the frozen band, but `D + 1` rises follow one another, each adding three roundings of at most
/// `f <= band / g`; falls add nothing. The band costs ten roundings (log1p, product, expm1 and the rest, two units each
/// from the library), the measured ratio four. `10 + 4 + 4 + 3 (D + 1)` roundings = `(10.5 + 1.5 D)` eps.
fn late_switch_keeps(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let arm = Proportional::<2>::draw(choices)?;
    let (a, g, place) = (filter_step(choices), choices.between(1.0, 50.0), choices.share());
    let delay = choices.below(7);
    let mut late: VecDeque<f64> = (0..delay).map(|_| choices.pick([0.0, 1.0])).collect();
    let regulator = SpeedRegulator::new(settings(arm.limits, a, g))?;
    let filter = FirstOrderFilter::new(a / TS, TS)?;
    let band = delayed_frozen_band(a, g, u32::try_from(delay).unwrap_or(u32::MAX));
    let slack = (11.0 + 1.5 * delay as f64) * f64::EPSILON;
    let (mut factor, mut margin) = (place / g, f64::INFINITY);
    for _ in 0..80 {
        let mut state = SpeedState::moving(factor)?;
        let desired = arm.at(regulator.requested_rate(&state));
        let command = regulator.step(&mut state, &desired);
        margin = worse(margin, 1.0 + slack - command.limit_ratio / band);
        late.push_back(command.switch);
        factor = filter.next(factor, late.pop_front().unwrap_or(f64::NAN));
    }
    Ok(margin)
}
