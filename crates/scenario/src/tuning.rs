//! Tuning of a scenario: the proposal, and the text with its values in it.

use crate::any::AnyScenario;
use crate::conditioning::ConditioningScenario;
use crate::error::ScenarioError;
use crate::speed::Scenario;
use crate::values::{Change, NoKey, replaced};
use serde::{Deserialize, Serialize};
use slideway_lab::Experiment;
use slideway_lab::conditioning::ConditioningProblem;
use slideway_verify::{
    Impossible, Prediction, ProposedValue, Statement, TuneOutcome, TuneRequest, VerifyError, tune_conditioning,
    tune_speed,
};
use thiserror::Error;

/// Parameters that do, in a scenario.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TunedScenario {
    /// What is replaced; values that stay as they are are not here.
    pub changes: Vec<Change>,
    /// The trade-off that was made, in words.
    pub trade_off: Vec<String>,
    /// What the tuned scenario guarantees, and what it gave.
    pub predictions: Vec<Prediction>,
    /// The statement of the tuned scenario.
    pub statement: Statement,
    /// The scenario's text with the values replaced; comments and order stay.
    pub text: String,
}

/// What came of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Tuning {
    /// Parameters that do.
    Tuned(Box<TunedScenario>),
    /// There are none.
    Impossible(Impossible),
}

/// Why a scenario cannot be tuned.
#[derive(Debug, Error)]
pub enum TuningError {
    /// The scenario cannot be used.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    /// Nothing can be proposed for what it describes.
    #[error(transparent)]
    Verify(#[from] VerifyError),
    /// A key that the scenario does not have.
    #[error(transparent)]
    NoKey(#[from] NoKey),
}

impl AnyScenario {
    /// Proposes parameters for a method, by name; without one for the one that a comparison judges.
    ///
    /// # Errors
    ///
    /// A scenario that cannot be used, numbers that are not positive, or a method that nothing is claimed about.
    pub fn tuned(&self, method: Option<&str>, request: TuneRequest) -> Result<Tuning, TuningError> {
        let outcome = match self {
            Self::Speed(scenario) => {
                let (experiment, method) = scenario.judged(method)?;
                let with = |values: &[ProposedValue]| -> Result<Experiment, TuningError> {
                    let (text, _) = replaced(scenario.text(), values)?;
                    Ok(Scenario::parse(scenario.name(), &text)?.in_folder(scenario.folder()).experiment()?)
                };
                tune_speed(experiment, method, scenario.grid_points(), request, with)?
            }
            Self::Conditioning(scenario) => {
                let (problem, method) = scenario.judged(method)?;
                let with = |values: &[ProposedValue]| -> Result<ConditioningProblem, TuningError> {
                    let (text, _) = replaced(scenario.text(), values)?;
                    let changed = ConditioningScenario::parse(scenario.name(), &text)?;
                    Ok(changed.in_folder(scenario.folder()).problem()?)
                };
                tune_conditioning(&problem, method, request, with)?
            }
        };
        Ok(match outcome {
            TuneOutcome::Impossible(why) => Tuning::Impossible(why),
            TuneOutcome::Tuned(tuned) => {
                let (text, changes) = replaced(self.text(), &tuned.values)?;
                let (trade_off, predictions, statement) = (tuned.trade_off, tuned.predictions, tuned.statement);
                Tuning::Tuned(Box::new(TunedScenario { changes, trade_off, predictions, statement, text }))
            }
        })
    }
}
