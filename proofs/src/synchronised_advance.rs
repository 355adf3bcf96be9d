//! Claim `synchronised-advance`: the synchronised reference neither runs ahead of the robot nor beats the optimum.
//!
//! Hypotheses: synchronised advance, direction-preserving saturation, joint-space feedback `q̇d = q_d'(λ) f λ̇d + Kp η`, `Kp Ts <= 1`, and a
//! robot that executes its command. With `e = max_i Kp |η_i| / w_i` (unit 1), `V(λ) = 1 / λ̇*(λ)` (s), `L = sup |d ln V / dλ|`:
//!
//! ```text
//! |η_i'| <= (1 - Kp Ts fdir) |η_i| + sup |q_d,i''| Δλ² / 2          saturation adds nothing to the lag
//! λ̇ <= (1 + e) λ̇*(λ)                                               no sample is faster than the limits
//! T >= (1 - d / 2) T* / (1 + e),   d = L Ts λ̇*max (1 + e)           no run beats the optimum, but for the sampling
//! ```
//!
//! Source: this project. Of the published form `[G11]` says that its time equals the optimum's; there the reference can finish first while
//! the robot still trails.
//!
//! Derivation. The lag as in [`crate::drift_with_feedback`]. `fdir m <= 1` and `m >= V f λ̇d - e` give `V fdir f λ̇d <= 1 + e`. One sample covers
//! `x = Ts λ̇` in `Ts`, and `∫ V` over it is at most `V(λ) x (e^{Lx} - 1) / (L x)`; with `V x <= (1 + e) Ts`, `L x <= d` and
//! `(e^d - 1) / d <= 1 / (1 - d / 2)` the sum over the samples is the third line.
//!
//! Dropped hypothesis: that the reference waits. In the paper's form `λ̇ = f λ̇d` exceeds `λ̇*` at every saturated sample.

use slideway_conditioner::Advance;

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{self, Proportional, ROUNDOFF, TS, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::joint_path::JointPath;
use crate::log_path::LogPath;
use crate::subject::Subject;
use crate::time_bracket::{duration, samples_at_most};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "synchronised-advance",
    statement: "Synchronised form: saturation adds nothing to the lag, no sample is faster than (1 + e) λ̇*, and T >= (1 - d / 2) T* / (1 + e); the published form has none of the three.",
    source: "[G11] section 4.2",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[
        Script { file: "synchronised-advance.smt2", text: include_str!("../smt/synchronised-advance.smt2") },
        Script { file: "synchronised-advance-lag.smt2", text: include_str!("../smt/synchronised-advance-lag.smt2") },
    ],
    twins: &[Twin {
        without: "waiting",
        script: Script {
            file: "synchronised-advance-without-waiting.smt2",
            text: include_str!("../smt/synchronised-advance-without-waiting.smt2"),
        },
    }],
    engines: &[
        Engine {
            name: "saturation_adds_nothing_to_the_lag",
            unit: "share of a limit",
            about: About::SpeedRegulator,
            cost: Cost::Sample,
            trial: lag_shrinks,
        },
        Engine {
            name: "no_sample_is_faster_than_the_limits",
            unit: "share of the largest rate",
            about: About::SpeedRegulator,
            cost: Cost::Sample,
            trial: rate_is_allowed,
        },
        Engine {
            name: "no_run_beats_the_optimum",
            unit: "share of the optimum",
            about: About::SpeedRegulator,
            cost: Cost::Run,
            trial: never_beats,
        },
    ],
};

/// Rounding: position and command cost some twenty roundings of the terms added up in `size`.
fn lag_shrinks(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    let limits = draw::limits::<3>(choices, -1.0, 1.0)?;
    let (a, target_rate) = (choices.between(0.005, 0.8), choices.between(1.0, 20.0));
    let gain = choices.share() / TS;
    let overspeed = choices.decade(-0.5, 1.0);
    let path = JointPath::draw(choices, &limits, overspeed / target_rate, TS);
    let (place, start) = (choices.between(0.0, 5.0), choices.share());
    let lag: [f64; 3] = std::array::from_fn(|i| choices.between(-1.0, 1.0) * path.limit[i] * TS);
    let mut settings = settings(limits, a, target_rate);
    settings.advance = Advance::Synchronised;
    let mut regulator = subject.regulator(settings, start)?;
    let mut desired = path.slope(place).map(|v| v * regulator.requested_rate());
    for (v, lag) in desired.iter_mut().zip(&lag) {
        *v += gain * lag;
    }
    let command = regulator.step(&desired);
    let step = TS * command.path_rate;
    let (here, there) = (path.position(place), path.position(place + step));
    let mut margin = f64::INFINITY;
    for i in 0..3 {
        let after = lag[i] + (there[i] - here[i]) - TS * command.joint_speed[i];
        let rest = 0.5 * path.curvature() * path.limit[i] * step * step;
        let size = path.limit[i] * (path.size(place + step) + TS);
        let bound = (1.0 - gain * TS * command.direction_factor) * lag[i].abs() + rest + 20.0 * ROUNDOFF * size;
        margin = worse(margin, (bound - after.abs()) / (TS * path.limit[i]));
    }
    Ok(margin)
}

/// The feedback is any that uses at most `e` of the smaller limit. Rounding: rate, ratio, direction factor and products, eight in all.
fn rate_is_allowed(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    let arm = Proportional::<3>::draw(choices)?;
    let (a, g, start) = (draw::filter_step(choices), choices.decade(-1.0, 2.0), choices.share());
    let lag = choices.share();
    let mut settings = settings(arm.limits, a, g);
    settings.advance = Advance::Synchronised;
    let mut regulator = subject.regulator(settings, start)?;
    let mut desired = arm.at(regulator.requested_rate());
    for ((v, lower), upper) in desired.iter_mut().zip(arm.limits.lower()).zip(arm.limits.upper()) {
        *v += choices.between(-1.0, 1.0) * lag * upper.min(-lower);
    }
    // The path speed that the limits allow is 1.
    Ok(1.0 + 8.0 * f64::EPSILON - regulator.step(&desired).path_rate / (1.0 + lag))
}

/// Zero error. Rounding: as many additions as there are samples, and as many evaluations of `g` with errors as in
/// [`crate::drifting_band`].
fn never_beats(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    let arm = Proportional::<1>::draw(choices)?;
    let (a, target_rate) = (choices.between(0.01, 0.8), choices.between(0.5, 50.0));
    let (ln_max, span, drift) = (choices.between(0.0, 2.0), choices.between(0.0, 2.0), 0.5 * choices.share());
    let ln_min = ln_max - span;
    // Below g = 1 the target rate is what bounds the path rate.
    let slope = drift * ln_min.max(0.0).exp() / (TS * target_rate);
    let path = LogPath::draw(choices, [ln_min, ln_max], slope, TS * target_rate / ln_max.exp());
    let mut settings = settings(arm.limits, a, target_rate);
    settings.advance = Advance::Synchronised;
    let mut regulator = subject.regulator(settings, choices.share())?;
    let most = samples_at_most(&path, a, target_rate);
    let found = duration(&mut regulator, &arm, &path, target_rate, most).ok_or(Stop::Skipped)?;
    let optimum = path.integral() / target_rate;
    Ok(found / optimum - (1.0 - 0.5 * drift) + f64::from(most) * 40.0 * ROUNDOFF)
}
