use crate::diagnostic::CliError;
pub(crate) use slideway_scenario::AnyScenario as Loaded;
use slideway_scenario::{BUILT_IN, Scenario, ScenarioError};
use std::path::Path;

/// A built-in scenario by name, else a file.
pub(crate) fn load(name: &str) -> Result<Loaded, CliError> {
    let (stem, text) = source(name)?;
    let loaded = Loaded::parse(&stem, &text).map_err(|error| scenario_error(error, name, Some(text)))?;
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

pub(crate) fn unknown(name: &str) -> CliError {
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
