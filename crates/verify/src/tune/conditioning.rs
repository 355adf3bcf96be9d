use super::document::{Setting, replaced};
use super::{Impossible, MARGIN, TuneOutcome, TuneRequest, Tuned, bound, predictions, without_number};
use crate::error::VerifyError;
use crate::statement::{ConditioningCase, Statement, room, shown_down, shown_up};
use slideway_conditioner::path::SwitchingLaw;
use slideway_lab::conditioning::PathMethod;
use slideway_scenario::ConditioningScenario;

/// How often the push is adapted to what the run shows of the drift.
const ROUNDS: usize = 8;

/// Sampling rates beyond this are not proposed, Hz.
const FASTEST_RATE: f64 = 1e6;

struct Candidate {
    text: String,
    changes: Vec<super::Change>,
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

pub(super) fn tune(request: &TuneRequest) -> Result<TuneOutcome, VerifyError> {
    if let Some(name) = request.method.as_deref().filter(|name| *name != PathMethod::SlidingMode.name()) {
        return Err(VerifyError::unknown_method(name, vec![PathMethod::SlidingMode.name()]));
    }
    match at(request, request.rate)? {
        Found::NoNumber(what) => Ok(TuneOutcome::Impossible(without_number(what))),
        Found::Does(candidate) => Ok(TuneOutcome::Tuned(Box::new(report(*candidate)))),
        Found::TooCoarse { amplitude } => Ok(TuneOutcome::Impossible(Impossible {
            reason: format!("at {} Hz the push that beats the drift of one sample moves φ further", request.rate),
            rate: enough(request, amplitude)?,
            chattering: Some(shown_up(amplitude)),
        })),
        Found::Loses => Ok(TuneOutcome::Impossible(Impossible {
            reason:
                "constraints that act together share one push, and it drives one of them outwards, whatever its length"
                    .into(),
            rate: None,
            chattering: None,
        })),
    }
}

/// Length or gain of the push as the scenario has it.
fn strength(law: SwitchingLaw) -> (&'static str, f64, &'static str) {
    match law {
        SwitchingLaw::Normalised { amplitude } => ("conditioner.law.normalised.amplitude", amplitude, "m"),
        SwitchingLaw::Sum { gain } => ("conditioner.law.sum.gain", gain, "1"),
    }
}

fn parsed(request: &TuneRequest, text: &str) -> Result<ConditioningScenario, VerifyError> {
    let scenario = ConditioningScenario::parse(&request.name, text)?;
    Ok(match &request.file {
        Some(file) => scenario.in_folder_of(file),
        None => scenario,
    })
}

fn candidate(request: &TuneRequest, rate: f64, wanted: Option<f64>) -> Result<Candidate, VerifyError> {
    let (key, given, unit) = strength(parsed(request, &request.text)?.problem()?.law);
    let strength = wanted.unwrap_or(given);
    let settings = [
        Setting { key: "conditioner.sampling_period", value: 1.0 / rate, unit: "s" },
        Setting { key, value: strength, unit },
    ];
    let (text, changes) = replaced(&request.text, &settings)?;
    let case = ConditioningCase::new(parsed(request, &text)?.problem()?, PathMethod::SlidingMode)?;
    let statement = case.statement()?;
    Ok(Candidate { text, changes, case, statement, strength })
}

/// Keeps the scenario's push where it lies between what the drift needs and what the amplitude allows, else takes the nearer end.
fn at(request: &TuneRequest, rate: f64) -> Result<Found, VerifyError> {
    let mut tried = candidate(request, rate, None)?;
    for _ in 0..ROUNDS {
        let amplitude = bound(&tried.statement, "chattering");
        let contact = tried.case.nominal();
        let enough = contact.push_share * (1.0 + MARGIN) <= 1.0;
        if amplitude <= request.chattering && enough && tried.statement.holds() && tried.case.completed() {
            return Ok(Found::Does(Box::new(tried)));
        }
        if contact.push_share == f64::INFINITY {
            return Ok(Found::Loses);
        }
        // Where the reserve answers, the push is too weak by an amount that the run does not tell.
        let short = if contact.reserve > 0.0 { 1.5 } else { contact.push_share * (1.0 + MARGIN) * 1.02 };
        let least = tried.strength * short;
        let fall = room(contact.fall).max(0.25 * contact.rise);
        let most = 0.99 * tried.strength * (request.chattering - fall) / room(contact.push);
        if !(least <= most) || room(contact.rise) > request.chattering {
            let needed = (room(contact.push) * least / tried.strength + fall).max(room(contact.rise));
            return Ok(Found::TooCoarse { amplitude: needed.max(1.02 * request.chattering) });
        }
        let strength = shown_down(tried.strength.max(least).min(most)).max(shown_up(least).min(most));
        if !(strength > 0.0 && strength.is_finite()) {
            return Ok(Found::NoNumber("push"));
        }
        tried = candidate(request, rate, Some(strength))?;
    }
    Ok(Found::TooCoarse { amplitude: (1.05 * request.chattering).max(room(tried.case.nominal().push)) })
}

/// A rate at which the amplitude can be kept, tried before it is named.
fn enough(request: &TuneRequest, amplitude: f64) -> Result<Option<f64>, VerifyError> {
    let by = |amplitude: f64| (amplitude / request.chattering).clamp(1.05, 4.0);
    let mut rate = request.rate * by(amplitude);
    for _ in 0..8 {
        rate = shown_up(1.03 * rate);
        if !(rate < FASTEST_RATE) {
            return Ok(None);
        }
        match at(request, rate)? {
            Found::Does(_) => return Ok(Some(rate)),
            Found::TooCoarse { amplitude } => rate *= by(amplitude),
            Found::Loses | Found::NoNumber(_) => return Ok(None),
        }
    }
    Ok(None)
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
        changes: candidate.changes,
        trade_off,
        statement: candidate.statement,
        text: candidate.text,
    }
}
