//! The files that a scenario names: rows and trials depend on them, and a failing case needs them beside it.

use crate::say::diagnostic::CliError;
use crate::say::failures::difference::{Difference, Thing};
use crate::say::loaded::scenario_error;
use crate::say::output::create;
use slideway_scenario::ScenarioError;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Component, Path, PathBuf};
use toml::{Table, Value};

/// Keys of a scenario whose values are files.
const KEYS: [&str; 2] = ["csv", "urdf"];

/// Texts of the files that a scenario names, by the names it has for them.
pub(crate) type NamedFiles = BTreeMap<String, String>;

/// Reads the files that a scenario names; `file` is the scenario's own, beside which they lie.
pub(crate) fn read(text: &str, file: &str) -> Result<NamedFiles, CliError> {
    let one = |name: String| {
        let path = beside(file, &name);
        let bytes =
            fs::read(&path).map_err(|source| scenario_error(ScenarioError::Read { path, source }, file, None))?;
        Ok((name, String::from_utf8_lossy(&bytes).into_owned()))
    };
    names([text]).into_iter().map(one).collect()
}

/// Those files that any of several scenarios in place of `file` names and that can be read: about one that cannot, the run that needs
/// it has more to tell.
pub(crate) fn readable<'a>(texts: impl IntoIterator<Item = &'a str>, file: &str) -> NamedFiles {
    let one = |name: String| {
        let bytes = fs::read(beside(file, &name)).ok()?;
        Some((name, String::from_utf8_lossy(&bytes).into_owned()))
    };
    names(texts).into_iter().filter_map(one).collect()
}

fn beside(file: &str, name: &str) -> PathBuf {
    Path::new(file).parent().unwrap_or(Path::new("")).join(name)
}

/// The names of files in scenarios, each once.
fn names<'a>(texts: impl IntoIterator<Item = &'a str>) -> BTreeSet<String> {
    let mut names = Vec::new();
    for text in texts {
        // What is no TOML names nothing; that it is none is told where the scenario is read.
        text.parse::<Table>().unwrap_or_default().values().for_each(|value| collect(value, &mut names));
    }
    names.into_iter().collect()
}

/// What may differ between two scenarios' files, for [`Difference::first`].
pub(crate) fn differences(was: &NamedFiles, now: &NamedFiles) -> [Thing; 2] {
    let list = |files: &NamedFiles| files.keys().cloned().collect::<Vec<_>>().join(", ");
    let joined = |files: &NamedFiles| files.values().cloned().collect::<Vec<_>>().join("\n");
    [("list of files", list(was), list(now)), Difference::of_texts("text of its files", &joined(was), &joined(now))]
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
        made.map_err(|source| CliError::Write { path: path.clone(), source })?;
        create(path, |file| file.write_all(text.as_bytes()))?;
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
