use crate::say::diagnostic::{CliError, Named};
use crate::say::words::nearest;
use slideway_compare::CompareError;
use slideway_scenario::{AnyScenario, BUILT_IN, Scenario, ScenarioError};
use std::path::Path;

/// A built-in scenario by name, else a file.
pub(crate) fn load(name: &str) -> Result<AnyScenario, CliError> {
    let (stem, text) = source(name)?;
    let loaded = AnyScenario::parse(&stem, &text).map_err(|error| scenario_error(error, name, Some(text)))?;
    // Files that a scenario names lie beside it.
    Ok(if Path::new(name).exists() { loaded.in_folder_of(Path::new(name)) } else { loaded })
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

pub(crate) fn scenario_error(error: impl Into<ScenarioError>, file: &str, text: Option<String>) -> CliError {
    CliError::Scenario { error: Box::new(error.into()), file: file.to_owned(), text }
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
