use crate::args::{Arguments, Command, Kind};
use crate::claims::attack;
use crate::say::diagnostic::CliError;
use crate::say::loaded::unknown;
use crate::say::output::{Outcome, create, json_text, print, tell};
use crate::verify::merge;
use crate::{claims, compare, reproduce, robot, shell, study, sweep, tune, verify};
use slideway_robot::models::Model;
use slideway_scenario::{AnyScenario, BUILT_IN, CONDITIONING_TEMPLATE, ConditioningScenario, Scenario, TEMPLATE};
use slideway_study::Study;
use std::io::Write as _;
use std::path::{Path, PathBuf};

pub(crate) fn run(arguments: Arguments) -> Result<Outcome, CliError> {
    arguments.loudness().choose();
    match arguments.command {
        Command::Compare(arguments) => compare::run(&arguments),
        Command::Reproduce(arguments) => reproduce::run(&arguments),
        Command::Robot(arguments) => robot::run(&arguments),
        Command::Sweep(arguments) => sweep::run(&arguments),
        Command::Verify(arguments) => verify::run(&arguments),
        Command::Merge(arguments) => merge::run(&arguments),
        Command::Tune(arguments) => tune::run(&arguments),
        Command::Study(arguments) => study::run(&arguments),
        Command::Claims(arguments) => claims::run(&arguments),
        Command::Attack(arguments) => attack::run(&arguments),
        Command::List => list(),
        Command::Show { scenario } => show(&scenario),
        Command::Init { file, kind } => init(&file, kind),
        Command::Schema { kind, out } => schema(kind, out),
        Command::Completions { shell } => shell::completions(shell),
        Command::Man { out } => shell::man(out.as_deref()),
    }
}

fn list() -> Result<Outcome, CliError> {
    let scenario = |b: &slideway_scenario::BuiltIn| {
        (b.name, AnyScenario::parse(b.name, b.text).map(|s| s.description().to_owned()).unwrap_or_default())
    };
    let robot = |model: Model| (model.name(), model.summary().to_owned());
    let scenarios: Vec<(&str, String)> = BUILT_IN.iter().map(scenario).collect();
    let robots: Vec<(&str, String)> = Model::ALL.into_iter().map(robot).collect();
    let studies: Vec<(&str, String)> = Study::ALL.into_iter().map(|s| (s.name(), s.summary().to_owned())).collect();
    let width = scenarios.iter().chain(&robots).chain(&studies).map(|(name, _)| name.len()).max().unwrap_or(0);
    let lines = |entries: &[(&str, String)]| -> String {
        entries.iter().map(|(name, description)| format!("  {name:width$}  {description}\n")).collect()
    };
    print(&format!("scenarios\n{}robots\n{}studies\n{}", lines(&scenarios), lines(&robots), lines(&studies)))?;
    Ok(Outcome::Holds)
}

fn show(name: &str) -> Result<Outcome, CliError> {
    let built_in = BUILT_IN.iter().find(|b| b.name == name).ok_or_else(|| unknown(name))?;
    print(built_in.text)?;
    Ok(Outcome::Holds)
}

fn init(file: &Path, kind: Kind) -> Result<Outcome, CliError> {
    let template = match kind {
        Kind::Speed => TEMPLATE,
        Kind::Conditioning => CONDITIONING_TEMPLATE,
    };
    let write = |source: std::io::Error| CliError::Write { path: file.to_owned(), source };
    let opened = std::fs::File::create_new(file);
    let mut out = match opened {
        Err(error) if error.kind() == std::io::ErrorKind::AlreadyExists => {
            return Err(CliError::Exists { path: file.to_owned() });
        }
        opened => opened.map_err(write)?,
    };
    // A template that could not be written whole leaves nothing.
    out.write_all(template.as_bytes()).inspect_err(|_| drop(std::fs::remove_file(file))).map_err(write)?;
    tell(&format!("wrote {0}; run it with `slideway compare {0}`\n", file.display()))?;
    Ok(Outcome::Holds)
}

fn schema(kind: Kind, out: Option<PathBuf>) -> Result<Outcome, CliError> {
    let text = json_text(&match kind {
        Kind::Speed => Scenario::schema(),
        Kind::Conditioning => ConditioningScenario::schema(),
    })?;
    match out {
        Some(out) => create(out, |file| file.write_all(text.as_bytes()))?,
        None => print(&text)?,
    }
    Ok(Outcome::Holds)
}
