//! Plans of many runs of one scenario: over the seeds of its random walk, over a grid of parameters, or both. [`slideway_compare::sweep`] makes
//! the runs.
//!
//! A [`SweepPlan`] numbers its runs; what a run yields depends on the plan and the number alone, so any number of threads
//! and any number of interruptions give the same rows.
//!
//! ```
//! use slideway_scenario::sweep::{Axis, SweepPlan, SweepRequest};
//!
//! let axes = vec![Axis::parse("control.bandwidth=5,10")?];
//! let text = slideway_scenario::BUILT_IN[0].text.to_owned();
//! let plan = SweepPlan::new(SweepRequest { axes, ..SweepRequest::of("puma-helix", text) })?;
//! assert_eq!(plan.runs(), 2);
//! # Ok::<(), slideway_scenario::sweep::SweepError>(())
//! ```

mod cell;
mod error;
mod plan;
mod request;
mod setting;
mod summary;

pub use error::SweepError;
pub use plan::{MAX_RUNS, SweepPlan};
pub use request::SweepRequest;
pub use setting::{Axis, Setting, shown};
pub use summary::{CellSummary, SweepSummary};
