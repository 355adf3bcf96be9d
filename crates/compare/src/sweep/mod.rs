//! Many runs, each told in a row of numbers: over seeds, over a grid of parameters, or both.
//!
//! The row of a run depends on its subject, its seed and nothing else, so any number of threads and any number of
//! interruptions give the same rows.

mod columns;
mod row;
mod run;
mod statistics;
mod totals;

pub use columns::{conditioning_columns, speed_columns};
pub use row::SweepRow;
pub use run::{RowSink, SweepRun, run_sweep};
pub use statistics::{Statistics, quantile};
pub use totals::{Failures, SweepTotals};
