//! Studies of the arm controller: each one command, one figure and one verdict.
//!
//! A study sets up arm, queue and controllers, lets them run, and says in numbers what came out. It draws nothing and writes
//! nothing: a [`Report`] is plain data.
//!
//! ```
//! use slideway_study::{Study, run};
//!
//! let report = run(Study::Interrupts, 1)?;
//! assert!(report.holds, "{}", report.sentence);
//! # Ok::<(), slideway_study::StudyError>(())
//! ```

mod error;
mod interrupts;
mod report;
mod study;
mod welding_cell;

pub use error::StudyError;
pub use report::{Level, NamedNumber, Panel, Report, Role, Scales, Series};
pub use study::{Study, run};
