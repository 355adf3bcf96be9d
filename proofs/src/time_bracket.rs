//! Claim `time-bracket`: travel time of the synchronised form within a stated factor of the optimum, from below and from above.
//!
//! Hypotheses: zero tracking error, synchronised advance, `g >= g_min >= 1`, `0 < a < 1`; with `L = sup |d ln g / dλ|` (1/unit of λ) and
//! `d = L Ts λ̇*max` (unit 1), `0 <= d < 2`; with `r = (1 - a) exp(-d)`, `r (1 - r) <= a g_min`.
//!
//! ```text
//! (1 - d / 2) T*  <=  T  <=  T* / (r (1 - d / 2)) + (K + 1) Ts,     (1 - f0)(1 - a)^K <= 1 - r / g_min
//! ```
//!
//! Source: this project. `[G11]` says "exactly the same time". To first order the factor is `1 + a + 3 d / 2`; the mean loss is `a f* / 2`.
//!
//! Derivation. From below: claim [`crate::synchronised_advance`] with `e = 0`. From above: once `m >= r`, it stays there. For `m > 1`,
//! `m' = (1 - a) m g'/g >= r`. For `r <= m <= 1`, `m' = (1 - a) m g'/g + a g' >= r² + a g_min >= r` by the last hypothesis. The
//! synchronised rate is `min(m, 1) λ̇* >= r λ̇*`, so a sample covers at least `r Ts (1 - d / 2)` of `T* = ∫ dλ / λ̇*`. Before, `u = 1` and
//! `1 - f` shrinks by `1 - a` a sample: after `K` samples `m >= g_min f >= r`. The function is
//! [`slideway_conditioner::bounds::time_bracket`].
//!
//! Dropped hypothesis: that the drift of a sample is at most `d`.

use slideway_conditioner::Advance;
use slideway_conditioner::bounds::time_bracket;

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{Proportional, ROUNDOFF, TS, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop};
use crate::log_path::LogPath;
use crate::subject::{Regulator, Subject};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "time-bracket",
    statement: "Synchronised form, zero error, g >= g_min >= 1, r = (1 - a) exp(-d): (1 - d / 2) T* <= T <= T* / (r (1 - d / 2)) + (K + 1) Ts.",
    source: "[G11] section 4.2",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[
        Script { file: "time-bracket.smt2", text: include_str!("../smt/time-bracket.smt2") },
        Script { file: "time-bracket-approach.smt2", text: include_str!("../smt/time-bracket-approach.smt2") },
    ],
    twins: &[Twin {
        without: "slow-drift",
        script: Script {
            file: "time-bracket-without-slow-drift.smt2",
            text: include_str!("../smt/time-bracket-without-slow-drift.smt2"),
        },
    }],
    engines: &[
        Engine {
            name: "travel_time_is_above_the_lower_factor",
            unit: "share of the optimum",
            about: About::SpeedRegulator,
            cost: Cost::Run,
            trial: above,
        },
        Engine {
            name: "travel_time_is_below_the_upper_factor",
            unit: "share of the optimum",
            about: About::SpeedRegulator,
            cost: Cost::Run,
            trial: below,
        },
    ],
};

/// Time until the reference reaches the end of the path, s, the last sample in part; `None` if it does not within `most` samples.
pub(crate) fn duration(
    regulator: &mut Regulator<1>,
    arm: &Proportional<1>,
    path: &LogPath,
    target_rate: f64,
    most: u32,
) -> Option<f64> {
    let mut place = 0.0;
    for sample in 0..most {
        let desired = arm.at(regulator.requested_rate() * (path.overspeed(place) / target_rate));
        let step = TS * regulator.step(&desired).path_rate;
        if place + step >= path.end() && step > 0.0 {
            return Some(TS * (f64::from(sample) + (path.end() - place) / step));
        }
        place += step;
    }
    None
}

/// Samples that every run of [`duration`] needs at most: ten times the optimum and what the filter takes to rise.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
pub(crate) fn samples_at_most(path: &LogPath, a: f64, target_rate: f64) -> u32 {
    (10.0 * path.integral().max(path.end()) / (TS * target_rate) + 40.0 / a) as u32
}

/// The travel time and its bounds, as shares of the optimum.
struct Timed {
    found: f64,
    lower: f64,
    upper: f64,
    /// As many additions as samples, and as many evaluations of `g` with errors as in [`crate::drifting_band`].
    slack: f64,
}

fn timed(choices: &mut Choices, subject: Subject) -> Result<Timed, Stop> {
    let arm = Proportional::<1>::draw(choices)?;
    let (a, target_rate) = (choices.between(0.01, 0.8), choices.between(0.5, 50.0));
    let (ln_min, span, drift) = (choices.share(), choices.between(0.0, 2.0), 0.5 * choices.share());
    let start = choices.share();
    let bracket = time_bracket(a, ln_min.exp(), drift, start).ok_or(Stop::Skipped)?;
    let slope = drift * ln_min.exp() / (TS * target_rate);
    let path = LogPath::draw(choices, [ln_min, ln_min + span], slope, TS * target_rate / (ln_min + span).exp());
    let mut settings = settings(arm.limits, a, target_rate);
    settings.advance = Advance::Synchronised;
    let mut regulator = subject.regulator(settings, start)?;
    let most = samples_at_most(&path, a, target_rate);
    let never = || Stop::Refused(format!("not at the end after {most} samples"));
    let found = duration(&mut regulator, &arm, &path, target_rate, most).ok_or_else(never)?;
    let optimum = path.integral() / target_rate;
    let upper = bracket.upper + (bracket.approach_samples + 1.0) * TS / optimum;
    Ok(Timed { found: found / optimum, lower: bracket.lower, upper, slack: f64::from(most) * 40.0 * ROUNDOFF })
}

fn above(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    timed(choices, subject).map(|t| t.found + t.slack - t.lower)
}

fn below(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    timed(choices, subject).map(|t| t.upper + t.slack - t.found)
}
