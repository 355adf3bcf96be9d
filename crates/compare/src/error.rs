use crate::words::short;
use slideway_baselines::time_optimal::OptimumError;
use slideway_path::ProblemError;
use thiserror::Error;

/// Reason why a comparison came to nothing.
#[derive(Debug, Error)]
pub enum CompareError {
    /// A problem or a method that cannot be run.
    #[error(transparent)]
    Lab(#[from] ProblemError),
    /// No optimum to compare with.
    #[error("no optimum: {error}{}", joint.as_ref().map(|joint| format!("; that joint is `{joint}`")).unwrap_or_default())]
    NoOptimum {
        /// Why.
        error: OptimumError,
        /// Name of the joint whose limit is not kept.
        joint: Option<String>,
        /// For limits that no profile keeps: the share of half their ranges by which all like the one named would have to give
        /// way; `None` if no such share is known.
        widening: Option<f64>,
    },
    /// A number among the options that cannot be used.
    #[error("{option} is {value}")]
    Option {
        /// The option.
        option: &'static str,
        /// Its value.
        value: f64,
        /// Remedy, in a few words.
        remedy: &'static str,
    },
    /// The caller ended it.
    #[error("cancelled")]
    Cancelled,
}

impl CompareError {
    /// Remedy, in a sentence or two.
    #[must_use]
    pub fn remedy(&self) -> String {
        match self {
            Self::Lab(error) => error.remedy(),
            Self::NoOptimum { error: OptimumError::NoMotion { .. }, .. } => {
                "give a path along which the joints move".into()
            }
            Self::NoOptimum { error: OptimumError::Infeasible { .. }, widening, .. } => {
                let share = widening.map(|share| {
                    let share = short(100.0 * share);
                    format!("; if every such limit gave way by {share} % of half its range, there would be a profile")
                });
                "raise the limit named, or change the path or its speed at the ends there".to_owned()
                    + share.as_deref().unwrap_or_default()
            }
            Self::NoOptimum { .. } => "a path that avoids singular configurations can be solved".into(),
            Self::Option { remedy, .. } => (*remedy).into(),
            Self::Cancelled => "let it run to its end".into(),
        }
    }
}

/// Refuses a tolerance that is no fraction of an optimum and an inter-sample share that is no share of a limit.
///
/// # Errors
///
/// A tolerance that is negative or no finite number; a share that is not positive or no finite number.
pub fn check_shares(tolerance: Option<f64>, inter_sample: Option<f64>) -> Result<(), CompareError> {
    let refused = |option, value, remedy| Err(CompareError::Option { option, value, remedy });
    match (tolerance, inter_sample) {
        (Some(value), _) if !(value >= 0.0 && value.is_finite()) => {
            refused("tolerance", value, "give a fraction of the optimum, for example 0.02")
        }
        (_, Some(value)) if !(value > 0.0 && value.is_finite()) => {
            refused("inter-sample", value, "give a share of the limits, for example 1e-6")
        }
        _ => Ok(()),
    }
}

/// Refuses a gap that no bounds come to, and too few cells to seek them with.
///
/// # Errors
///
/// A gap outside `[1e-10, 1]`; fewer than 10 cells.
pub fn check_refinement(gap: Option<f64>, cells: Option<usize>) -> Result<(), CompareError> {
    match (gap, cells) {
        (Some(value), _) if !(1e-10..=1.0).contains(&value) => {
            let remedy = "give a relative gap from 1e-10 to 1, for example 1e-5";
            Err(CompareError::Option { option: "gap", value, remedy })
        }
        (_, Some(cells)) if cells < 10 => {
            Err(CompareError::Option { option: "cells", value: cells as f64, remedy: "give at least 10 cells" })
        }
        _ => Ok(()),
    }
}
