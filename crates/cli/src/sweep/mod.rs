mod journal;
mod table;

use crate::args::SweepArguments;
use crate::keep::files;
use crate::keep::journal::Journal;
use crate::keep::parallel::{Work, jobs};
use crate::say::diagnostic::CliError;
use crate::say::failures::sweep::SweepFailure;
use crate::say::loaded::source;
use crate::say::output::{Outcome, create, json_text, print, print_answer, withdraw, wrote_figures};
use journal::{Opened, write_csv};
use slideway_compare::sweep::{SweepRow, run_sweep};
use slideway_figures::{EscapeStudy, EscapeVariant, draw_escape_times};
use slideway_scenario::sweep::{Axis, Setting, SweepError, SweepPlan, SweepRequest, SweepSummary, shown};
use std::fs;
use std::num::{NonZeroU64, NonZeroUsize};
use std::path::{Path, PathBuf};

impl From<SweepError> for SweepFailure {
    fn from(error: SweepError) -> Self {
        Self { error: Box::new(error), file: String::new() }
    }
}

impl From<SweepError> for CliError {
    fn from(error: SweepError) -> Self {
        SweepFailure::from(error).into()
    }
}

pub(crate) fn run(arguments: &SweepArguments) -> Result<Outcome, CliError> {
    let plan = plan(arguments).map_err(|error| in_file(error, &arguments.scenario))?;
    let default = || Path::new("out").join(format!("sweep-{}", plan.request().name));
    let out = arguments.out.clone().unwrap_or_else(default);
    // Of every cell: a setting may name a file too.
    let files = files::readable(plan.texts(), &arguments.scenario);
    fs::create_dir_all(&out).map_err(|source| CliError::Write { path: out.clone(), source })?;
    let Opened { journal, rows } = journal::open(&out.join("rows.jsonl"), &plan, files)?;
    let rows =
        finish(&plan, &journal, rows, jobs(arguments.jobs)).map_err(|error| in_file(error, &arguments.scenario))?;
    let summary = SweepSummary::new(&plan, &rows);
    let text = write(&out, &plan, &rows, &summary)?;
    if arguments.json {
        print(&text)?;
    } else {
        let whole = format!("{}wrote {}\n", table::render(&plan, &summary), out.join("rows.csv").display());
        print_answer(&whole, &format!("{}\n", table::sentence(&plan, &summary.all)))?;
    }
    Ok(if summary.all.failures.total == 0 { Outcome::Holds } else { Outcome::Fails })
}

/// An error of the request knows its scenario's text, but not what the user called the scenario.
fn in_file(error: CliError, name: &str) -> CliError {
    match error {
        CliError::Sweep(SweepFailure { error, .. }) => SweepFailure { error, file: name.to_owned() }.into(),
        other => other,
    }
}

fn plan(arguments: &SweepArguments) -> Result<SweepPlan, CliError> {
    let (name, text) = source(&arguments.scenario)?;
    let settings = arguments.set.iter().map(|s| Setting::parse(s)).collect::<Result<_, _>>()?;
    let axes = arguments.grid.iter().map(|g| Axis::parse(g)).collect::<Result<_, _>>()?;
    let seeds = arguments.seeds.map(NonZeroU64::get);
    let file = Some(PathBuf::from(&arguments.scenario)).filter(|path| path.exists());
    let method = arguments.method.clone();
    Ok(SweepPlan::new(SweepRequest { name, text, file, method, seeds, settings, axes })?)
}

/// Makes the runs that have no row yet; all rows, in the order of the plan.
fn finish(
    plan: &SweepPlan,
    journal: &Journal,
    mut rows: Vec<Option<SweepRow>>,
    jobs: NonZeroUsize,
) -> Result<Vec<SweepRow>, CliError> {
    let pending: Vec<usize> = (0..rows.len()).filter(|&run| rows[run].is_none()).collect();
    let work = Work { journal, done: &rows, failed: SweepRow::failed };
    for row in work.finish(|sink| run_sweep(&|run| Ok(plan.run(run)?), &pending, jobs, sink))? {
        let run = row.run;
        rows[run] = Some(row);
    }
    Ok(rows.into_iter().flatten().collect())
}

/// Writes rows and summary; returns the text of the summary.
fn write(out: &Path, plan: &SweepPlan, rows: &[SweepRow], summary: &SweepSummary) -> Result<String, CliError> {
    withdraw(&out.join("summary.json"))?;
    create(out.join("rows.csv"), |file| write_csv(plan, rows, file))?;
    draw(out, plan, rows)?;
    let text = json_text(summary)?;
    create(out.join("summary.json"), |file| file.write_all(text.as_bytes()))?;
    Ok(text)
}

/// Draws the escape times, one curve per cell of the grid, if the runs have any.
fn draw(out: &Path, plan: &SweepPlan, rows: &[SweepRow]) -> Result<(), CliError> {
    let Some(column) = plan.columns().iter().position(|c| c == "escape_s") else { return Ok(()) };
    let in_cell = |cell: usize| rows.iter().filter(move |row| plan.cell_of(row.run) == cell);
    let label = |cell: usize| {
        let values: Vec<String> = plan.cell_values(cell).iter().map(shown).collect();
        if values.is_empty() { plan.method().to_owned() } else { values.join(", ") }
    };
    let cells: Vec<(String, Vec<f64>, usize)> = (0..plan.cells())
        .map(|cell| {
            let times: Vec<f64> = in_cell(cell).filter_map(|row| row.values[column]).collect();
            (label(cell), times, in_cell(cell).filter(|row| !row.completed).count())
        })
        // A run without a trap has no escape time and is no failure.
        .filter(|(_, times, _)| !times.is_empty())
        .collect();
    if cells.is_empty() || rows.len() < 2 {
        return Ok(());
    }
    let variants: Vec<EscapeVariant<'_>> = cells
        .iter()
        .map(|(label, escape_s, failures)| EscapeVariant { label, escape_s, failures: *failures })
        .collect();
    let study = EscapeStudy { title: &plan.request().name, variants: &variants };
    wrote_figures(&[draw_escape_times(&study, &out.join("figures"))?]);
    Ok(())
}
