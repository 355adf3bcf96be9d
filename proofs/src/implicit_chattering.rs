//! Claim `implicit-chattering`: how much the implicit form's demand can change over one sample.
//!
//! Hypotheses: those of [`crate::implicit_band`] at every sample, so `E = sup |A| < 1` (in limits, each joint's smaller one); `g = sup |B|`,
//! `X = sup |A' - A| + f |B' - B|`, `κ` the largest ratio of one joint's two limits, limits that do not vary.
//!
//! ```text
//! |q̇d' - q̇d| <= max(a g + X,  X + κ X (1 + E) / (1 - E))
//! ```
//!
//! Source: this project.
//!
//! Derivation. `q̇d' - q̇d = (f' - f) B' + f (B' - B) + (A' - A)`; the last two are at most `X`. A rising factor rises by at most `a`. A falling one
//! stops where some joint `i` just reaches a limit `w`: `A_i' + f' B_i' = w` and `A_i + f B_i <= w`, so `(f - f') B_i' <= X w`. Since
//! `f' B_i' = w - A_i' >= (1 - E) w` and for any other joint `f' |B_j'| <= κ (1 + E) n_j`, with `n_j` its smaller limit,
//! `(f - f') |B_j'| <= κ X n_j (1 + E) / (1 - E)`. With the explicit forms the first entry alone holds (claim [`crate::chattering_band`]),
//! but with the filter's own switching in it at every sample; here nothing moves where `X` is 0 and the filter has settled.
//! The function is [`slideway_conditioner::bounds::implicit_chattering`].
//!
//! Dropped hypothesis: that the feedback lies inside the limits.

use slideway_conditioner::bounds::{SignalBand, implicit_chattering};
use slideway_conditioner::{AffineSpeed, ImplicitSpeedRegulator, SpeedLimits, SpeedState};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{self, filter_step, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "implicit-chattering",
    statement: "Implicit form with the feedback inside the limits: the demand changes over one sample by at most max(a g + X, X + κ X (1 + E)/(1 - E)), X the change of A and f B.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[Script { file: "implicit-chattering.smt2", text: include_str!("../smt/implicit-chattering.smt2") }],
    twins: &[Twin {
        without: "feedback-inside",
        script: Script {
            file: "implicit-chattering-without-feedback-inside.smt2",
            text: include_str!("../smt/implicit-chattering-without-feedback-inside.smt2"),
        },
    }],
    engines: &[Engine {
        name: "the_demand_of_the_implicit_form_keeps_the_bound",
        unit: "share of the bound",
        about: About::Other,
        cost: Cost::Sample,
        trial: keeps,
    }],
};

/// Largest share of a joint's smaller limit.
fn narrow(limits: &SpeedLimits<3>, v: &[f64; 3]) -> f64 {
    let ends = limits.lower().iter().zip(limits.upper());
    v.iter().zip(ends).map(|(v, (lo, up))| v.abs() / up.min(-lo)).fold(0.0, f64::max)
}

/// A random walk of `A` inside the limits and of `B`.
///
/// Rounding. A factor at a joint's limit is off by a few roundings of 1 over what the feedback leaves, so the demand by as many of `κ (1 + E)
/// / (1 - E)`: 16 of them at both samples.
fn keeps(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let limits: SpeedLimits<3> = draw::limits(choices, -1.0, 1.0)?;
    let (a, start, change) = (filter_step(choices), choices.share(), choices.decade(-6.0, 0.5));
    let (most, overspeed) = (choices.between(0.0, 0.9), choices.decade(-0.5, 1.5));
    let mut fb: [f64; 3] = choices.numbers(-most, most);
    let mut ff: [f64; 3] = choices.numbers(-overspeed, overspeed);
    let sizes: [f64; 3] = std::array::from_fn(|i| limits.upper()[i].min(-limits.lower()[i]));
    let regulator = ImplicitSpeedRegulator::new(settings(limits, a, 1.0))?;
    let (mut state, mut band) = (SpeedState::moving(start)?, SignalBand::new(a));
    let (mut before, mut largest) = (None::<[f64; 3]>, 0.0_f64);
    for _ in 0..40 {
        let scaled = |v: &[f64; 3]| std::array::from_fn(|i| v[i] * sizes[i]);
        let demand = AffineSpeed { feedback: scaled(&fb), feedforward: scaled(&ff) };
        let command = regulator.step(&mut state, &demand);
        // Released: only suprema over all samples are used here.
        band.update(&limits, &demand, command.factor, 1.0);
        let now = demand.at(command.factor);
        if let Some(before) = before {
            let step = std::array::from_fn(|i| now[i] - before[i]);
            largest = largest.max(narrow(&limits, &step));
        }
        before = Some(now);
        for v in &mut fb {
            *v = (*v + change * choices.between(-1.0, 1.0)).clamp(-most, most);
        }
        for v in &mut ff {
            *v += change * overspeed * choices.between(-1.0, 1.0);
        }
    }
    let ends = limits.lower().iter().zip(limits.upper());
    let asymmetry = ends.map(|(lo, up)| (lo / up).abs().max((up / lo).abs())).fold(1.0, f64::max);
    let signals = band.signals();
    let bound = implicit_chattering(&signals, a, asymmetry);
    let slack = 16.0 * f64::EPSILON * asymmetry * (1.0 + signals.feedback) / (1.0 - signals.feedback);
    Ok(worse(f64::INFINITY, (bound + slack - largest) / (bound + slack)))
}
