//! `rows.jsonl`: the journal of a sweep, a line per run; and its rows as a table.

use crate::keep::files::{self, NamedFiles};
use crate::keep::journal::{Identity, Journal};
use crate::say::diagnostic::CliError;
use crate::say::failures::difference::Difference;
use serde::{Deserialize, Serialize};
use slideway_compare::sweep::SweepRow;
use slideway_scenario::sweep::{SweepPlan, shown};
use std::path::Path;

/// Everything that the rows depend on.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct SweepIdentity {
    version: String,
    scenario: String,
    text: String,
    files: NamedFiles,
    method: String,
    seeds: Option<u64>,
    set: Vec<String>,
    grid: Vec<String>,
    columns: Vec<String>,
}

/// A journal with the rows it held when it was opened, by number.
pub(crate) struct Opened {
    pub(crate) journal: Journal,
    pub(crate) rows: Vec<Option<SweepRow>>,
}

impl SweepIdentity {
    fn new(plan: &SweepPlan, files: NamedFiles) -> Self {
        let request = plan.request();
        let values = |values: &[toml::Value]| values.iter().map(toml::Value::to_string).collect::<Vec<_>>().join(",");
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            scenario: request.name.clone(),
            text: request.text.clone(),
            files,
            method: plan.method().to_owned(),
            seeds: request.seeds,
            set: request.settings.iter().map(|s| format!("{}={}", s.key, s.value)).collect(),
            grid: request.axes.iter().map(|a| format!("{}={}", a.key, values(&a.values))).collect(),
            columns: plan.columns().to_vec(),
        }
    }
}

impl Identity for SweepIdentity {
    const WRITER: &'static str = "sweep";

    fn difference(&self, now: &Self) -> Option<Difference> {
        let seeds = |seeds: Option<u64>| seeds.map_or("not given".into(), |n| format!("--seeds {n}"));
        let list = |list: &[String]| if list.is_empty() { "not given".into() } else { list.join(" ") };
        let [list_of_files, texts_of_files] = files::differences(&self.files, &now.files);
        Difference::first([
            ("version of the program", self.version.clone(), now.version.clone()),
            ("scenario", self.scenario.clone(), now.scenario.clone()),
            Difference::of_texts("scenario's text", &self.text, &now.text),
            list_of_files,
            texts_of_files,
            ("method", self.method.clone(), now.method.clone()),
            ("number of seeds", seeds(self.seeds), seeds(now.seeds)),
            ("--set", list(&self.set), list(&now.set)),
            ("--grid", list(&self.grid), list(&now.grid)),
            ("list of columns", list(&self.columns), list(&now.columns)),
        ])
    }
}

/// Opens the journal of a plan, new or begun; `files` are those that its scenario names.
pub(crate) fn open(path: &Path, plan: &SweepPlan, files: NamedFiles) -> Result<Opened, CliError> {
    let mut rows = vec![None; plan.runs()];
    let take = |row: SweepRow| {
        if row.values.len() != plan.columns().len() {
            return Err(format!("{} values instead of {}", row.values.len(), plan.columns().len()));
        }
        let run = row.run;
        let slot = rows.get_mut(run).ok_or_else(|| format!("there is no run {run}"))?;
        *slot = Some(row);
        Ok(())
    };
    let journal = Journal::open(path, &SweepIdentity::new(plan, files), take)?;
    Ok(Opened { journal, rows })
}

/// Writes the rows in the order of the plan as CSV, units in the column names, empty fields where a run has no value.
pub(crate) fn write_csv(plan: &SweepPlan, rows: &[SweepRow], out: &mut dyn std::io::Write) -> std::io::Result<()> {
    let mut csv = csv::Writer::from_writer(out);
    let keys = plan.request().axes.iter().map(|axis| axis.key.as_str());
    let fixed = ["run", "seed"].into_iter().chain(keys).chain(["completed", "broken"]);
    csv.write_record(fixed.chain(plan.columns().iter().map(String::as_str)))?;
    for row in rows {
        let seed = plan.seed_of(row.run).map_or(String::new(), |seed| seed.to_string());
        let cell = plan.cell_values(plan.cell_of(row.run)).iter().map(shown);
        let values = row.values.iter().map(|value| value.map_or(String::new(), |v| v.to_string()));
        let fixed = [row.run.to_string(), seed].into_iter().chain(cell);
        csv.write_record(fixed.chain([row.completed.to_string(), row.broken.to_string()]).chain(values))?;
    }
    csv.flush()
}
