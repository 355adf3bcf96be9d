//! A trial of a campaign, written as a scenario.

use crate::any::AnyScenario;
use crate::error::ScenarioError;
use slideway_verify::Trial;
use toml::{Table, Value};

impl AnyScenario {
    /// A trial as a scenario that `slideway compare` runs: this one's text with the trial's disturbances and the method judged, written
    /// anew. Files that it names keep their names, so it has to lie where this one does; the second line says so where it matters.
    ///
    /// # Errors
    ///
    /// The text cannot carry the table.
    pub fn of_trial(&self, trial: &Trial, method: &str, seed: u64) -> Result<String, ScenarioError> {
        let unreadable = |message: String| ScenarioError::Syntax { message, span: None };
        let mut document: Table = self.text().parse().map_err(|e: toml::de::Error| unreadable(e.to_string()))?;
        let disturbances = Table::try_from(&trial.disturbances).map_err(|error| unreadable(error.to_string()))?;
        document.remove("disturbances");
        if !disturbances.is_empty() {
            document.insert("disturbances".into(), Value::Table(disturbances));
        }
        if let Self::Speed(_) = self {
            let compare = document.entry("compare").or_insert_with(|| Value::Table(Table::new()));
            if let Value::Table(compare) = compare {
                compare.insert("method".into(), method.into());
            }
        }
        let text = toml::to_string(&document).map_err(|error| unreadable(error.to_string()))?;
        Ok(heading(self.name(), trial, seed, &document) + &text)
    }
}

fn heading(name: &str, trial: &Trial, seed: u64, document: &Table) -> String {
    let shown: String = name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    let (number, size) = (trial.number, trial.size);
    let mut heading = format!("# Trial {number} of the campaign around {shown} with seed {seed}, at size {size}.\n");
    if names_files(&Value::Table(document.clone())) {
        heading += "# It names files relative to its own folder: keep it beside the scenario it was made from.\n";
    }
    heading
}

/// Whether a scenario names files.
fn names_files(value: &Value) -> bool {
    match value {
        Value::Table(table) => {
            table.iter().any(|(key, value)| matches!(key.as_str(), "csv" | "urdf") || names_files(value))
        }
        Value::Array(list) => list.iter().any(names_files),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideway_verify::TrialDisturbances;

    #[test]
    fn a_scenario_that_names_files_says_where_to_keep_its_trials() {
        let trial = Trial {
            number: 0,
            size: 0.5,
            disturbances: TrialDisturbances::default(),
            outside: Vec::new(),
            checks: Vec::new(),
        };
        let built_in = AnyScenario::built_in("planar-line").expect("there").expect("valid");
        let text = built_in.of_trial(&trial, "sliding-mode", 3).expect("writes");
        assert!(text.starts_with("# Trial 0 of the campaign around planar-line with seed 3, at size 0.5"), "{text}");
        let named: Table = "path.position.spline.csv = 'points.csv'".parse().expect("TOML");
        assert!(heading("mine", &trial, 3, &named).contains("keep it beside") && !text.contains("keep it beside"));
    }
}
