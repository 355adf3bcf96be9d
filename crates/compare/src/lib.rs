#![doc = include_str!("../README.md")]

mod conditioning;
mod error;
mod progress;
mod speed;
mod words;

pub use conditioning::convergence::Convergence;
pub use conditioning::summary::{ConditioningSummary, ConditioningVerdict, ProjectionEntry};
pub use conditioning::{ConditioningComparison, ConditioningOptions, compare_conditioning};
pub use error::{CompareError, check_shares};
pub use progress::{Progress, Stage, Watch, unwatched};
pub use speed::entries::{BetweenNodes, ExcessEntry, MethodEntry, OptimumEntry};
pub use speed::laws::{Law, LawCourse, LawModelError, MASS_ERROR, MethodSpeed, ModelErrorEntry, ScaledLimits};
pub use speed::summary::SpeedSummary;
pub use speed::verdict::SpeedVerdict;
pub use speed::windows::WindowEntry;
pub use speed::{SpeedComparison, SpeedOptions, compare_speed};
pub use words::short;
