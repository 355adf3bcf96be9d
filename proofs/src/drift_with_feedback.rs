//! Claim `drift-with-feedback`: how far the robot lags and how far `q̇d` leaves the limits, on a curved path with feedback.
//!
//! Hypotheses: synchronised advance, direction-preserving saturation, a joint-space controller `q̇d = q_d'(λ) f λ̇d + Kp η` with the lag
//! `η = q_d(λ) - q` (rad), `κ = Kp Ts <= 1`, `0 < a <= 1`. With `w_i` the smaller speed limit of joint `i` (rad/s), the path enters by
//! `C = max_i sup |q_d,i''| / w_i` (s per unit of λ squared), `λ̇*max` (1/s) and `g_max`; `x = C Ts / 2`. For any `E` with
//!
//! ```text
//! E >= x ρ P,   ρ = min(λ̇d, (1 + E) λ̇*max),   P = min(λ̇d, (1 - a) ρ + a λ̇d)
//! R = κ x ρ²
//! M = max((1 - a)(1 + 2 x ρ²) + a g_max + |a - κ| E + R,   ((1 - a) 2 x ρ P + max(a, κ) E + R) / a)
//! ```
//!
//! and a start with `Kp |η_i| <= E w_i`, `f λ̇d <= P`, `m <= M`, these three hold at every sample, and `fdir f λ̇d <= ρ`.
//!
//! Source: this project. `[G11]` has neither drift nor feedback in its estimate.
//!
//! Derivation. One sample moves `λ` by `Δ = Ts fdir f λ̇d` and the robot by `Ts fdir q̇d`: the path's part cancels and Taylor's formula
//! leaves `η' = (1 - κ fdir) η + r` with `|r_i| <= sup |q_d,i''| Δ² / 2`, whatever `m` is. That is why lag and chattering separate.
//!
//! - *Lag.* In limits `|r| <= κ fdir x (fdir f λ̇d)(f λ̇d) <= κ fdir E`, so the new lag is at most the mean `(1 - κ fdir) E + κ fdir E`.
//! - *Rates.* `m >= g f - E`. With `fdir m <= 1`: `fdir g f <= 1 + E`, hence `fdir f λ̇d <= ρ`. The factor rises only while `m <= 1`, from at
//!   most `ρ`, to at most `(1 - a) ρ + a λ̇d`.
//! - *Ratio.* `q̇d' = (1 - a) q̇d + (1 - a)(q_d'(λ') - q_d'(λ)) f λ̇d + a u q_d'(λ') λ̇d + Kp (η' - (1 - a) η)`, whose last term is
//!   `(a - κ fdir) Kp η + Kp r`. With `u = 1`, `fdir = 1` and `m <= 1` that gives the first entry of `M`. With `u = 0` it gives
//!   `m' <= (1 - a) m + s` with `s` the second entry times `a`, so `m' <= M` as soon as `s <= a M`.
//!
//! There is no reaching condition, unlike in [`crate::drifting_band`]: the requested rate is bounded by `P` whatever `m` does, and a path that
//! drifts faster than the filter falls widens `M`. With `E = 0` and `κ = 0` it is a bound for zero error. The function is
//! [`slideway_conditioner::bounds::drifting_band_with_feedback`]; it takes the smallest `E` (a quadratic).
//!
//! Not covered: the paper's advance, where `η'` gains `(1 - fdir) Ts q_d' f λ̇d` at every saturated sample; and controllers that
//! take the Jacobian at the robot's position, which differ from this one by terms of second order in the lag.
//!
//! Dropped hypotheses: the synchronised advance, and `κ <= 1`.

use slideway_conditioner::bounds::{FeedbackLoop, drifting_band_with_feedback};
use slideway_conditioner::{Advance, SpeedLimits};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{self, TS, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::joint_path::JointPath;
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "drift-with-feedback",
    statement: "Synchronised form, joint-space feedback on a curved path: the lag keeps Kp |η_i| <= E w_i and m <= M, with E and M from a, Kp, Ts, λ̇d, λ̇*max, g_max and the curvature; no reaching condition.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[
        Script { file: "drift-with-feedback-lag.smt2", text: include_str!("../smt/drift-with-feedback-lag.smt2") },
        Script { file: "drift-with-feedback-rate.smt2", text: include_str!("../smt/drift-with-feedback-rate.smt2") },
        Script {
            file: "drift-with-feedback-release.smt2",
            text: include_str!("../smt/drift-with-feedback-release.smt2"),
        },
        Script { file: "drift-with-feedback-brake.smt2", text: include_str!("../smt/drift-with-feedback-brake.smt2") },
    ],
    twins: &[
        Twin {
            without: "synchronised-advance",
            script: Script {
                file: "drift-with-feedback-without-synchronised-advance.smt2",
                text: include_str!("../smt/drift-with-feedback-without-synchronised-advance.smt2"),
            },
        },
        Twin {
            without: "gain-below-rate",
            script: Script {
                file: "drift-with-feedback-without-gain-below-rate.smt2",
                text: include_str!("../smt/drift-with-feedback-without-gain-below-rate.smt2"),
            },
        },
    ],
    engines: &[
        Engine {
            name: "the_lag_keeps_its_bound",
            unit: "share of the bound",
            about: About::SpeedRegulator,
            cost: Cost::Run,
            trial: lag_keeps,
        },
        Engine {
            name: "the_ratio_keeps_its_band",
            unit: "share of the band",
            about: About::SpeedRegulator,
            cost: Cost::Run,
            trial: ratio_keeps,
        },
    ],
};

const SAMPLES: u32 = 300;

/// The smallest margins of a run, as shares of their bounds.
struct Margins {
    lag: f64,
    ratio: f64,
}

fn lag_keeps(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    Ok(run(choices, subject)?.lag)
}

fn ratio_keeps(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    Ok(run(choices, subject)?.ratio)
}

/// A closed loop of three joints on a random path, the shipped regulator in it.
///
/// Rounding. The reference is evaluated with some ten roundings of its terms, `size` limits and seconds, and the robot's position adds
/// one per sample, which the loop forgets: `Kp (10 + 300) 2^-53 size` in the lag, twice that in the ratio, and a part in
/// 1e13 of the bounds themselves, which the function adds on its side.
fn run(choices: &mut Choices, subject: Subject) -> Result<Margins, Stop> {
    let limits: SpeedLimits<3> = draw::limits(choices, -1.0, 1.0)?;
    let (a, target_rate) = (choices.between(0.005, 0.8), choices.between(1.0, 20.0));
    let gain = choices.share() / TS * choices.pick([1.0, 0.1, 0.01]);
    let overspeed = choices.decade(-0.5, 1.0);
    let path = JointPath::draw(choices, &limits, overspeed / target_rate, TS);
    let initial_lag = choices.pick([0.0, 1.0]) * choices.decade(-4.0, 0.0);
    let system = FeedbackLoop {
        filter_step: a,
        gain,
        sampling_period: TS,
        target_rate,
        path_rate_max: path.rate_max(&limits),
        overspeed_max: path.slope_max() * target_rate,
        curvature: path.curvature(),
        initial_lag,
    };
    let band = drifting_band_with_feedback(&system).ok_or_else(|| Stop::Refused(format!("{system:?}")))?;
    let start = choices.share() * (band.requested_rate / target_rate).min(1.0);
    let mut settings = settings(limits, a, target_rate);
    settings.advance = Advance::Synchronised;
    let mut regulator = subject.regulator(settings, start)?;
    let mut place = 0.0;
    let mut q = path.position(place);
    if gain > 0.0 {
        for (q, w) in q.iter_mut().zip(path.limit) {
            *q -= choices.between(-1.0, 1.0) * initial_lag * w / gain;
        }
    }
    let mut margins = Margins { lag: f64::INFINITY, ratio: f64::INFINITY };
    for sample in 0..SAMPLES {
        let rounding =
            gain * (10.0 + f64::from(SAMPLES)) * draw::ROUNDOFF * (path.size(place) + initial_lag / gain.max(1.0));
        let wanted = path.position(place);
        let mut desired = path.slope(place).map(|v| v * regulator.requested_rate());
        let mut lag = 0.0_f64;
        for (((v, q), wanted), w) in desired.iter_mut().zip(&q).zip(&wanted).zip(path.limit) {
            *v += gain * (wanted - q);
            lag = lag.max(gain * (wanted - q).abs() / w);
        }
        let command = regulator.step(&desired);
        if sample == 0 && !(command.limit_ratio <= band.limit_ratio) {
            return Err(Stop::Skipped);
        }
        margins.lag = worse(margins.lag, (band.lag + rounding - lag) / (band.lag + rounding).max(f64::MIN_POSITIVE));
        margins.ratio = worse(margins.ratio, 1.0 + (2.0 * rounding - command.limit_ratio) / band.limit_ratio);
        place += TS * command.path_rate;
        for (q, v) in q.iter_mut().zip(&command.joint_speed) {
            *q += TS * v;
        }
    }
    Ok(margins)
}
