use crate::say::diagnostic::{CliError, Named};
use crate::say::words::nearest;
use slideway_compare::CompareError;
use slideway_lab::conditioning::ConditioningScenario;
use slideway_lab::{BUILT_IN, Expectation, LabError, Scenario, ScenarioKind, scenario_kind};
use std::path::Path;

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

    /// The verdict that the scenario is expected to get.
    pub(crate) fn expectation(&self) -> Expectation {
        match self {
            Self::Speed(scenario) => scenario.expectation(),
            Self::Conditioning(scenario) => scenario.expectation(),
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

/// An error of a comparison: of the problem, it points into the scenario's text.
pub(crate) fn compare_error(error: CompareError, file: &str, text: &str) -> CliError {
    match error {
        CompareError::Lab(error) => scenario_error(error, file, Some(text.to_owned())),
        error => CliError::Compare { error: Box::new(error), file: Some(file.to_owned()) },
    }
}

pub(crate) fn unknown(name: &str) -> CliError {
    let nearest = nearest(name, BUILT_IN.iter().map(|b| b.name));
    CliError::Unknown { what: Named::Scenario, name: name.to_owned(), nearest }
}
