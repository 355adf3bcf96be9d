//! `rows.jsonl`: what a sweep has finished, one line per run in the order in which the runs end, after a line that says
//! which sweep it is. A run counts as finished when its line is whole.

use crate::diagnostic::CliError;
use crate::sweep_error::SweepFailure;
use serde::{Deserialize, Serialize};
use slideway_lab::sweep::{SweepPlan, SweepRow, shown};
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Read as _, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// Everything that the rows depend on.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Identity {
    version: String,
    scenario: String,
    text: String,
    method: String,
    seeds: Option<u64>,
    set: Vec<String>,
    grid: Vec<String>,
    columns: Vec<String>,
}

/// The journal, open for appending and locked against a second sweep.
#[derive(Debug)]
pub(crate) struct Journal {
    path: PathBuf,
    file: Mutex<File>,
}

/// A journal with the rows it held when it was opened, by number.
pub(crate) struct Opened {
    pub(crate) journal: Journal,
    pub(crate) rows: Vec<Option<SweepRow>>,
}

impl Identity {
    fn new(plan: &SweepPlan) -> Self {
        let request = plan.request();
        let values = |values: &[toml::Value]| values.iter().map(toml::Value::to_string).collect::<Vec<_>>().join(",");
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            scenario: request.name.clone(),
            text: request.text.clone(),
            method: plan.method().to_owned(),
            seeds: request.seeds,
            set: request.settings.iter().map(|s| format!("{}={}", s.key, s.value)).collect(),
            grid: request.axes.iter().map(|a| format!("{}={}", a.key, values(&a.values))).collect(),
            columns: plan.columns().to_vec(),
        }
    }

    /// The first thing in which two sweeps differ: what it is, what it was and what it is now.
    fn difference(&self, now: &Self) -> Option<(&'static str, String, String)> {
        let seeds = |seeds: Option<u64>| seeds.map_or("not given".into(), |n| format!("--seeds {n}"));
        let list = |list: &[String]| if list.is_empty() { "not given".into() } else { list.join(" ") };
        let line = |a: &str, b: &str| differing_line(a, b);
        [
            ("version of the program", self.version.clone(), now.version.clone()),
            ("scenario", self.scenario.clone(), now.scenario.clone()),
            ("scenario's text", line(&self.text, &now.text), line(&now.text, &self.text)),
            ("method", self.method.clone(), now.method.clone()),
            ("number of seeds", seeds(self.seeds), seeds(now.seeds)),
            ("--set", list(&self.set), list(&now.set)),
            ("--grid", list(&self.grid), list(&now.grid)),
            ("list of columns", list(&self.columns), list(&now.columns)),
        ]
        .into_iter()
        .find(|(_, was, now)| was != now)
    }
}

/// The first line of `a` that `b` has differently, with its number; empty if there is none.
fn differing_line(a: &str, b: &str) -> String {
    let mut other = b.split('\n');
    let differing = a.split('\n').enumerate().find(|(_, line)| other.next() != Some(line));
    match differing {
        Some((i, line)) => format!("`{line}` in line {}", i + 1),
        None if a == b => String::new(),
        None => "shorter".into(),
    }
}

impl Journal {
    /// Opens the journal of a plan, new or begun; a last line that was cut short is removed.
    pub(crate) fn open(path: &Path, plan: &SweepPlan) -> Result<Opened, CliError> {
        let write = |source| CliError::Write { path: path.to_owned(), source };
        let mut file =
            OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path).map_err(write)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(SweepFailure::Busy { path: path.to_owned() }.into()),
            Err(TryLockError::Error(source)) => return Err(write(source)),
        }
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(write)?;
        let whole = bytes.iter().rposition(|&b| b == b'\n').map_or(0, |end| end + 1);
        let identity = Identity::new(plan);
        let first = to_line(&identity).map_err(write)?;
        let foreign = |line, reason| SweepFailure::Foreign { path: path.to_owned(), line, reason };
        if whole == 0 && !first.as_bytes().starts_with(&bytes) {
            return Err(foreign(1, "it does not begin like one".into()).into());
        }
        let text = std::str::from_utf8(&bytes[..whole]).map_err(|error| foreign(1, error.to_string()))?;
        let rows = finished(text, plan, &identity, path)?;
        file.set_len(whole as u64).and_then(|()| file.seek(SeekFrom::End(0)).map(drop)).map_err(write)?;
        if whole == 0 {
            file.write_all(first.as_bytes()).map_err(write)?;
        }
        Ok(Opened { journal: Self { path: path.to_owned(), file: Mutex::new(file) }, rows })
    }

    /// Appends a finished row in one write, so that a killed sweep leaves whole lines and at most one cut short.
    pub(crate) fn append(&self, row: &SweepRow) -> Result<(), CliError> {
        let write = |source| CliError::Write { path: self.path.clone(), source };
        let line = to_line(row).map_err(write)?;
        // A thread that panicked while writing has left at most a line cut short.
        let mut file = self.file.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        file.write_all(line.as_bytes()).map_err(write)
    }
}

fn to_line(value: &impl Serialize) -> std::io::Result<String> {
    Ok(serde_json::to_string(value)? + "\n")
}

/// The rows in the text of a journal, by number.
fn finished(text: &str, plan: &SweepPlan, now: &Identity, path: &Path) -> Result<Vec<Option<SweepRow>>, CliError> {
    let foreign = |line, reason| SweepFailure::Foreign { path: path.to_owned(), line, reason };
    let mut rows = vec![None; plan.runs()];
    let mut lines = text.lines().enumerate();
    let Some((_, first)) = lines.next() else { return Ok(rows) };
    let was: Identity = serde_json::from_str(first).map_err(|error| foreign(1, error.to_string()))?;
    if let Some((what, was, now)) = was.difference(now) {
        return Err(SweepFailure::Different { path: path.to_owned(), what, was, now }.into());
    }
    for (i, line) in lines {
        let row: SweepRow = serde_json::from_str(line).map_err(|error| foreign(i + 1, error.to_string()))?;
        if row.values.len() != plan.columns().len() {
            return Err(
                foreign(i + 1, format!("{} values instead of {}", row.values.len(), plan.columns().len())).into()
            );
        }
        match rows.get_mut(row.run) {
            Some(slot) => *slot = Some(row),
            None => return Err(foreign(i + 1, format!("there is no run {}", row.run)).into()),
        }
    }
    Ok(rows)
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
