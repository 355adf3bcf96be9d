use slideway_baselines::time_optimal::OptimumError;
use slideway_motion::MotionError;
use thiserror::Error;

/// Reason why a study could not be run to its end.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum StudyError {
    /// A motion was refused, or broke off.
    #[error("the motion of the study: {0}")]
    Motion(#[from] MotionError),
    /// There is no optimum to compare with.
    #[error("the optimum of the study: {0}")]
    Optimum(#[from] OptimumError),
    /// The simulation did not come to its end.
    #[error("{what} did not end within {seconds} s")]
    Endless {
        /// Motion that should have ended.
        what: &'static str,
        /// Simulated time within which it should have ended, s.
        seconds: f64,
    },
}

impl StudyError {
    /// Remedy, in one sentence.
    #[must_use]
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Motion(error) => error.remedy(),
            Self::Optimum(_) | Self::Endless { .. } => "this is a fault of the study: its settings are built in",
        }
    }
}
