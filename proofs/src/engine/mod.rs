//! Property tests as functions: one case in, its margin out. The tests, `slideway claims` and `slideway attack` run the same ones.

mod attack;
mod campaign;
mod choices;

pub use attack::{Attack, Found};
pub use campaign::{Report, Violation, campaign};
pub use choices::Choices;

use crate::subject::Subject;

/// Code that an engine puts to the test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// The explicit speed regulator, as [`Subject`] presents it: broken ones can take its place.
    SpeedRegulator,
    /// Other shipped code, or a recurrence.
    Other,
}

/// Cost of one case, in rough terms: it decides how many cases are tried where time is short.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cost {
    /// Microseconds.
    Sample,
    /// A whole run or a conic program: a fraction of a millisecond.
    Run,
    /// A motion of an arm, planned and followed: a millisecond.
    Motion,
}

/// The property test of a claim.
#[derive(Clone, Copy, Debug)]
pub struct Engine {
    /// Property that holds, as the name of a test.
    pub name: &'static str,
    /// In what the margin is counted.
    pub unit: &'static str,
    /// Code that is tested.
    pub about: About,
    /// Cost of a case.
    pub cost: Cost,
    /// Builds a case that meets the hypotheses and gives its margin: the bound, its slack for rounding included, less what was
    /// measured. Negative or NaN: the claim is violated. Infinite: held, and nothing was measured (claims that hold to the last bit).
    pub trial: fn(&mut Choices, Subject) -> Result<f64, Stop>,
}

impl Engine {
    /// Description of how a case violates the claim; `None` if it does not.
    #[must_use]
    pub fn violation(&self, choices: &mut Choices, subject: Subject) -> Option<String> {
        match (self.trial)(choices, subject) {
            Ok(margin) if margin >= 0.0 => None,
            Ok(margin) => Some(format!("margin {margin:e} ({})", self.unit)),
            Err(Stop::Skipped) => None,
            Err(Stop::Refused(why)) => Some(why),
        }
    }
}

/// Reason why a case has no margin.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stop {
    /// It does not meet the hypotheses, and does not count.
    Skipped,
    /// The code refused what meets the hypotheses. Counts as a violation.
    Refused(String),
}

impl From<slideway_conditioner::ParameterError> for Stop {
    fn from(error: slideway_conditioner::ParameterError) -> Self {
        Self::Refused(error.to_string())
    }
}

impl From<slideway_motion::MotionError> for Stop {
    fn from(error: slideway_motion::MotionError) -> Self {
        Self::Refused(error.to_string())
    }
}

impl From<slideway_robot::RobotError> for Stop {
    fn from(error: slideway_robot::RobotError) -> Self {
        Self::Refused(error.to_string())
    }
}

impl From<slideway_robot::DynamicsError> for Stop {
    fn from(error: slideway_robot::DynamicsError) -> Self {
        Self::Refused(error.to_string())
    }
}

/// Margin of a claim that either holds or does not.
#[must_use]
pub fn exactly(holds: bool) -> f64 {
    if holds { f64::INFINITY } else { -1.0 }
}

/// The smaller margin; NaN counts as violated.
#[must_use]
pub fn worse(one: f64, other: f64) -> f64 {
    if one.is_nan() || other.is_nan() { f64::NEG_INFINITY } else { one.min(other) }
}
