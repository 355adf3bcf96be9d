use crate::error::VerifyError;
use crate::statement::Statement;
use crate::trial::Trial;
use std::path::PathBuf;

/// What a campaign is asked to do. Everything that a trial depends on.
#[derive(Clone, Debug, PartialEq)]
pub struct CampaignRequest {
    /// Name of the scenario.
    pub name: String,
    /// Its text.
    pub text: String,
    /// Its file, if it has one: files that the scenario names lie beside it.
    pub file: Option<PathBuf>,
    /// The method; without one the one that `compare` judges.
    pub method: Option<String>,
    /// Seed of the disturbances.
    pub seed: u64,
    /// How many trials.
    pub trials: u64,
}

/// Numbered trials around a scenario.
#[derive(Clone, Debug)]
pub struct Campaign {
    request: CampaignRequest,
    statement: Statement,
}

impl Campaign {
    /// Reads the scenario, states what is guaranteed, runs no trial.
    ///
    /// # Errors
    ///
    /// A scenario that cannot be used.
    pub fn new(request: CampaignRequest) -> Result<Self, VerifyError> {
        let statement =
            Statement { method: String::new(), hypotheses: Vec::new(), guarantees: Vec::new(), remarks: Vec::new() };
        Ok(Self { request, statement })
    }

    /// What was asked for.
    #[must_use]
    pub fn request(&self) -> &CampaignRequest {
        &self.request
    }

    /// What is known before any trial.
    #[must_use]
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// Makes one trial: a function of the campaign and the number alone.
    ///
    /// # Errors
    ///
    /// A number beyond the last; a scenario that cannot be run under the trial's disturbances.
    pub fn trial(&self, number: u64) -> Result<Trial, VerifyError> {
        if number >= self.request.trials {
            return Err(VerifyError::NoTrial { number, trials: self.request.trials });
        }
        Ok(Trial { number, size: 0.0, disturbances: toml::Table::new(), outside: Vec::new(), checks: Vec::new() })
    }

    /// A failing trial made as small as it can be while it still fails.
    ///
    /// # Errors
    ///
    /// As [`Campaign::trial`].
    pub fn smallest(&self, failing: &Trial) -> Result<Trial, VerifyError> {
        Ok(failing.clone())
    }

    /// A trial as a scenario that `slideway compare` runs.
    ///
    /// # Errors
    ///
    /// The scenario's text cannot carry the table.
    pub fn scenario_of(&self, trial: &Trial) -> Result<String, VerifyError> {
        let _ = trial;
        Ok(self.request.text.clone())
    }
}
