//! Parameters that satisfy the hypotheses with a margin, for a chattering amplitude and a sampling rate that are given.

mod conditioning;
mod speed;

pub use conditioning::tune_conditioning;
pub use speed::tune_speed;

use crate::error::VerifyError;
use crate::statement::Statement;
use serde::{Deserialize, Serialize};

/// Share by which every hypothesis about the settings is to hold.
pub const MARGIN: f64 = 0.2;

/// A tuning as it is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TuneRequest {
    /// Greatest chattering amplitude: of the desired joint speeds as a share of their limits, or of `φ` in m.
    pub chattering: f64,
    /// Sampling rate, Hz.
    pub rate: f64,
}

/// A value that is proposed for a key of the scenario.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProposedValue {
    /// The key, dotted.
    pub key: &'static str,
    /// The value.
    pub value: f64,
    /// Its unit.
    pub unit: &'static str,
}

/// A predicted guarantee, beside the value in one run of the tuned scenario.
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
#[derive(Clone, Debug, PartialEq)]
pub struct Tuned {
    /// The values, those that stay as they are among them.
    pub values: Vec<ProposedValue>,
    /// The trade-off that was made, in words.
    pub trade_off: Vec<String>,
    /// Guarantees of the tuned problem, beside the values in its run.
    pub predictions: Vec<Prediction>,
    /// The statement of the tuned problem.
    pub statement: Statement,
}

/// Reason why no parameters satisfy a request, and values that could be kept instead.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Impossible {
    /// Reason, in words.
    pub reason: String,
    /// A sampling rate at which the same amplitude can be kept, Hz.
    pub rate: Option<f64>,
    /// An amplitude that can be kept at the same rate.
    pub chattering: Option<f64>,
}

/// Outcome of a tuning.
#[derive(Clone, Debug, PartialEq)]
pub enum TuneOutcome {
    /// Parameters that do.
    Tuned(Box<Tuned>),
    /// There are none.
    Impossible(Impossible),
}

impl TuneRequest {
    fn check(&self) -> Result<(), VerifyError> {
        for (what, value) in [("chattering", self.chattering), ("rate", self.rate)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(VerifyError::NotPositive { what, value });
            }
        }
        Ok(())
    }
}

/// Predictions of a statement, by the names of its guarantees.
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
