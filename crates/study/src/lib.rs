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

mod bench;
mod cartesian_2r;
mod error;
mod high_gain_pid;
mod impedance_wall;
mod interrupts;
mod opspace_vs_queue;
mod profiles_vs_gravity;
mod report;
mod study;
mod welding_cell;

pub use error::StudyError;
pub use report::{Level, NamedNumber, Panel, Report, Role, Scales, Series};
pub use study::{Study, run};
