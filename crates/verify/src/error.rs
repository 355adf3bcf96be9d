use slideway_baselines::time_optimal::OptimumError;
use slideway_path::ProblemError;

/// Reason why a problem cannot be verified or tuned.
#[derive(Debug, thiserror::Error)]
pub enum VerifyError {
    /// The problem cannot be used.
    #[error(transparent)]
    Problem(#[from] ProblemError),
    /// The path has no optimum.
    #[error(transparent)]
    Optimum(#[from] OptimumError),
    /// The speed limits exclude standing still.
    #[error("the joint-speed limits have to lie on both sides of zero")]
    NoLimits,
    /// A method that nothing is claimed about.
    #[error("nothing is claimed about the method `{method}`: choose one of the conditioner's forms")]
    NoClaims {
        /// The method.
        method: String,
    },
    /// A number that has to be positive and finite.
    #[error("{what} is {value}; it has to be positive and finite")]
    NotPositive {
        /// Which.
        what: &'static str,
        /// Value that was given.
        value: f64,
    },
    /// A trial beyond the campaign's last.
    #[error("there is no trial {number}: the campaign has {trials}")]
    NoTrial {
        /// Number that was asked for, from 0.
        number: u64,
        /// Number of trials, counted from 0.
        trials: u64,
    },
}
