//! Comparisons as values: every method run on one problem, beside the best that any method could do, with a verdict.
//!
//! [`compare_speed`] runs every speed law on a path and puts it beside the certified time optimum; [`compare_conditioning`] runs
//! every path conditioner on a reference and puts it beside the projection, the nearest allowed point at each instant. Both take
//! values and return values: they read no file, write none, print nothing and know no terminal. A caller sees how far a comparison
//! has come through a function of [`Progress`], which may end it.
//!
//! ```
//! use slideway_compare::{SpeedOptions, compare_speed, unwatched};
//! use slideway_scenario::Scenario;
//!
//! let scenario = Scenario::parse(
//!     "mine",
//!     "limits.speed = 1
//!      control = { gain = 10, sampling_period = 1e-3, bandwidth = 10, target_rate = 5 }
//!      path.joints.line = { from = [0], to = [1] }
//!      robot.dh = [{ a = 0.5, alpha = 0, d = 0 }]",
//! )?;
//! let experiment = scenario.experiment()?;
//! let options = SpeedOptions { grid_points: 100, ..SpeedOptions::named("one joint") };
//! let comparison = compare_speed(&experiment, &options, &mut unwatched)?;
//! assert!(comparison.summary.optimum.certified);
//! println!("{}", comparison.summary.verdict.sentence);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod conditioning;
mod error;
mod progress;
mod speed;
mod words;

pub use conditioning::convergence::Convergence;
pub use conditioning::summary::{ConditioningSummary, ConditioningVerdict, ProjectionEntry};
pub use conditioning::{ConditioningComparison, ConditioningOptions, compare_conditioning};
pub use error::{CompareError, check_refinement, check_shares};
pub use progress::{Progress, Stage, Watch, unwatched};
pub use speed::entries::{MethodEntry, OptimumEntry};
pub use speed::laws::{Law, LawCourse, LawModelError, MASS_ERROR, MethodSpeed, ModelErrorEntry, ScaledLimits};
pub use speed::motion::{OptimumMotion, OptimumSample};
pub use speed::on_grid::{BetweenNodes, GridEntry};
pub use speed::summary::SpeedSummary;
pub use speed::verdict::{SpeedVerdict, VerdictStatus};
pub use speed::whole::{CertifiedFor, ProfileSample, WholeOptimum, WorstCell};
pub use speed::windows::WindowEntry;
pub use speed::{SpeedComparison, SpeedOptions, compare_speed};
pub use words::short;
