use crate::conditioning::{ConditioningProblem, PathMethod};
use crate::{Experiment, Method};

/// A problem of either kind with the method that a verdict on it is about.
#[derive(Clone, Debug)]
pub enum Subject {
    /// A robot whose speed along a path is regulated.
    Speed {
        /// The traced problem.
        experiment: Box<Experiment>,
        /// The method.
        method: Method,
    },
    /// A reference that is kept inside constraints.
    Conditioning {
        /// The problem.
        problem: Box<ConditioningProblem>,
        /// The method, one of the conditioner's forms.
        method: PathMethod,
    },
}

impl Subject {
    /// Name of the method.
    #[must_use]
    pub fn method(&self) -> &'static str {
        match self {
            Self::Speed { method, .. } => method.name(),
            Self::Conditioning { method, .. } => method.name(),
        }
    }
}
