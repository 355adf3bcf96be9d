use serde::{Deserialize, Serialize};

/// Row of one run of a sweep.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SweepRow {
    /// Number of the run in the plan, from 0.
    pub run: usize,
    /// True if the reference reached its end.
    pub completed: bool,
    /// Constraints that were broken: `σ_i <= 0` did not hold at every sample. Always 0 for speed scenarios.
    pub broken: usize,
    /// One value per column of the plan; null where a run has none, such as the escape time of a run without a trap.
    pub values: Vec<Option<f64>>,
}

impl SweepRow {
    /// True if the run did not complete or broke a constraint.
    #[must_use]
    pub fn failed(&self) -> bool {
        !self.completed || self.broken > 0
    }
}
