//! Claim `signal-band`: how far the demand leaves the limits, from what the regulator sees, whatever made it.
//!
//! Hypotheses: `q̇d = A + f B` (rad/s) at every sample, `0 < a <= 1`, `u = 1` exactly where `m <= 1`. `A` and `B` are what the regulator sees:
//! noise, delay, jitter, a wrong model and a robot that lags are in them. Lengths in limits: `ρ(v)` is the largest use of a limit, `|v|`
//! the largest share of a joint's smaller limit; `b = ρ(B)`, `z = f b`, `D = ln(b' / b)`, `E = sup |A|`, `g = sup |B|`. From the first
//! released sample (`u = 1`) on, `m <= M`, the smaller of (and at least 1)
//!
//! ```text
//! by length   E + Z e^S,   Z = (1 - a)(1 + E) exp(sup D⁺ over released samples) + a g
//! by vector   max(1 - a + sup c over released samples + a g,  sup c over braked samples / a)
//! ```
//!
//! where the surplus `S` is the largest sum of `D + ln(1 - a)` over the first samples of a run of braked ones, 0 if there is none above,
//! and `c = |A' - (1 - a) A| + (1 - a) f |B' - B|`. `S = 0` is the reaching condition as the regulator sees it. Under limits that vary,
//! `ρ` and `|.|` are those of the sample, and `c` grows by `(1 - a)(κ - 1)⁺ m` where a limit shrinks to its `κ`-th part.
//!
//! Source: this project. `[G11]` has an estimate for the frozen path without error.
//!
//! Derivation. `ρ` is a gauge: `|m - z| <= E`.
//!
//! - *By length.* `u = 1` needs `m <= 1`, so `z <= 1 + E` and `z' = (1 - a) z e^D + a b' <= Z`. `u = 0` gives `z' = z e^D (1 - a)`: over a run of
//!   braked samples `z` is at most `Z` times the exponential of the sum.
//! - *By vector.* `A' + f' B' = (1 - a)(A + f B) + (A' - (1 - a) A) + (1 - a) f (B' - B) + a u B'`, hence `m' <= (1 - a) m + c + a u g`. With
//!   `u = 1` that starts from `m <= 1`; with `u = 0` it keeps `M` as soon as `c <= a M`.
//!
//! The first form needs no direction of `B`, the second no small `A`: while a robot far from its path approaches, `E` is near 1 and `c` is
//! small. It is checked after any run ([`slideway_conditioner::bounds::SignalBand`]) and stated before one for suprema that are declared.
//!
//! Dropped hypotheses: the surplus, the feedback, and what changes while the filter brakes.

use slideway_conditioner::bounds::SignalBand;
use slideway_conditioner::{AffineSpeed, SpeedLimits};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{self, filter_step, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "signal-band",
    statement: "For any feedback A and feedforward B that the regulator sees, m <= M from the first released sample on, M the smaller of E + Z e^S and max(1 - a + sup c + a g, sup c / a): a function of suprema of the signals; S = 0 is the reaching condition.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[
        Script { file: "signal-band.smt2", text: include_str!("../smt/signal-band.smt2") },
        Script { file: "signal-band-vector.smt2", text: include_str!("../smt/signal-band-vector.smt2") },
    ],
    twins: &[
        Twin {
            without: "surplus",
            script: Script {
                file: "signal-band-without-surplus.smt2",
                text: include_str!("../smt/signal-band-without-surplus.smt2"),
            },
        },
        Twin {
            without: "feedback",
            script: Script {
                file: "signal-band-without-feedback.smt2",
                text: include_str!("../smt/signal-band-without-feedback.smt2"),
            },
        },
        Twin {
            without: "braked-change",
            script: Script {
                file: "signal-band-without-braked-change.smt2",
                text: include_str!("../smt/signal-band-without-braked-change.smt2"),
            },
        },
    ],
    engines: &[
        Engine {
            name: "wild_signals_keep_their_band",
            unit: "share of the band",
            about: About::SpeedRegulator,
            cost: Cost::Sample,
            trial: keeps::<Wild>,
        },
        Engine {
            name: "slow_signals_keep_their_band",
            unit: "share of the band",
            about: About::SpeedRegulator,
            cost: Cost::Sample,
            trial: keeps::<Slow>,
        },
    ],
};

/// Size of the signals' changes over one sample, in limits.
trait Change {
    fn draw(choices: &mut Choices) -> f64;
}

struct Wild;
struct Slow;

impl Change for Wild {
    fn draw(choices: &mut Choices) -> f64 {
        choices.decade(-2.0, 0.5)
    }
}

impl Change for Slow {
    fn draw(choices: &mut Choices) -> f64 {
        choices.decade(-6.0, -2.0)
    }
}

const SAMPLES: usize = 60;

/// A random walk of `A` and `B`, in limits; limits that shrink and widen by up to a tenth in a third of the cases.
///
/// Rounding. The demand costs two roundings of `|A| + |B|`, its ratio one, and as many where the bound subtracts: `8 eps (E + g)`; what a
/// run of braked samples adds up is in the bound, a part in 1e12.
fn keeps<C: Change>(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    let base: SpeedLimits<3> = draw::limits(choices, -1.0, 1.0)?;
    let (a, start, change) = (filter_step(choices), choices.share(), C::draw(choices));
    let breathing = choices.pick([0.0, 0.0, 0.1]);
    let (feedback, overspeed) = (choices.decade(-3.0, 0.3), choices.decade(-0.5, 1.0));
    let mut fb: [f64; 3] = choices.numbers(-feedback, feedback);
    let mut ff: [f64; 3] = choices.numbers(-overspeed, overspeed);
    let mut regulator = subject.regulator(settings(base, a, 1.0), start)?;
    let mut band = SignalBand::new(a);
    let (mut largest, mut released) = (0.0_f64, false);
    for _ in 0..SAMPLES {
        let scale = 1.0 + breathing * choices.between(-1.0, 1.0);
        let limits = SpeedLimits::new(base.lower().map(|l| scale * l), base.upper().map(|u| scale * u))?;
        let narrow: [f64; 3] = std::array::from_fn(|i| base.upper()[i].min(-base.lower()[i]));
        let scaled = |v: &[f64; 3]| std::array::from_fn(|i| v[i] * narrow[i]);
        let demand = AffineSpeed { feedback: scaled(&fb), feedforward: scaled(&ff) };
        let factor = regulator.factor();
        let command = regulator.step_under(limits, &demand.at(factor));
        band.update(&limits, &demand, factor, command.switch);
        released |= command.switch >= 1.0;
        if released {
            largest = largest.max(command.limit_ratio);
        }
        for v in &mut fb {
            *v += change * feedback * choices.between(-1.0, 1.0);
        }
        for v in &mut ff {
            *v += change * overspeed * choices.between(-1.0, 1.0);
        }
    }
    if !released {
        return Err(Stop::Skipped);
    }
    let (signals, bound) = (band.signals(), band.band());
    let slack = 8.0 * f64::EPSILON * (signals.feedback + signals.overspeed) / bound;
    Ok(worse(f64::INFINITY, 1.0 + slack - largest / bound))
}
