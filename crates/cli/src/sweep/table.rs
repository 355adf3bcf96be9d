use crate::say::table::Table;
use crate::say::words::short;
use slideway_compare::sweep::{Statistics, SweepTotals};
use slideway_scenario::sweep::{SweepPlan, SweepSummary, shown};

/// Columns of the rows that a grid's table shows, where they exist.
const GRID_COLUMNS: [&str; 5] = ["duration_s", "escape_s", "mean_deviation_m", "rms_error_norm", "limit_ratio_peak"];

/// A finished sweep for a terminal: a line per number without a grid, a line per cell with one.
pub(crate) fn render(plan: &SweepPlan, summary: &SweepSummary) -> String {
    let table = if summary.grid.is_empty() { numbers(plan, &summary.all) } else { cells(plan, summary) };
    format!("{}\n{}\n\n{}\n", heading(plan, summary), table.terminal(), sentence(plan, &summary.all))
}

fn heading(plan: &SweepPlan, summary: &SweepSummary) -> String {
    let settings = plan.request().settings.iter().map(|s| format!(", {}={}", s.key, shown(&s.value)));
    format!("{} - {}{}", summary.scenario, summary.method, settings.collect::<String>())
}

fn numbers(plan: &SweepPlan, totals: &SweepTotals) -> Table {
    let mut table = Table::new(["", "runs", "median", "p95", "max"]).numbers(1..5);
    for name in plan.columns() {
        if let Some(s) = totals.columns.get(name) {
            let count = s.count.to_string();
            table.row([name.clone(), count, number(s.median), number(s.p95), number(s.max)]);
        }
    }
    table
}

fn cells(plan: &SweepPlan, summary: &SweepSummary) -> Table {
    let axes = &plan.request().axes;
    let columns: Vec<&str> = GRID_COLUMNS.into_iter().filter(|c| plan.columns().iter().any(|p| p == c)).collect();
    let mut header: Vec<String> = axes.iter().map(|axis| axis.key.replace('.', ".\n")).collect();
    header.extend(["runs", "failures"].map(str::to_owned));
    header.extend(columns.iter().map(|c| format!("{c}\nmedian (p95, max)")));
    let numbers = axes.len()..header.len();
    let mut table = Table::new(header).numbers(numbers);
    for (index, cell) in summary.cells.iter().enumerate() {
        let mut row: Vec<String> = plan.cell_values(index).iter().map(shown).collect();
        row.extend([cell.totals.runs, cell.totals.failures.total].map(|n| n.to_string()));
        row.extend(columns.iter().map(|c| cell.totals.columns.get(*c).map_or("-".into(), spread)));
        table.row(row);
    }
    table
}

/// A single value needs no spread.
fn spread(s: &Statistics) -> String {
    if s.count <= 1 { number(s.median) } else { format!("{} ({}, {})", number(s.median), number(s.p95), number(s.max)) }
}

fn number(value: Option<f64>) -> String {
    value.map_or("-".into(), short)
}

/// Runs and failures in words.
pub(crate) fn sentence(plan: &SweepPlan, totals: &SweepTotals) -> String {
    let failures = &totals.failures;
    if failures.total == 0 {
        return format!("No failure in {} runs.", totals.runs);
    }
    let first: Vec<String> = failures.runs.iter().take(10).map(|&run| named(plan, run)).collect();
    let more = if failures.total > first.len() { ", ..." } else { "" };
    format!(
        "{} of {} runs failed: {} did not complete, {} broke a constraint ({}{more}).",
        failures.total,
        totals.runs,
        failures.not_completed,
        failures.broken,
        first.join(", ")
    )
}

fn named(plan: &SweepPlan, run: usize) -> String {
    plan.seed_of(run).filter(|_| plan.cells() == 1).map_or(format!("run {run}"), |seed| format!("seed {seed}"))
}
