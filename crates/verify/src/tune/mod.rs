//! Parameters that satisfy the hypotheses with a margin, for a chattering amplitude and a sampling rate that are given.

mod conditioning;
mod document;
mod speed;

use crate::error::VerifyError;
use crate::statement::Statement;
use serde::{Deserialize, Serialize};
use slideway_scenario::AnyScenario;
use std::path::PathBuf;

/// Share by which every hypothesis about the settings is to hold.
pub const MARGIN: f64 = 0.2;

/// What is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct TuneRequest {
    /// Name of the scenario.
    pub name: String,
    /// Its text.
    pub text: String,
    /// Its file, if it has one: files that the scenario names lie beside it.
    pub file: Option<PathBuf>,
    /// The method in place of the scenario's, by name.
    pub method: Option<String>,
    /// Greatest chattering amplitude: of the desired joint speeds as a share of their limits, or of `φ` in m.
    pub chattering: f64,
    /// Sampling rate, Hz.
    pub rate: f64,
}

/// A value of the scenario that is replaced.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Change {
    /// Its key.
    pub key: String,
    /// As it stands in the scenario.
    pub before: String,
    /// As proposed.
    pub after: f64,
    /// Its unit.
    pub unit: String,
}

/// What is predicted, beside what one run of the tuned scenario gave.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Prediction {
    /// Name of the guarantee.
    pub name: String,
    /// In plain words.
    pub text: String,
    /// Least value, if it is bounded from below.
    pub lower: Option<f64>,
    /// Greatest value.
    pub upper: Option<f64>,
    /// In the run.
    pub measured: Option<f64>,
    /// Unit.
    pub unit: String,
}

/// Parameters that do.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tuned {
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

/// Why there are none, and what would do.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Impossible {
    /// What stands against it.
    pub reason: String,
    /// A sampling rate at which the same amplitude can be kept, Hz.
    pub rate: Option<f64>,
    /// An amplitude that can be kept at the same rate.
    pub chattering: Option<f64>,
}

/// What came of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TuneOutcome {
    /// Parameters that do.
    Tuned(Box<Tuned>),
    /// There are none.
    Impossible(Impossible),
}

/// Proposes parameters for a scenario of either kind.
///
/// # Errors
///
/// A scenario that cannot be used, numbers that are not positive, or a method that nothing is claimed about.
pub fn tune(request: &TuneRequest) -> Result<TuneOutcome, VerifyError> {
    for (what, value) in [("chattering", request.chattering), ("rate", request.rate)] {
        if !(value > 0.0 && value.is_finite()) {
            return Err(VerifyError::NotPositive { what, value });
        }
    }
    match AnyScenario::parse(&request.name, &request.text)? {
        AnyScenario::Speed(_) => speed::tune(request),
        AnyScenario::Conditioning(_) => conditioning::tune(request),
    }
}

/// What a statement predicts, by the names of its guarantees.
fn predictions(statement: &Statement) -> Vec<Prediction> {
    let shown = |g: &crate::statement::Guarantee| Prediction {
        name: g.name.clone(),
        text: g.text.clone(),
        lower: g.lower,
        upper: g.upper,
        measured: g.measured,
        unit: g.unit.clone(),
    };
    statement.guarantees.iter().map(shown).collect()
}

/// What no number would mend where a number of the run is none.
fn without_number(what: &str) -> Impossible {
    let reason = format!(
        "the run of the scenario gives no finite {what} to go by: at a corner the joints' direction jumps, and at a singularity the limits leave \
         no rate. Round corners (`blend` above 0), or lead the path around the singularity"
    );
    Impossible { reason, rate: None, chattering: None }
}

/// Greatest value that a statement guarantees of a quantity; infinite if it guarantees none.
fn bound(statement: &Statement, name: &str) -> f64 {
    let found = statement.guarantees.iter().find(|g| g.name == name);
    found.and_then(|g| g.upper).unwrap_or(f64::INFINITY)
}
