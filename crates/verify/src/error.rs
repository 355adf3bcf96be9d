use slideway_baselines::time_optimal::OptimumError;
use slideway_path::ProblemError;
use slideway_scenario::ScenarioError;

/// Why a scenario cannot be verified.
#[derive(Debug, thiserror::Error)]
pub enum VerifyError {
    /// The scenario cannot be used.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    /// The path has no optimum.
    #[error(transparent)]
    Optimum(#[from] OptimumError),
    /// The speed limits exclude standing still.
    #[error("the joint-speed limits have to lie on both sides of zero")]
    NoLimits,
    /// A method that there is not, or that is no form of what is verified.
    #[error("there is no method `{name}`; there are {}", known.join(", "))]
    UnknownMethod {
        /// What was asked for.
        name: String,
        /// What there is.
        known: Vec<&'static str>,
    },
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
        /// What was given.
        value: f64,
    },
    /// A key that the scenario does not have.
    #[error("the scenario has no `{key}` to change")]
    NoKey {
        /// The key.
        key: String,
    },
    /// A trial beyond the campaign's last.
    #[error("there is no trial {number}: the campaign has {trials}")]
    NoTrial {
        /// What was asked for.
        number: u64,
        /// How many there are, counted from 0.
        trials: u64,
    },
}

impl From<ProblemError> for VerifyError {
    fn from(error: ProblemError) -> Self {
        Self::Scenario(error.into())
    }
}

impl VerifyError {
    pub(crate) fn unknown_method(name: &str, known: Vec<&'static str>) -> Self {
        Self::UnknownMethod { name: name.to_owned(), known }
    }
}
