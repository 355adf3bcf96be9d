//! Path conditioning: a reference, constraints, and every method that bends the one around the other.

mod constraint;
mod disturbances;
mod expression;
mod metrics;
mod problem;
mod run;
mod trace;

pub use constraint::{Carrier, NamedConstraint, POLYTOPE_FACES, Shape3};
pub use disturbances::PathDisturbances;
pub use expression::ExpressionConstraint;
pub use metrics::{Contact, ContactSummary, PathChattering, PathMethodSummary, distances};
pub use problem::{ConditioningProblem, MarginChoice, Reference};
pub use run::{CLOCK_ROUNDING, check_conditioner, run_and_settle, run_conditioner};
pub use trace::{ConditionedSample, ConditionedTrace, MAX_CONSTRAINTS, PathMethod, Phase};
