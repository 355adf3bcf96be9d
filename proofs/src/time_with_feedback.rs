//! Claim `time-with-feedback`: the travel time beside the optimum, from what the regulator sees, feedback included.
//!
//! Hypotheses: any of the three forms, `q̇d = A + f B` at every sample but the last, which may be cut short; the path's own overspeed
//! `b_path = λ̇d / λ̇*` known where the reference is. `E`, `b`, `z`, `m`, `D` as in [`crate::signal_band`], each at its own sample. With `T*` (s) the
//! optimum of the path under its speed limits, `V` the total variation of `ln λ̇*`, `R >= (1 + E + (m - 1)⁺) b_path / b` and `d` (unit 1) the most
//! that `ln λ̇*` changes within a sample at `R λ̇*`:
//!
//! ```text
//! T* - Ts (W + ΣE + Σ(m - 1)⁺ + P)  <=  T  <=  T* + Ts (W + H + P + 1)
//! W = R V (e^d - 1) / d,   P = Σ (1 + E + (m - 1)⁺) |1 - b_path / b|,   H = Σ max(y, E)⁺
//! ```
//!
//! from the first sample in which the reference moves to its end, where `y` starts as `1 - z` and follows
//! `y' = max(1 - (1 - a)(1 - y)⁺ b'/b - a b', 1 - (1 - a)(1 - E) b'/b)`; the implicit form has `E'` as the second entry. In the form that waits
//! and in the implicit one `Σ(m - 1)⁺` is not needed.
//!
//! Source: this project; `[G11]` says "exactly the same time". With zero error this sharpens [`crate::time_bracket`]: the approach and the drift are
//! added up instead of bounded by their largest values.
//!
//! Derivation. A sample covers `Ts s b_path / b` of `T* = ∫ dλ / λ̇*` where `s` is `z`, or `z / max(1, m)` in the form that waits, but for the change of
//! `λ̇*` within it: by at most `e^v - 1` of what it covers, `v` its own variation, and all `v` add up to `V`. That is `W`; `P` is what `b_path / b`
//! changes. From above `s <= 1 + E + (m - 1)⁺`, for `z <= m + E`. From below: a released sample has `z' = (1 - a) z e^D + a b'`; a braked one had `m > 1`,
//! so `z > 1 - E` and `z' >= (1 - a)(1 - E) e^D`; the implicit factor is the filter's or has `m' = 1`, so `z' >= 1 - E'`. Hence `z >= 1 - y`, and
//! `s >= 1 - max(y, E)`, for where `m > 1` the form that waits has `z / m >= 1 - E / m`. The functions are
//! [`slideway_conditioner::bounds::Progress`] and [`slideway_conditioner::bounds::travel_bracket`].
//!
//! Dropped hypothesis: that the feedback is counted.

use slideway_conditioner::bounds::{Progress, ProgressForm, TravelInputs, travel_bracket};
use slideway_conditioner::{Advance, AffineSpeed, ImplicitSpeedRegulator, SpeedCommand, SpeedLimits, SpeedState};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{ROUNDOFF, TS, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::log_path::LogPath;
use crate::subject::{Regulator, Subject};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "time-with-feedback",
    statement: "Any form, any feedback: T* - Ts (W + ΣE + Σ(m - 1)⁺ + P) <= T <= T* + Ts (W + H + P + 1), with W the drift between samples, P the feedforward's distance from the path's, H what filter, feedback and drift hold back.",
    source: "this project; [G11] section 4.2",
    verdict: Verdict::Ours,
    negations: &[
        Script { file: "time-with-feedback.smt2", text: include_str!("../smt/time-with-feedback.smt2") },
        Script { file: "time-with-feedback-below.smt2", text: include_str!("../smt/time-with-feedback-below.smt2") },
    ],
    twins: &[Twin {
        without: "feedback",
        script: Script {
            file: "time-with-feedback-without-feedback.smt2",
            text: include_str!("../smt/time-with-feedback-without-feedback.smt2"),
        },
    }],
    engines: &[
        Engine {
            name: "travel_time_is_above_the_bracket",
            unit: "share of the optimum",
            about: About::SpeedRegulator,
            cost: Cost::Run,
            trial: above,
        },
        Engine {
            name: "travel_time_is_below_the_bracket",
            unit: "share of the optimum",
            about: About::SpeedRegulator,
            cost: Cost::Run,
            trial: below,
        },
    ],
};

/// One of the three forms.
enum Law {
    Explicit(Box<Regulator<1>>),
    Implicit(ImplicitSpeedRegulator<1>, SpeedState),
}

impl Law {
    /// One sample and the factor it used.
    fn step(&mut self, demand: &AffineSpeed<1>) -> SpeedCommand<1> {
        match self {
            Self::Explicit(regulator) => {
                let desired = demand.at(regulator.factor());
                regulator.step(&desired)
            }
            Self::Implicit(regulator, state) => regulator.step(state, demand),
        }
    }
}

/// The travel time and its bounds, as shares of the optimum.
struct Timed {
    found: f64,
    ends: [f64; 2],
    /// As many additions as samples and the last in part, each of a few roundings, as in [`crate::time_bracket`].
    slack: f64,
}

/// One joint with limits ±1 on a path given by `ln g`, a feedback that wanders, a feedforward up to a tenth off the path's.
fn timed(choices: &mut Choices, subject: Subject) -> Result<Timed, Stop> {
    let (a, target_rate, start) = (choices.between(0.01, 0.8), choices.between(0.5, 50.0), choices.share());
    let (ln_min, span) = (choices.between(-0.2, 1.0), choices.between(0.0, 2.0));
    let slope = choices.share() * ln_min.exp() / (TS * target_rate);
    let path = LogPath::draw(choices, [ln_min, ln_min + span], slope, TS * target_rate / (ln_min + span).exp());
    let (most, wander) = (choices.between(0.0, 0.6), choices.decade(-3.0, 0.0));
    let off = choices.pick([0.0, 0.1]);
    let mut settings = settings(SpeedLimits::symmetric([1.0])?, a, target_rate);
    settings.advance = choices.pick([Advance::Paper, Advance::Synchronised]);
    let (form, mut law) = if choices.below(3) == 0 {
        let implicit = Law::Implicit(ImplicitSpeedRegulator::new(settings)?, SpeedState::moving(start)?);
        (ProgressForm::Implicit, implicit)
    } else {
        (ProgressForm::Explicit, Law::Explicit(Box::new(subject.regulator(settings, start)?)))
    };
    // Ten times what a feedback of 0.6 leaves of the optimum's rate; only a broken regulator needs more.
    let limit = 10.0 * path.integral().max(path.end()) / (TS * target_rate) + 40.0 / a;
    let (mut progress, mut place, mut samples, mut moving) = (Progress::new(form, a), 0.0, 0.0, false);
    // A broken regulator may never move at all.
    let (mut fb, mut waited) = (choices.between(-most, most), 0.0);
    let time = loop {
        let on_path = path.overspeed(place);
        let seen = on_path * (1.0 + off * choices.between(-1.0, 1.0));
        let demand = AffineSpeed { feedback: [fb], feedforward: [seen] };
        let command = law.step(&demand);
        let step = TS * command.path_rate;
        moving |= step > 0.0;
        if moving {
            progress.update(&settings.limits, &demand, command.factor, on_path);
            if place + step >= path.end() && step > 0.0 {
                break TS * (samples + (path.end() - place) / step);
            }
            samples += 1.0;
        }
        waited += 1.0;
        if waited > limit {
            return Err(Stop::Skipped);
        }
        place += step;
        fb = (fb + wander * choices.between(-1.0, 1.0)).clamp(-most, most);
    };
    let (sums, optimum) = (progress.sums(), path.integral() / target_rate);
    let sample_drift = (slope * TS * sums.pace * target_rate / ln_min.exp()).min(path.variation());
    let variation = path.variation();
    let inputs = TravelInputs { sums, optimum: [optimum; 2], period: TS, variation, sample_drift };
    let ends = travel_bracket(&inputs).ok_or_else(|| Stop::Refused(format!("{inputs:?}")))?;
    let slack = (samples + 2.0) * 100.0 * ROUNDOFF * (1.0 + sums.pace);
    Ok(Timed { found: time / optimum, ends: ends.map(|t| t / optimum), slack })
}

fn above(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    timed(choices, subject).map(|t| worse(f64::INFINITY, t.found + t.slack - t.ends[0]))
}

fn below(choices: &mut Choices, subject: Subject) -> Result<f64, Stop> {
    timed(choices, subject).map(|t| worse(f64::INFINITY, t.ends[1] + t.slack - t.found))
}
