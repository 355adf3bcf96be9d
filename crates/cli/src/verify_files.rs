//! The files that a scenario names: trials depend on them, and a failing case needs them beside it.

use crate::diagnostic::CliError;
use crate::loaded::scenario_error;
use slideway_lab::LabError;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Component, Path};
use toml::{Table, Value};

/// Keys of a scenario whose values are files.
const KEYS: [&str; 2] = ["csv", "urdf"];

/// Texts of the files that a scenario names, by the names it has for them.
pub(crate) type NamedFiles = BTreeMap<String, String>;

/// Reads the files that a scenario names; `file` is the scenario's own, beside which they lie.
pub(crate) fn read(text: &str, file: &str) -> Result<NamedFiles, CliError> {
    let mut names = Vec::new();
    // What is no TOML names nothing; that it is none is told where the scenario is read.
    text.parse::<Table>().unwrap_or_default().values().for_each(|value| collect(value, &mut names));
    let folder = Path::new(file).parent().unwrap_or(Path::new(""));
    let one = |name: String| {
        let path = folder.join(&name);
        let bytes = fs::read(&path).map_err(|source| scenario_error(LabError::Read { path, source }, file, None))?;
        Ok((name, String::from_utf8_lossy(&bytes).into_owned()))
    };
    names.into_iter().map(one).collect()
}

fn collect(value: &Value, names: &mut Vec<String>) {
    match value {
        Value::Array(list) => list.iter().for_each(|value| collect(value, names)),
        Value::Table(table) => {
            for (key, value) in table {
                match value {
                    Value::String(name) if KEYS.contains(&key.as_str()) => names.push(name.clone()),
                    value => collect(value, names),
                }
            }
        }
        _ => {}
    }
}

/// Whether a file stays inside the folder of the scenario that names it.
pub(crate) fn is_beside(name: &str) -> bool {
    Path::new(name).components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir))
}

/// Writes the files that belong beside a scenario in `out`.
pub(crate) fn write(files: &NamedFiles, out: &Path) -> Result<(), CliError> {
    for (name, text) in files.iter().filter(|(name, _)| is_beside(name)) {
        let path = out.join(name);
        let made = path.parent().map_or(Ok(()), fs::create_dir_all);
        made.and_then(|()| fs::write(&path, text)).map_err(|source| CliError::Write { path, source })?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_found_wherever_a_scenario_names_them() {
        let text = "robot.urdf = 'a.urdf'\n[[constraint]]\nshape = { csv = 'b/c.csv' }\n[path]\nend = 'csv'";
        let mut names = Vec::new();
        text.parse::<Table>().expect("TOML").values().for_each(|value| collect(value, &mut names));
        names.sort();
        assert_eq!(names, ["a.urdf", "b/c.csv"]);
    }

    #[test]
    fn only_what_stays_inside_the_folder_is_beside_the_scenario() {
        for (name, beside) in
            [("a.csv", true), ("./b/a.csv", true), ("../a.csv", false), ("b/../../a.csv", false), ("/a.csv", false)]
        {
            assert_eq!(is_beside(name), beside, "{name}");
        }
    }
}
