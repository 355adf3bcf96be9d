//! Statements of what the claims guarantee for one problem, and random trials around it that check them.
//!
//! A [`Statement`] is what is said before anything runs: hypotheses with their margins, and the bounds that follow from those
//! that hold. A [`Campaign`] is a numbered list of trials, each the problem under disturbances of its own; what a trial yields
//! depends on the campaign and the number alone. A trial that keeps the hypotheses and exceeds a bound is a violation.

mod campaign;
mod error;
pub mod number;
mod options;
mod statement;
mod trial;
mod tune;

pub use campaign::{Campaign, CampaignRequest};
pub use error::VerifyError;
pub use options::VerifyOptions;
pub use statement::{Guarantee, Hypothesis, Observed, Observer, Reading, Relation, Statement};
pub use trial::disturbances::TrialDisturbances;
pub use trial::{Check, Trial};
pub use tune::{
    Impossible, MARGIN, Prediction, ProposedValue, TuneOutcome, TuneRequest, Tuned, tune_conditioning, tune_speed,
};
