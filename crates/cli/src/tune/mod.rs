use crate::args::TuneArguments;
use crate::say::diagnostic::CliError;
use crate::say::loaded::{scenario_error, source};
use crate::say::output::{Outcome, print_answer, print_json, wrote};
use crate::say::table::Table;
use crate::say::words::short;
use slideway_verify::{Change, Impossible, Prediction, TuneOutcome, TuneRequest, Tuned, VerifyError, tune};
use std::fs;
use std::path::{Path, PathBuf};

pub(crate) fn run(arguments: &TuneArguments) -> Result<Outcome, CliError> {
    for (option, value) in [("chattering", arguments.chattering), ("rate", arguments.rate)] {
        if !(value > 0.0 && value.is_finite()) {
            let remedy = "give a positive number: an amplitude, for example 0.05, and a rate in Hz, for example 1000";
            return Err(CliError::Option { option, value, remedy });
        }
    }
    let (name, text) = source(&arguments.scenario)?;
    let file = Some(PathBuf::from(&arguments.scenario)).filter(|path| path.exists());
    let request = TuneRequest { name, text, file, chattering: arguments.chattering, rate: arguments.rate };
    let outcome = tune(&request).map_err(|error| in_file(error, arguments, &request))?;
    if let (TuneOutcome::Tuned(tuned), Some(out)) = (&outcome, &arguments.out) {
        let write = |source| CliError::Write { path: out.clone(), source };
        fs::write(out, &tuned.text).map_err(write)?;
        wrote(out);
    }
    if arguments.json {
        print_json(&outcome)?;
    } else {
        let (whole, verdict) = shown(&outcome, arguments, &request);
        print_answer(&whole, &verdict);
    }
    Ok(match outcome {
        TuneOutcome::Tuned(_) => Outcome::Holds,
        TuneOutcome::Impossible(_) => Outcome::Fails,
    })
}

/// An error of the scenario points into its text.
fn in_file(error: VerifyError, arguments: &TuneArguments, request: &TuneRequest) -> CliError {
    match error {
        VerifyError::Scenario(error) => scenario_error(error, &arguments.scenario, Some(request.text.clone())),
        VerifyError::Optimum(error) => error.into(),
        error => CliError::Tune { error: Box::new(error), name: arguments.scenario.clone() },
    }
}

/// The whole answer, and the values or the refusal alone.
fn shown(outcome: &TuneOutcome, arguments: &TuneArguments, request: &TuneRequest) -> (String, String) {
    match outcome {
        TuneOutcome::Tuned(tuned) => (tuned_in_words(tuned, arguments.out.as_deref()), changes(tuned)),
        TuneOutcome::Impossible(impossible) => {
            let text = impossible_in_words(impossible, request);
            (text.clone(), text)
        }
    }
}

fn changes(tuned: &Tuned) -> String {
    if tuned.changes.is_empty() {
        return "Nothing needs to change.\n".into();
    }
    let line = |c: &Change| format!("{} = {} {} (was {})\n", c.key, c.after, c.unit, c.before);
    tuned.changes.iter().map(line).collect()
}

fn tuned_in_words(tuned: &Tuned, out: Option<&Path>) -> String {
    let mut text = changes(tuned) + "\n";
    for sentence in &tuned.trade_off {
        text += &format!("{sentence}\n");
    }
    text += &format!("\n{}\n", predictions(&tuned.predictions));
    match out {
        Some(out) => text += &format!("wrote {0}; `slideway verify {0}` tries it under disturbances\n", out.display()),
        None => text += "--out FILE writes the scenario with these values.\n",
    }
    text
}

/// What is guaranteed beside what the run gave.
fn predictions(predictions: &[Prediction]) -> String {
    let header = ["guaranteed of the tuned scenario", "at least", "at most", "in the run", ""];
    let mut table = Table::new(header).numbers(1..4);
    for p in predictions {
        let number = |value: Option<f64>| value.map_or("-".into(), short);
        let name = format!("{}: {}", p.name, p.text);
        table.row([name, number(p.lower), number(p.upper), number(p.measured), p.unit.clone()]);
    }
    table.terminal()
}

fn impossible_in_words(impossible: &Impossible, request: &TuneRequest) -> String {
    let mut text = format!("No: {}.\n", impossible.reason);
    if let Some(rate) = impossible.rate {
        text += &format!("A rate of {rate} Hz would do for a chattering of {}.\n", request.chattering);
    }
    if let Some(chattering) = impossible.chattering {
        text += &format!("At {} Hz a chattering of at least {chattering} has to be allowed.\n", request.rate);
    }
    text
}
