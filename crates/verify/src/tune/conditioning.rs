use super::{Impossible, MARGIN, ProposedValue, TuneOutcome, TuneRequest, Tuned, bound, predictions, without_number};
use crate::error::VerifyError;
use crate::statement::{ConditioningCase, Statement, room, shown_down, shown_up};
use slideway_conditioner::path::SwitchingLaw;
use slideway_lab::conditioning::{ConditioningProblem, PathMethod};

/// Number of times that the push is adapted to the drift that the run shows.
const ROUNDS: usize = 8;

/// Sampling rates beyond this are not proposed, Hz.
const FASTEST_RATE: f64 = 1e6;

struct Candidate {
    values: [ProposedValue; 2],
    case: ConditioningCase,
    statement: Statement,
    strength: f64,
}

enum Found {
    Does(Box<Candidate>),
    TooCoarse {
        amplitude: f64,
    },
    /// Constraints share a push that drives one of them outwards.
    Loses,
    /// A number that the proposal goes by is none.
    NoNumber(&'static str),
}

/// Proposes parameters of the conditioner. `with` gives the problem with values in the place of its own.
///
/// # Errors
///
/// Numbers that are not positive, a method that nothing is claimed about, a problem that cannot be run, and errors of `with`.
pub fn tune_conditioning<E: From<VerifyError>>(
    problem: &ConditioningProblem,
    method: PathMethod,
    request: TuneRequest,
    with: impl Fn(&[ProposedValue]) -> Result<ConditioningProblem, E>,
) -> Result<TuneOutcome, E> {
    request.check()?;
    if method != PathMethod::SlidingMode {
        return Err(VerifyError::NoClaims { method: method.name().to_owned() }.into());
    }
    let tuner = Tuner { request, method, push: Push::of(problem.law), with };
    Ok(match tuner.at(request.rate)? {
        Found::NoNumber(what) => TuneOutcome::Impossible(without_number(what)),
        Found::Does(candidate) => TuneOutcome::Tuned(Box::new(report(*candidate))),
        Found::TooCoarse { amplitude } => TuneOutcome::Impossible(Impossible {
            reason: format!("at {} Hz the push that beats the drift of one sample moves φ further", request.rate),
            rate: tuner.enough(amplitude)?,
            chattering: Some(shown_up(amplitude)),
        }),
        Found::Loses => TuneOutcome::Impossible(Impossible {
            reason:
                "constraints that act together share one push, and it drives one of them outwards, whatever its length"
                    .into(),
            rate: None,
            chattering: None,
        }),
    })
}

/// The push as the problem has it: its key, its length or gain, and the unit.
struct Push {
    key: &'static str,
    strength: f64,
    unit: &'static str,
}

impl Push {
    fn of(law: SwitchingLaw) -> Self {
        let (key, strength, unit) = match law {
            SwitchingLaw::Normalised { amplitude } => ("conditioner.law.normalised.amplitude", amplitude, "m"),
            SwitchingLaw::Sum { gain } => ("conditioner.law.sum.gain", gain, "1"),
        };
        Self { key, strength, unit }
    }
}

struct Tuner<W> {
    request: TuneRequest,
    method: PathMethod,
    push: Push,
    with: W,
}

impl<E: From<VerifyError>, W: Fn(&[ProposedValue]) -> Result<ConditioningProblem, E>> Tuner<W> {
    fn candidate(&self, rate: f64, wanted: Option<f64>) -> Result<Candidate, E> {
        let strength = wanted.unwrap_or(self.push.strength);
        let values = [
            ProposedValue { key: "conditioner.sampling_period", value: 1.0 / rate, unit: "s" },
            ProposedValue { key: self.push.key, value: strength, unit: self.push.unit },
        ];
        let case = ConditioningCase::new((self.with)(&values)?, self.method)?;
        let statement = case.statement()?;
        Ok(Candidate { values, case, statement, strength })
    }

    /// Keeps the scenario's push where it lies between what the drift needs and what the amplitude allows, else takes the nearer end.
    fn at(&self, rate: f64) -> Result<Found, E> {
        let mut tried = self.candidate(rate, None)?;
        for _ in 0..ROUNDS {
            let amplitude = bound(&tried.statement, "chattering");
            let contact = tried.case.nominal();
            let enough = contact.push_share * (1.0 + MARGIN) <= 1.0;
            if amplitude <= self.request.chattering && enough && tried.statement.holds() && tried.case.completed() {
                return Ok(Found::Does(Box::new(tried)));
            }
            if contact.push_share == f64::INFINITY {
                return Ok(Found::Loses);
            }
            // Where the reserve answers, the push is too weak by an amount that the run does not tell.
            let short = if contact.reserve > 0.0 { 1.5 } else { contact.push_share * (1.0 + MARGIN) * 1.02 };
            let least = tried.strength * short;
            let fall = room(contact.fall).max(0.25 * contact.rise);
            let most = 0.99 * tried.strength * (self.request.chattering - fall) / room(contact.push);
            if !(least <= most) || room(contact.rise) > self.request.chattering {
                let needed = (room(contact.push) * least / tried.strength + fall).max(room(contact.rise));
                return Ok(Found::TooCoarse { amplitude: needed.max(1.02 * self.request.chattering) });
            }
            let strength = shown_down(tried.strength.max(least).min(most)).max(shown_up(least).min(most));
            if !(strength > 0.0 && strength.is_finite()) {
                return Ok(Found::NoNumber("push"));
            }
            tried = self.candidate(rate, Some(strength))?;
        }
        Ok(Found::TooCoarse { amplitude: (1.05 * self.request.chattering).max(room(tried.case.nominal().push)) })
    }

    /// A rate at which the amplitude can be kept, tried before it is named.
    fn enough(&self, amplitude: f64) -> Result<Option<f64>, E> {
        let by = |amplitude: f64| (amplitude / self.request.chattering).clamp(1.05, 4.0);
        let mut rate = self.request.rate * by(amplitude);
        for _ in 0..8 {
            rate = shown_up(1.03 * rate);
            if !(rate < FASTEST_RATE) {
                return Ok(None);
            }
            match self.at(rate)? {
                Found::Does(_) => return Ok(Some(rate)),
                Found::TooCoarse { amplitude } => rate *= by(amplitude),
                Found::Loses | Found::NoNumber(_) => return Ok(None),
            }
        }
        Ok(None)
    }
}

fn report(candidate: Candidate) -> Tuned {
    let contact = candidate.case.nominal();
    let (amplitude, share) = (bound(&candidate.statement, "chattering"), contact.push_share);
    let trade_off = vec![
        format!(
            "The push moves φ by at most {:.3e} m a sample, of which the drift takes back {:.0} % at most: it can grow by {:.0} % before the push \
             loses. Chattering stays below {amplitude:.3e} m.",
            contact.push,
            100.0 * share,
            100.0 * (1.0 / share - 1.0)
        ),
        format!(
            "A weaker push, down to {:.3} of this one, would chatter less and leave {:.0} % for what is not in the scenario; a stronger one the other \
             way round. A higher sampling rate lessens both drift and push of a sample.",
            share * (1.0 + MARGIN),
            100.0 * MARGIN
        ),
    ];
    Tuned {
        predictions: predictions(&candidate.statement),
        values: candidate.values.to_vec(),
        trade_off,
        statement: candidate.statement,
    }
}
