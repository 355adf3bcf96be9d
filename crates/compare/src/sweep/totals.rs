use super::row::SweepRow;
use super::statistics::Statistics;
use serde::Serialize;
use std::collections::BTreeMap;

/// Totals of some runs of a sweep.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SweepTotals {
    /// Number of runs.
    pub runs: usize,
    /// Runs among them that failed.
    pub failures: Failures,
    /// Median, 95th percentile and maximum of every column of the rows.
    pub columns: BTreeMap<String, Statistics>,
}

/// Runs that did not complete or broke a constraint.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Failures {
    /// Number of runs that failed; a run that did both counts once.
    pub total: usize,
    /// Runs whose reference did not reach its end.
    pub not_completed: usize,
    /// Runs in which some `σ_i <= 0` did not hold.
    pub broken: usize,
    /// Their numbers.
    pub runs: Vec<usize>,
}

impl SweepTotals {
    /// Of rows with these columns.
    #[must_use]
    pub fn new(columns: &[String], rows: &[SweepRow]) -> Self {
        let values = |i: usize| rows.iter().filter_map(move |row| row.values.get(i).copied().flatten());
        let column = |(i, name): (usize, &String)| (name.clone(), Statistics::new(values(i)));
        Self {
            runs: rows.len(),
            failures: Failures {
                total: rows.iter().filter(|row| row.failed()).count(),
                not_completed: rows.iter().filter(|row| !row.completed).count(),
                broken: rows.iter().filter(|row| row.broken > 0).count(),
                runs: rows.iter().filter(|row| row.failed()).map(|row| row.run).collect(),
            },
            columns: columns.iter().enumerate().map(column).collect(),
        }
    }
}
