use super::plan::SweepPlan;
use serde::Serialize;
use slideway_compare::sweep::{SweepRow, SweepTotals};
use std::collections::BTreeMap;

/// A finished sweep: totals over all runs and over each cell of the grid.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SweepSummary {
    /// Name of the scenario.
    pub scenario: String,
    /// The method.
    pub method: String,
    /// Seeds per cell; null where the scenario's own was used.
    pub seeds: Option<u64>,
    /// Values replaced in every run, by key.
    pub set: BTreeMap<String, toml::Value>,
    /// Values varied, by key.
    pub grid: BTreeMap<String, Vec<toml::Value>>,
    /// Over all runs.
    pub all: SweepTotals,
    /// Over each cell, in the order of the runs; one without a grid.
    pub cells: Vec<CellSummary>,
}

/// The runs of one cell.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CellSummary {
    /// The cell's values, by key.
    pub grid: BTreeMap<String, toml::Value>,
    /// What its runs come to.
    #[serde(flatten)]
    pub totals: SweepTotals,
}

impl SweepSummary {
    /// Summarises the rows of a plan, all of them, in its order.
    #[must_use]
    pub fn new(plan: &SweepPlan, rows: &[SweepRow]) -> Self {
        let request = plan.request();
        let key_and_value = |cell: usize| {
            let keys = request.axes.iter().map(|axis| axis.key.clone());
            keys.zip(plan.cell_values(cell).iter().cloned()).collect()
        };
        Self {
            scenario: request.name.clone(),
            method: plan.method().to_owned(),
            seeds: request.seeds,
            set: request.settings.iter().map(|s| (s.key.clone(), s.value.clone())).collect(),
            grid: request.axes.iter().map(|a| (a.key.clone(), a.values.clone())).collect(),
            all: SweepTotals::new(plan.columns(), rows),
            cells: rows
                .chunk_by(|a, b| plan.cell_of(a.run) == plan.cell_of(b.run))
                .map(|rows| CellSummary {
                    grid: key_and_value(rows.first().map_or(0, |row| plan.cell_of(row.run))),
                    totals: SweepTotals::new(plan.columns(), rows),
                })
                .collect(),
        }
    }
}
