use crate::args::{Arguments, Command, Kind};
use crate::diagnostic::CliError;
use crate::{attack, claims, compare, robot, sweep};
use slideway_lab::conditioning::ConditioningScenario;
use slideway_lab::{BUILT_IN, CONDITIONING_TEMPLATE, LabError, Scenario, ScenarioKind, TEMPLATE, scenario_kind};
use slideway_robot::models::Model;
use std::io::Write as _;
use std::path::Path;

/// How a command ended, short of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// Done, and the verdict (if there was one) holds.
    Holds,
    /// Done, and the verdict does not hold.
    Fails,
}

impl Outcome {
    pub(crate) fn exit_status(self) -> u8 {
        match self {
            Self::Holds => 0,
            Self::Fails => 1,
        }
    }
}

pub(crate) fn run(arguments: Arguments) -> Result<Outcome, CliError> {
    match arguments.command {
        Command::Compare(arguments) => compare::run(&arguments),
        Command::Robot(arguments) => robot::run(&arguments),
        Command::Sweep(arguments) => sweep::run(&arguments),
        Command::Claims(arguments) => claims::run(&arguments),
        Command::Attack(arguments) => attack::run(&arguments),
        Command::List => Ok(list()),
        Command::Show { scenario } => show(&scenario),
        Command::Init { file, kind } => init(&file, kind),
    }
}

/// Prints to standard output; a reader that closes the pipe early is no error.
pub(crate) fn print(text: &str) {
    let mut out = std::io::stdout().lock();
    let _ = out.write_all(text.as_bytes()).and_then(|()| out.flush());
}

fn list() -> Outcome {
    let scenario = |b: &slideway_lab::BuiltIn| {
        (b.name, Loaded::parse(b.name, b.text).map(|s| s.description().to_owned()).unwrap_or_default())
    };
    let robot = |model: Model| (model.name(), model.summary().to_owned());
    let scenarios: Vec<(&str, String)> = BUILT_IN.iter().map(scenario).collect();
    let robots: Vec<(&str, String)> = Model::ALL.into_iter().map(robot).collect();
    let width = scenarios.iter().chain(&robots).map(|(name, _)| name.len()).max().unwrap_or(0);
    let lines = |entries: &[(&str, String)]| -> String {
        entries.iter().map(|(name, description)| format!("  {name:width$}  {description}\n")).collect()
    };
    print(&format!("scenarios\n{}robots\n{}", lines(&scenarios), lines(&robots)));
    Outcome::Holds
}

fn show(name: &str) -> Result<Outcome, CliError> {
    let built_in = BUILT_IN.iter().find(|b| b.name == name).ok_or_else(|| unknown(name))?;
    print(built_in.text);
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
    out.write_all(template.as_bytes()).map_err(write)?;
    print(&format!("wrote {0}; run it with `slideway compare {0}`\n", file.display()));
    Ok(Outcome::Holds)
}

/// A scenario of either kind.
#[derive(Debug)]
pub(crate) enum Loaded {
    Speed(Box<Scenario>),
    Conditioning(Box<ConditioningScenario>),
}

impl Loaded {
    pub(crate) fn parse(name: &str, text: &str) -> Result<Self, LabError> {
        Ok(match scenario_kind(text) {
            ScenarioKind::Speed => Self::Speed(Box::new(Scenario::parse(name, text)?)),
            ScenarioKind::Conditioning => Self::Conditioning(Box::new(ConditioningScenario::parse(name, text)?)),
        })
    }

    pub(crate) fn name(&self) -> &str {
        match self {
            Self::Speed(scenario) => scenario.name(),
            Self::Conditioning(scenario) => scenario.name(),
        }
    }

    pub(crate) fn description(&self) -> &str {
        match self {
            Self::Speed(scenario) => scenario.description(),
            Self::Conditioning(scenario) => scenario.description(),
        }
    }
}

/// A built-in scenario by name, else a file.
pub(crate) fn load(name: &str) -> Result<Loaded, CliError> {
    let (stem, text) = source(name)?;
    let loaded = Loaded::parse(&stem, &text).map_err(|error| scenario_error(error, name, Some(text)))?;
    Ok(match loaded {
        // Files that a scenario names lie beside it.
        Loaded::Speed(scenario) if Path::new(name).exists() => {
            Loaded::Speed(Box::new(scenario.in_folder_of(Path::new(name))))
        }
        Loaded::Conditioning(scenario) if Path::new(name).exists() => {
            Loaded::Conditioning(Box::new(scenario.in_folder_of(Path::new(name))))
        }
        loaded => loaded,
    })
}

/// Name and text of a scenario of either kind: built in, else a file, named by its stem.
pub(crate) fn source(name: &str) -> Result<(String, String), CliError> {
    if let Some(built_in) = BUILT_IN.iter().find(|b| b.name == name) {
        return Ok((name.to_owned(), built_in.text.to_owned()));
    }
    let path = Path::new(name);
    if !path.exists() {
        return Err(unknown(name));
    }
    let text = Scenario::read_text(path).map_err(|error| scenario_error(error, name, None))?;
    let stem = path.file_stem().map_or_else(|| "scenario".into(), |s| s.to_string_lossy().into_owned());
    Ok((stem, text))
}

pub(crate) fn scenario_error(error: slideway_lab::LabError, file: &str, text: Option<String>) -> CliError {
    CliError::Scenario { error: Box::new(error), file: file.to_owned(), text }
}

fn unknown(name: &str) -> CliError {
    let nearest = BUILT_IN
        .iter()
        .map(|b| (edit_distance(name, b.name), b.name))
        .min()
        .filter(|(distance, name)| 3 * distance <= name.len())
        .map(|(_, name)| name);
    CliError::UnknownScenario { name: name.to_owned(), nearest }
}

/// Levenshtein distance, for suggesting a name.
pub(crate) fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let substitute = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = substitute.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}
