//! What the claims guarantee for one scenario, and random trials around it that check it.
//!
//! A [`Statement`] is what is said before anything runs: hypotheses with their margins, and the bounds that follow from those
//! that hold. A [`Campaign`] is a numbered list of trials, each the scenario under disturbances of its own; what a trial yields
//! depends on the campaign and the number alone. A trial that keeps the hypotheses and exceeds a bound is a violation.

mod campaign;
mod error;
pub mod number;
mod statement;
mod trial;
mod tune;

pub use campaign::{Campaign, CampaignRequest, verify_options};
pub use error::VerifyError;
pub use statement::{Guarantee, Hypothesis, Observed, Observer, Reading, Relation, Statement};
pub use trial::{Check, Trial};
pub use tune::{Change, Impossible, MARGIN, Prediction, TuneOutcome, TuneRequest, Tuned, tune};
