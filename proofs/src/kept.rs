//! Cases written down: what an attack found, or the closest case of a claim, in a file that gives it again.

use std::path::Path;

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::CLAIMS;
use crate::claim::Claim;
use crate::engine::{Choices, Engine, Found, Stop};
use crate::subject::Subject;

/// A case of a property, as JSON.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct KeptCase {
    /// The claim.
    pub claim: String,
    /// Its engine.
    pub property: String,
    /// The margin when it was written down; `None` where nothing is measured or the code refused.
    pub margin: Option<f64>,
    /// The numbers in [0, 1) it is built from.
    pub choices: Vec<f64>,
}

/// A case that cannot be replayed.
#[derive(Debug, Error)]
pub enum KeptError {
    /// No such file, or it cannot be read.
    #[error("the file cannot be read: {0}")]
    Read(std::io::Error),
    /// No JSON, or fields that a case does not have.
    #[error("the file is no case: {0}")]
    Text(serde_json::Error),
    /// There is no claim of that name, or it has no such property.
    #[error("there is no property `{property}` of a claim `{claim}`")]
    Unknown {
        /// The claim asked for.
        claim: String,
        /// The engine asked for.
        property: String,
    },
    /// A choice outside [0, 1).
    #[error("choice {index} is {value}; choices are in [0, 1)")]
    Choice {
        /// Counted from 0.
        index: usize,
        /// Value that was given.
        value: f64,
    },
}

impl KeptError {
    /// Remedy, in one sentence.
    #[must_use]
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Read(_) => "give the path of a file that `slideway attack --out DIR` has written",
            Self::Text(_) => "write the case anew with `slideway attack --out DIR`",
            Self::Unknown { .. } => "`slideway claims --json` shows the claims and their properties",
            Self::Choice { .. } => "bring it inside, or write the case anew with `slideway attack --out DIR`",
        }
    }
}

/// A case that was run once more.
#[derive(Clone, Debug)]
pub struct Replayed {
    /// The claim.
    pub claim: &'static Claim,
    /// Its engine.
    pub engine: &'static Engine,
    /// The choices that were asked for: those given, and more from a fixed random sequence if they were too few.
    pub used: Vec<f64>,
    /// The margin, or why there is none.
    pub outcome: Result<f64, Stop>,
}

impl Replayed {
    /// Runs a case on the shipped code.
    #[must_use]
    pub fn run(claim: &'static Claim, engine: &'static Engine, mut choices: Choices) -> Self {
        let outcome = (engine.trial)(&mut choices, Subject::Shipped);
        Self { claim, engine, used: choices.used().to_vec(), outcome }
    }
}

impl KeptCase {
    /// The case that an attack found.
    #[must_use]
    pub fn found(claim: &Claim, engine: &Engine, found: &Found) -> Self {
        Self {
            claim: claim.name.to_owned(),
            property: engine.name.to_owned(),
            margin: found.margin.is_finite().then_some(found.margin),
            choices: found.choices.clone(),
        }
    }

    /// Reads a case that was written down.
    ///
    /// # Errors
    ///
    /// [`KeptError::Read`], [`KeptError::Text`] or [`KeptError::Choice`].
    pub fn read(path: &Path) -> Result<Self, KeptError> {
        let text = std::fs::read_to_string(path).map_err(KeptError::Read)?;
        let case: Self = serde_json::from_str(&text).map_err(KeptError::Text)?;
        match case.choices.iter().position(|choice| !(0.0..1.0).contains(choice)) {
            Some(index) => Err(KeptError::Choice { index, value: case.choices[index] }),
            None => Ok(case),
        }
    }

    /// The name of its file.
    #[must_use]
    pub fn file_name(&self) -> String {
        format!("{}-{}.json", self.claim, self.property)
    }

    /// Runs it once more on the shipped code.
    ///
    /// # Errors
    ///
    /// [`KeptError::Unknown`].
    pub fn replay(&self) -> Result<Replayed, KeptError> {
        let claim = CLAIMS.iter().find(|claim| claim.name == self.claim);
        let engine = claim.and_then(|claim| claim.engines.iter().find(|engine| engine.name == self.property));
        let unknown = || KeptError::Unknown { claim: self.claim.clone(), property: self.property.clone() };
        let (claim, engine) = claim.zip(engine).ok_or_else(unknown)?;
        Ok(Replayed::run(claim, engine, Choices::replay(&self.choices)))
    }
}
