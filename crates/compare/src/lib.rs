#![doc = include_str!("../README.md")]

mod conditioning;
mod error;
mod progress;
pub mod rivals;
mod speed;
pub mod sweep;
mod words;

pub use conditioning::arrival::Arrival;
pub use conditioning::convergence::Convergence;
pub use conditioning::summary::{ConditioningSummary, ConditioningVerdict, PathMethodEntry, ProjectionEntry};
pub use conditioning::{ConditioningComparison, ConditioningOptions, compare_conditioning};
pub use error::{CompareError, check_refinement, check_shares};
pub use progress::{Progress, Stage, Watch, unwatched};
pub use speed::entries::{ExcessEntry, MethodEntry, OptimumEntry};
pub use speed::laws::{Law, LawCourse, LawModelError, MASS_ERROR, MethodSpeed, ModelErrorEntry, ScaledLimits};
pub use speed::motion::{OptimumMotion, OptimumSample};
pub use speed::on_grid::{BetweenNodes, GridEntry};
pub use speed::summary::{LeftOut, SpeedSummary};
pub use speed::verdict::{SpeedVerdict, VerdictStatus};
pub use speed::whole::{CertifiedFor, ProfileSample, WholeOptimum, WorstCell};
pub use speed::windows::WindowEntry;
pub use speed::{SpeedComparison, SpeedOptions, compare_speed};
pub use words::{apart, apart_in, decimals, fixed, short};
