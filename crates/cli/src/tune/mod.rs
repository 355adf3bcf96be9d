use crate::args::TuneArguments;
use crate::say::diagnostic::CliError;
use crate::say::loaded::{load, scenario_error};
use crate::say::output::{Outcome, create, print_answer, print_json};
use crate::say::table::Table;
use crate::say::words::apart;
use slideway_scenario::{Change, TunedScenario, Tuning, TuningError};
use slideway_verify::{Impossible, Prediction, TuneRequest, VerifyError};
use std::path::Path;

pub(crate) fn run(arguments: &TuneArguments) -> Result<Outcome, CliError> {
    for (option, value) in [("chattering", arguments.chattering), ("rate", arguments.rate)] {
        if !(value > 0.0 && value.is_finite()) {
            let remedy = "give a positive number: an amplitude, for example 0.05, and a rate in Hz, for example 1000";
            return Err(CliError::Option { option, value, remedy });
        }
    }
    let scenario = load(&arguments.scenario)?;
    let request = TuneRequest { chattering: arguments.chattering, rate: arguments.rate };
    let outcome = scenario
        .tuned(arguments.method.as_deref(), request)
        .map_err(|error| in_file(error, arguments, scenario.text()))?;
    if let (Tuning::Tuned(tuned), Some(out)) = (&outcome, &arguments.out) {
        create(out.clone(), |file| file.write_all(tuned.text.as_bytes()))?;
    }
    if arguments.json {
        print_json(&outcome)?;
    } else {
        let (whole, verdict) = shown(&outcome, arguments, &request);
        print_answer(&whole, &verdict)?;
    }
    Ok(match outcome {
        Tuning::Tuned(_) => Outcome::Holds,
        Tuning::Impossible(_) => Outcome::Fails,
    })
}

/// An error of the scenario points into its text.
fn in_file(error: TuningError, arguments: &TuneArguments, text: &str) -> CliError {
    let pointed = |error| scenario_error(error, &arguments.scenario, Some(text.to_owned()));
    match error {
        TuningError::Scenario(error) => pointed(error),
        TuningError::Verify(VerifyError::Problem(error)) => pointed(error.into()),
        TuningError::Verify(VerifyError::Optimum(error)) => error.into(),
        error => CliError::Tune { error: Box::new(error), name: arguments.scenario.clone() },
    }
}

/// The whole answer, and the values or the refusal alone.
fn shown(outcome: &Tuning, arguments: &TuneArguments, request: &TuneRequest) -> (String, String) {
    match outcome {
        Tuning::Tuned(tuned) => (tuned_in_words(tuned, arguments.out.as_deref()), changes(tuned)),
        Tuning::Impossible(impossible) => {
            let text = impossible_in_words(impossible, request);
            (text.clone(), text)
        }
    }
}

fn changes(tuned: &TunedScenario) -> String {
    if tuned.changes.is_empty() {
        return "Nothing needs to change.\n".into();
    }
    let line = |c: &Change| format!("{} = {} {} (was {})\n", c.key, c.after, c.unit, c.before);
    tuned.changes.iter().map(line).collect()
}

fn tuned_in_words(tuned: &TunedScenario, out: Option<&Path>) -> String {
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
        let given = [p.lower, p.upper, p.measured];
        let any = given.iter().flatten().next().copied().unwrap_or(0.0);
        let texts = apart(given.map(|value| value.unwrap_or(any)));
        let name = format!("{}: {}", p.name, p.text);
        let numbers = given.into_iter().zip(texts).map(|(value, text)| value.map_or("-".into(), |_| text));
        table.row([name].into_iter().chain(numbers).chain([p.unit.clone()]));
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
