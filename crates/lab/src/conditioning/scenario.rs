use super::problem::ConditioningProblem;
use super::schema::ConditioningFile;
use crate::error::LabError;

/// The scenario of a path-conditioning study: its text and what the text says.
#[derive(Clone, Debug)]
pub struct ConditioningScenario {
    name: String,
    text: String,
    file: ConditioningFile,
}

impl ConditioningScenario {
    /// Parses the text of a scenario.
    ///
    /// # Errors
    ///
    /// Bad TOML, an unknown or missing key, a value of the wrong kind.
    pub fn parse(name: &str, text: &str) -> Result<Self, LabError> {
        let file = toml::from_str(text)
            .map_err(|error| LabError::Syntax { message: error.message().to_owned(), span: error.span() })?;
        Ok(Self { name: name.to_owned(), text: text.to_owned(), file })
    }

    /// The problem it describes.
    ///
    /// # Errors
    ///
    /// The first value that cannot be used, with its key.
    pub fn problem(&self) -> Result<ConditioningProblem, LabError> {
        ConditioningProblem::new(&self.file)
    }

    /// Name on the command line, or the stem of the file.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// One sentence on what it is for.
    #[must_use]
    pub fn description(&self) -> &str {
        &self.file.description
    }

    /// The text it was parsed from.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// By how much the mean deviation may exceed the projection's for the verdict, as a fraction.
    #[must_use]
    pub fn tolerance(&self) -> Option<f64> {
        self.file.compare.tolerance.map(|t| t.0)
    }
}
