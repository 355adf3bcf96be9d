//! Claim `drifting-band`: the width of the chattering on a path along which the limit drifts.
//!
//! Hypotheses: zero tracking error, `0 < a <= 1`, `g(λ) <= g_max`, and with `L = sup |d ln g / dλ|` (1/unit of λ), `Ts` (s),
//! `λ̇*max` (unit of λ per s), `d = L Ts λ̇*max` (unit 1) and
//!
//! ```text
//! M = (1 - a) exp(d) + a g_max
//! ```
//!
//! the conditions `M >= 1`, `m[0] <= 1` and the reaching condition `d M <= -ln(1 - a)`. Then `m[k] <= M` at every sample.
//!
//! Source: this project. `[G11]` notes that its reaching condition is not enforced by the switching action and gives no bound.
//!
//! Derivation. In the published advance `Δλ = Ts f λ̇d = Ts m λ̇*`, so one sample changes `ln g` by at most `d m`. Assume `m <= M`.
//!
//! - `m <= 1`: `u = 1`, `m' = (1 - a) m g'/g + a g' <= (1 - a) exp(d) + a g_max = M`.
//! - `1 < m <= M`: `u = 0`, `m' = (1 - a) m g'/g <= m (1 - a) exp(d M) <= m`, by the reaching condition.
//!
//! The synchronised advance moves `λ` by at most as much, so the same bound holds there; since it moves by
//! `Ts min(m, 1) λ̇*`, the second case then needs no more than `d <= -ln(1 - a)`. The function
//! [`slideway_conditioner::bounds::drifting_band`] asks for the stronger condition in both cases.
//!
//! A weaker reaching condition does. On a path the drift of one sample is at most `r f` with `r = L Ts λ̇d`, and for `g >= g_min >= 1`
//! the factor never exceeds `f_max = 1 / g_min + a (1 - 1 / g_min)`: it rises only from `f <= 1 / g <= 1 / g_min`. With
//! `λ̇*max = λ̇d / g_min` the second case then needs `r f_max <= -ln(1 - a)` only, that is `d (1 + a (g_min - 1)) <= -ln(1 - a)`,
//! which `d M <= -ln(1 - a)` implies because `M >= 1 + a (g_max - 1)`. The second script proves it, and the property test runs
//! at its edge too.
//!
//! In the scripts the two exponentials are reals of which only the bounds above are known.
//!
//! Dropped hypothesis: the reaching condition. The limit then falls faster than the filter, and `m` grows while `u = 0`.

use slideway_conditioner::bounds::drifting_band;

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{self, Proportional, ROUNDOFF, TS, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::log_path::LogPath;
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "drifting-band",
    statement: "With zero error, M = (1 - a) exp(L Ts λ̇*max) + a g_max >= 1, m[0] <= 1 and L Ts λ̇*max M <= -ln(1 - a): m <= M at every sample.",
    source: "this project; [G11] section 3.3.1 has no bound for a moving path",
    verdict: Verdict::Ours,
    negations: &[
        Script { file: "drifting-band.smt2", text: include_str!("../smt/drifting-band.smt2") },
        Script { file: "drifting-band-on-path.smt2", text: include_str!("../smt/drifting-band-on-path.smt2") },
    ],
    twins: &[Twin {
        without: "reaching",
        script: Script {
            file: "drifting-band-without-reaching.smt2",
            text: include_str!("../smt/drifting-band-without-reaching.smt2"),
        },
    }],
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

const SAMPLES: u32 = 120;

/// The largest drift that meets the reaching condition, by bisection.
fn admissible_drift(a: f64, g_max: f64) -> f64 {
    let (mut low, mut high) = (0.0, -(-a).ln_1p());
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if drifting_band(a, g_max, middle).is_some() { low = middle } else { high = middle }
    }
    low
}

/// The largest drift that meets the weaker condition `d (1 + a (g_min - 1)) <= -ln(1 - a)`, less a hundred roundings.
fn weaker_drift(a: f64, g_min: f64) -> f64 {
    (1.0 - 1e-14) * -(-a).ln_1p() / (1.0 + a * (g_min - 1.0))
}

/// Rounding, relative to `m`, one sample. Place, interpolation and exponential put `ln g` off by at most four roundings of
/// `|ln g| <= 4` (16) and of the place times the slope (`4 L λ_end`); rate, share, product, ratio and the filter's three
/// add 8, so do the band's own operations once. A sample with `u = 0` at the very edge of the reaching condition passes on what
/// it inherits, so all samples add up.
fn slack(slope: f64, end: f64) -> f64 {
    (f64::from(SAMPLES) * (16.0 + 8.0 + 4.0 * slope * end) + 8.0) * ROUNDOFF
}

fn keeps<const N: usize>(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    let arm = Proportional::<N>::draw(choices)?;
    let (a, ln_max, span) = (choices.between(0.01, 0.8), choices.between(0.0, 2.0), choices.between(0.0, 2.0));
    let (place, target_rate, start) = (choices.share(), choices.between(0.5, 50.0), choices.share());
    let (ln_min, g_max) = (ln_max - span, ln_max.exp());
    // The weaker condition is stated for paths that ask for regulation everywhere.
    let weaker = choices.flag() && ln_min >= 0.0;
    let drift = place * if weaker { weaker_drift(a, ln_min.exp()) } else { admissible_drift(a, g_max) };
    let band = if weaker {
        (1.0 - a) * drift.exp() + a * g_max
    } else {
        drifting_band(a, g_max, drift).ok_or(Stop::Skipped)?
    };
    // λ̇*max = λ̇d / g_min; lengths of 1 to 20 samples at the admissible rate.
    let slope = drift * ln_min.exp() / (TS * target_rate);
    let path = LogPath::draw(choices, [ln_min, ln_max], slope, TS * target_rate / g_max);
    let mut settings = settings(arm.limits, a, target_rate);
    settings.advance = draw::advance(choices);
    let mut regulator = subject.regulator(settings, (start / path.overspeed(0.0)).min(1.0))?;
    let (mut at, mut margin) = (0.0, f64::INFINITY);
    for _ in 0..SAMPLES {
        let desired = arm.at(regulator.requested_rate() * (path.overspeed(at) / target_rate));
        let command = regulator.step(&desired);
        margin = worse(margin, 1.0 + slack(slope, at) - command.limit_ratio / band);
        at += TS * command.path_rate;
    }
    Ok(margin)
}
