//! Scenario files: tables of TOML and way-points of CSV, read into problems, with the key of what is wrong and what to do about it.
//!
//! ```
//! use slideway_lab::Method;
//! use slideway_scenario::Scenario;
//!
//! let scenario = Scenario::built_in("puma-helix-on-path").expect("built in")?;
//! let trace = scenario.experiment()?.run(Method::SlidingModeImplicit)?;
//! assert!(trace.finish_s.is_some());
//! # Ok::<(), slideway_scenario::ScenarioError>(())
//! ```

mod any;
mod built_in;
mod conditioning;
mod encoding;
mod error;
mod read;
mod schema;
mod speed;
mod subject;
pub mod sweep;
mod syntax;
mod tables;
mod text;
mod trial;
mod tuning;
mod values;

pub use any::AnyScenario;
pub use built_in::{BUILT_IN, BuiltIn, CONDITIONING_TEMPLATE, TEMPLATE};
pub use conditioning::ConditioningScenario;
pub use encoding::Encoding;
pub use error::ScenarioError;
pub use read::number_table::{NumberTable, Separator, TableError};
pub use read::robot::robot_in;
pub use speed::Scenario;
pub use tables::{Expectation, SolverName};
pub use text::locate;
pub use tuning::{TunedScenario, Tuning, TuningError};
pub use values::{Change, NoKey};
