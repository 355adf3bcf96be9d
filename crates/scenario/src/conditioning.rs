use crate::error::ScenarioError;
use crate::read::conditioning::read_conditioning;
use crate::tables::Expectation;
use crate::tables::conditioning::ConditioningFile;
use crate::text::from_toml;
use slideway_lab::conditioning::ConditioningProblem;
use slideway_verify::VerifyOptions;
use std::path::{Path, PathBuf};

/// The scenario of a path-conditioning study: its text and what the text says.
#[derive(Clone, Debug)]
pub struct ConditioningScenario {
    name: String,
    text: String,
    folder: PathBuf,
    file: ConditioningFile,
}

impl ConditioningScenario {
    /// Parses the text of a scenario.
    ///
    /// # Errors
    ///
    /// Bad TOML, an unknown or missing key, a value of the wrong kind.
    pub fn parse(name: &str, text: &str) -> Result<Self, ScenarioError> {
        let of_file = |file| Self { name: name.to_owned(), text: text.to_owned(), folder: PathBuf::new(), file };
        from_toml(text, |file| of_file(file).problem().err()).map(of_file)
    }

    /// The same scenario with the paths in it relative to the folder of a file; as parsed they are relative to the current
    /// folder.
    #[must_use]
    pub fn in_folder_of(self, file: &Path) -> Self {
        self.in_folder(file.parent().unwrap_or(Path::new("")))
    }

    /// The same scenario with the paths in it relative to a folder.
    pub(crate) fn in_folder(self, folder: &Path) -> Self {
        Self { folder: folder.to_owned(), ..self }
    }

    /// The folder in which files that it names lie.
    pub(crate) fn folder(&self) -> &Path {
        &self.folder
    }

    /// The problem it describes.
    ///
    /// # Errors
    ///
    /// The first value that cannot be used, with its key.
    pub fn problem(&self) -> Result<ConditioningProblem, ScenarioError> {
        read_conditioning(&self.file, &self.folder)
    }

    /// Whether a seed changes anything: of a trap's walk, or of disturbances.
    pub(crate) fn is_random(&self) -> bool {
        self.problem().is_ok_and(|problem| problem.trap.is_some() || problem.disturbances.are_random())
    }

    /// What a campaign of random trials around it is asked to do.
    ///
    /// # Errors
    ///
    /// A greatest disturbance that no scenario may have.
    pub fn verify_options(&self) -> Result<VerifyOptions, ScenarioError> {
        self.file.verify.read()
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

    /// The verdict that it is expected to get.
    #[must_use]
    pub fn expectation(&self) -> Expectation {
        self.file.compare.expect
    }

    /// By how much the mean deviation may exceed the projection's for the verdict, as a fraction.
    #[must_use]
    pub fn tolerance(&self) -> Option<f64> {
        self.file.compare.tolerance.map(|t| t.0)
    }
}
