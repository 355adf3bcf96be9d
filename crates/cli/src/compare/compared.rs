use serde::Serialize;
use slideway_baselines::time_optimal::Solver;
use slideway_compare::CertifiedFor;

/// What the command line says about a comparison.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct CompareOptions {
    /// Instead of the scenario's tolerance.
    pub(crate) tolerance: Option<f64>,
    /// Keep the optimum's limits between grid points too, to this share of each.
    pub(crate) inter_sample: Option<f64>,
    /// Instead of the scenario's gap, cells and solver of the optimum.
    pub(crate) gap: Option<f64>,
    pub(crate) cells: Option<usize>,
    pub(crate) solver: Option<Solver>,
}

/// A comparison that was run and written.
pub(crate) struct Compared {
    /// Whether its verdict holds.
    pub(crate) holds: bool,
    /// The verdict in words.
    pub(crate) sentence: String,
    /// What the gallery's table shows.
    pub(crate) key: KeyFigures,
    /// What `summary.json` holds.
    pub(crate) summary: serde_json::Value,
    /// The same for a terminal.
    pub(crate) table: String,
}

/// The few numbers by which comparisons are put side by side.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub(crate) struct KeyFigures {
    /// Certified optimum, s; null for conditioning.
    pub(crate) optimum_s: Option<f64>,
    /// Gap of its certificate.
    pub(crate) gap: Option<f64>,
    /// What its bounds hold for.
    pub(crate) certified_for: Option<CertifiedFor>,
    /// Judged method over the optimum: travel time, or mean deviation over the projection's.
    pub(crate) ratio: Option<f64>,
}
