use super::{Impossible, MARGIN, ProposedValue, TuneOutcome, TuneRequest, Tuned, bound, predictions, without_number};
use crate::error::VerifyError;
use crate::statement::{SpeedCase, Statement, shown_down, shown_up};
use slideway_lab::{Experiment, Method};

/// Filter steps beyond this gain nothing: what the switching costs, about `a / 2` of the speed, is more than what the approach saves.
const LARGEST_STEP: f64 = 0.2;

/// Number of times that the filter is adapted to the demand's changes that the run shows.
const ROUNDS: usize = 6;

/// Sampling rates beyond this are not proposed, Hz.
const FASTEST_RATE: f64 = 1e6;

/// One trial of parameters.
struct Candidate {
    values: [ProposedValue; 4],
    case: SpeedCase,
    statement: Statement,
    step: f64,
}

/// Proposes parameters of a speed law. `with` gives the experiment with values in the place of its own; the optimum is solved on
/// a grid of so many points.
///
/// # Errors
///
/// Numbers that are not positive, a method that nothing is claimed about, an experiment that cannot be run, and errors of `with`.
pub fn tune_speed<E: From<VerifyError>>(
    experiment: Experiment,
    method: Method,
    grid_points: usize,
    request: TuneRequest,
    with: impl Fn(&[ProposedValue]) -> Result<Experiment, E>,
) -> Result<TuneOutcome, E> {
    request.check()?;
    if !method.bounds_chattering() {
        return Err(VerifyError::NoClaims { method: method.name().to_owned() }.into());
    }
    let start = Start::of(&SpeedCase::new(experiment, method, grid_points)?);
    let tuner = Tuner { request, method, grid_points, with };
    match tuner.at(request.rate, &start)? {
        Found::Does(candidate) => Ok(TuneOutcome::Tuned(Box::new(tuner.report(*candidate, &start)?))),
        Found::NoNumber(what) => Ok(TuneOutcome::Impossible(without_number(what))),
        Found::Singular => Ok(TuneOutcome::Impossible(Impossible {
            reason: "the limit falls without bound where the path meets a singularity: no filter is fast enough. Lead the path around it, or \
                     choose `--method sliding-mode-implicit`, which needs none"
                .into(),
            rate: None,
            chattering: None,
        })),
        Found::TooCoarse { amplitude } => Ok(TuneOutcome::Impossible(Impossible {
            reason: format!(
                "at {} Hz the filter that is fast enough for the path, and the path's own changes from sample to sample, chatter more",
                request.rate
            ),
            rate: tuner.enough(amplitude, &start)?,
            chattering: amplitude.is_finite().then(|| shown_up(amplitude)),
        })),
    }
}

/// Values that the path sets, whatever the parameters.
struct Start {
    /// Target rate with the margin, 1/s.
    target_rate: f64,
    /// Gain of the position error, 1/s, as it stands.
    gain: f64,
}

impl Start {
    fn of(case: &SpeedCase) -> Self {
        let target_rate = shown_up((1.0 + MARGIN) * case.numbers.fastest_rate);
        Self { target_rate, gain: case.looked.control.gain }
    }
}

enum Found {
    Does(Box<Candidate>),
    /// The slowest admissible filter chatters this much.
    TooCoarse {
        amplitude: f64,
    },
    Singular,
    /// A number that the proposal goes by is none.
    NoNumber(&'static str),
}

struct Tuner<W> {
    request: TuneRequest,
    method: Method,
    grid_points: usize,
    with: W,
}

impl<E: From<VerifyError>, W: Fn(&[ProposedValue]) -> Result<Experiment, E>> Tuner<W> {
    /// Runs the experiment with a filter; `None` where a value that it would be given is no positive number.
    fn candidate(&self, rate: f64, step: f64, start: &Start) -> Result<Option<Candidate>, E> {
        let gain = start.gain.min(shown_down(rate / (1.0 + MARGIN)));
        let values = [
            ProposedValue { key: "control.sampling_period", value: 1.0 / rate, unit: "s" },
            ProposedValue { key: "control.bandwidth", value: shown_down(step * rate), unit: "rad/s" },
            ProposedValue { key: "control.target_rate", value: start.target_rate, unit: "1/s" },
            ProposedValue { key: "control.gain", value: gain, unit: "1/s" },
        ];
        if !values.iter().all(|one| one.value > 0.0 && one.value.is_finite()) {
            return Ok(None);
        }
        let case = SpeedCase::new((self.with)(&values)?, self.method, self.grid_points)?;
        let statement = case.statement();
        let step = case.looked.control.filter_step();
        Ok(Some(Candidate { values, case, statement, step }))
    }

    /// The slowest filter whose fall beats the path's drift with the margin; 0 where none is needed.
    fn slowest(&self, candidate: &Candidate) -> f64 {
        let needed = candidate.case.numbers.drift_rate;
        let period = candidate.case.looked.control.sampling_period;
        if self.method == Method::SlidingModeImplicit { 0.0 } else { -(-(1.0 + MARGIN) * needed * period).exp_m1() }
    }

    /// Adapts the filter until its chattering is what was asked for, or the drift wants a faster one.
    ///
    /// The bound is affine in the step, `c (a g + X)`, but for what the run changes of `g` and `X`: a secant through the origin's value.
    fn at(&self, rate: f64, start: &Start) -> Result<Found, E> {
        let Some(mut candidate) = self.candidate(rate, LARGEST_STEP.min(20.0 / rate), start)? else {
            return Ok(Found::NoNumber("rate of the path"));
        };
        for round in 0..ROUNDS {
            let slowest = self.slowest(&candidate);
            if candidate.case.looked.drift.breaks() && self.method != Method::SlidingModeImplicit {
                return Ok(Found::Singular);
            }
            if !(slowest < 1.0) {
                // Not even a filter without memory falls fast enough between two samples.
                return Ok(Found::TooCoarse { amplitude: f64::INFINITY });
            }
            let amplitude = chattering(&candidate);
            if !amplitude.is_finite() {
                return Ok(Found::NoNumber("bound on the chattering"));
            }
            let keeps = amplitude <= self.request.chattering && candidate.step >= slowest;
            // The last percent is not worth a run.
            let near = amplitude >= 0.97 * self.request.chattering || candidate.step >= 0.99 * LARGEST_STEP;
            if keeps && candidate.statement.holds() && (near || round + 1 == ROUNDS) {
                return Ok(Found::Does(Box::new(candidate)));
            }
            let per_step = candidate.case.chattering_per_step();
            let rest = amplitude - per_step * candidate.step;
            // Three digits of the bandwidth are kept, rounded down.
            let wanted = 0.99 * (self.request.chattering - rest) / per_step;
            let least = slowest * (1.0 + 1e-2);
            if wanted < least && candidate.step <= 1.02 * least {
                let amplitude = rest + per_step * least;
                return Ok(if amplitude <= self.request.chattering && keeps && candidate.statement.holds() {
                    Found::Does(Box::new(candidate))
                } else {
                    Found::TooCoarse { amplitude: amplitude.max(chattering(&candidate)) }
                });
            }
            let step = wanted.max(least).min(LARGEST_STEP.max(least)).min(1.0);
            match self.candidate(rate, step, start)? {
                Some(next) => candidate = next,
                None => return Ok(Found::NoNumber("bandwidth")),
            }
        }
        let amplitude = chattering(&candidate);
        let slow = candidate.step >= self.slowest(&candidate);
        Ok(if amplitude <= self.request.chattering && slow && candidate.statement.holds() {
            Found::Does(Box::new(candidate))
        } else {
            Found::TooCoarse { amplitude }
        })
    }

    /// A rate at which the amplitude can be kept: it goes with the period, but for what the settings round. Tried before it is named.
    fn enough(&self, amplitude: f64, start: &Start) -> Result<Option<f64>, E> {
        let by = |amplitude: f64| (amplitude / self.request.chattering).clamp(1.05, 4.0);
        let mut rate = self.request.rate * by(amplitude);
        for _ in 0..8 {
            rate = shown_up(1.03 * rate);
            if !(rate < FASTEST_RATE) {
                return Ok(None);
            }
            match self.at(rate, start)? {
                Found::Does(_) => return Ok(Some(rate)),
                Found::TooCoarse { amplitude } => rate *= by(amplitude),
                Found::Singular | Found::NoNumber(_) => return Ok(None),
            }
        }
        Ok(None)
    }

    fn report(&self, candidate: Candidate, start: &Start) -> Result<Tuned, E> {
        let mut trade_off = vec![self.filter_in_words(&candidate)];
        trade_off.extend(self.slower_in_words(&candidate, start)?);
        let (control, fastest) = (candidate.case.looked.control, candidate.case.numbers.fastest_rate);
        trade_off.push(format!(
            "The target rate is {:.0} % above the largest rate that the limits allow anywhere: more would shorten the approach and chatter \
             in proportion.",
            100.0 * (control.target_rate / fastest - 1.0)
        ));
        let (before, after) = (start.gain, control.gain);
        if after < before {
            trade_off.push(format!(
                "The gain comes down from {before} to {after}: the position loop must not overshoot, Kp Ts <= 1."
            ));
        }
        Ok(Tuned {
            predictions: predictions(&candidate.statement),
            values: candidate.values.to_vec(),
            trade_off,
            statement: candidate.statement,
        })
    }

    fn filter_in_words(&self, candidate: &Candidate) -> String {
        let control = candidate.case.looked.control;
        let why =
            if candidate.step >= 0.98 * LARGEST_STEP { "as fast as pays" } else { "as fast as the chattering allows" };
        format!(
            "The filter is {why}: {} rad/s. It rises within {:.0} ms (1/af) and adds at most {:.4} of the limits to the chattering of {:.4}; \
             the rest is what the path changes from sample to sample.{}",
            control.bandwidth,
            1e3 / control.bandwidth,
            candidate.case.chattering_per_step() * candidate.step,
            chattering(candidate),
            in_words(candidate)
        )
    }

    /// Words about the slowest filter with the margin, which is run as well; `None` if it is hardly slower.
    fn slower_in_words(&self, candidate: &Candidate, start: &Start) -> Result<Option<String>, E> {
        let slowest = 1.01 * self.slowest(candidate);
        if !(slowest > 0.0 && slowest < 0.95 * candidate.step) {
            return Ok(None);
        }
        let rate = 1.0 / candidate.case.looked.control.sampling_period;
        let Some(slower) = self.candidate(rate, slowest, start)? else { return Ok(None) };
        let bandwidth = slower.case.looked.control.bandwidth;
        Ok(Some(format!(
            "A slower one, down to {bandwidth} rad/s, would still fall {:.0} % faster than the limit along the path and chatter by {:.4} at most, \
             but rise within {:.0} ms.{}",
            100.0 * MARGIN,
            chattering(&slower),
            1e3 / bandwidth,
            in_words(&slower)
        )))
    }
}

/// The chattering that is guaranteed: from the start, or, of the implicit form, once the feedback has settled.
fn chattering(candidate: &Candidate) -> f64 {
    let whole = bound(&candidate.statement, "chattering");
    if candidate.case.looked.method == Method::SlidingModeImplicit {
        whole.min(bound(&candidate.statement, "chattering-settled"))
    } else {
        whole
    }
}

/// The time of a run beside the optimum, and what it is predicted to be.
fn in_words(candidate: &Candidate) -> String {
    let found = candidate.statement.guarantees.iter().find(|g| g.name == "time-over-optimum");
    let Some((measured, upper)) = found.and_then(|g| g.measured.zip(g.upper)) else { return String::new() };
    format!(" It needs {measured:.4} of the optimum's time, at most {upper:.4}.")
}
