use crate::built_in::BUILT_IN;
use crate::conditioning::ConditioningScenario;
use crate::error::ScenarioError;
use crate::speed::Scenario;
use crate::tables::Expectation;
use slideway_verify::VerifyOptions;
use std::path::Path;
use toml::de::DeTable;

/// A scenario of either kind. This is the one place that asks which kind a text is.
#[derive(Clone, Debug)]
pub enum AnyScenario {
    /// A robot whose speed along a path is regulated.
    Speed(Box<Scenario>),
    /// A reference that is kept inside constraints.
    Conditioning(Box<ConditioningScenario>),
}

impl AnyScenario {
    /// A built-in scenario, if there is one of that name.
    #[must_use]
    pub fn built_in(name: &str) -> Option<Result<Self, ScenarioError>> {
        BUILT_IN.iter().find(|b| b.name == name).map(|b| Self::parse(b.name, b.text))
    }

    /// Reads a scenario file; its name is the file's stem.
    ///
    /// # Errors
    ///
    /// The file cannot be read, or what [`AnyScenario::parse`] refuses.
    pub fn read(path: &Path) -> Result<Self, ScenarioError> {
        let text = Scenario::read_text(path)?;
        let name = path.file_stem().map_or_else(|| "scenario".into(), |stem| stem.to_string_lossy().into_owned());
        Ok(Self::parse(&name, &text)?.in_folder_of(path))
    }

    /// Parses the text of a scenario: a file with constraints or a reference is about conditioning.
    ///
    /// # Errors
    ///
    /// Bad TOML, an unknown or missing key, a value of the wrong kind.
    pub fn parse(name: &str, text: &str) -> Result<Self, ScenarioError> {
        let has = |key: &str| DeTable::parse(text).is_ok_and(|document| document.get_ref().contains_key(key));
        Ok(if has("constraint") || has("reference") {
            Self::Conditioning(Box::new(ConditioningScenario::parse(name, text)?))
        } else {
            Self::Speed(Box::new(Scenario::parse(name, text)?))
        })
    }

    /// The same scenario with the paths in it relative to the folder of a file.
    #[must_use]
    pub fn in_folder_of(self, file: &Path) -> Self {
        match self {
            Self::Speed(scenario) => Self::Speed(Box::new(scenario.in_folder_of(file))),
            Self::Conditioning(scenario) => Self::Conditioning(Box::new(scenario.in_folder_of(file))),
        }
    }

    /// Name on the command line, or the stem of the file.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Speed(scenario) => scenario.name(),
            Self::Conditioning(scenario) => scenario.name(),
        }
    }

    /// The text it was parsed from.
    #[must_use]
    pub fn text(&self) -> &str {
        match self {
            Self::Speed(scenario) => scenario.text(),
            Self::Conditioning(scenario) => scenario.text(),
        }
    }

    /// One sentence on what it is for.
    #[must_use]
    pub fn description(&self) -> &str {
        match self {
            Self::Speed(scenario) => scenario.description(),
            Self::Conditioning(scenario) => scenario.description(),
        }
    }

    /// The folder in which files that it names lie.
    #[must_use]
    pub fn folder(&self) -> &Path {
        match self {
            Self::Speed(scenario) => scenario.folder(),
            Self::Conditioning(scenario) => scenario.folder(),
        }
    }

    /// The verdict that it is expected to get.
    #[must_use]
    pub fn expectation(&self) -> Expectation {
        match self {
            Self::Speed(scenario) => scenario.expectation(),
            Self::Conditioning(scenario) => scenario.expectation(),
        }
    }

    /// Options of a campaign of random trials around it.
    ///
    /// # Errors
    ///
    /// A greatest disturbance that no scenario may have.
    pub fn verify_options(&self) -> Result<VerifyOptions, ScenarioError> {
        match self {
            Self::Speed(scenario) => scenario.verify_options(),
            Self::Conditioning(scenario) => scenario.verify_options(),
        }
    }
}
