use super::error::SweepError;
use super::request::SweepRequest;
use super::setting::{Setting, shown};
use crate::any::AnyScenario;
use crate::error::ScenarioError;
use slideway_compare::sweep::{SweepRow, SweepRun};
use toml::{Table, Value};

/// One cell of the grid: the scenario with the cell's values in it, checked.
#[derive(Clone, Debug)]
pub(crate) struct Cell {
    /// The values of the axes.
    pub(crate) values: Vec<Value>,
    /// Names of a row's values.
    pub(crate) columns: Vec<String>,
    scenario: AnyScenario,
    settings: String,
    text: String,
}

impl Cell {
    /// Applies the settings of every cell and those of this one, and reads the result as a scenario of its own.
    ///
    /// Without settings the text stays as it was written, so that errors point at the user's own lines.
    pub(crate) fn new(request: &SweepRequest, values: Vec<Value>) -> Result<Self, SweepError> {
        let axes = request.axes.iter().zip(&values);
        let own = axes.map(|(axis, value)| Setting { key: axis.key.clone(), value: value.clone() });
        let settings: Vec<Setting> = request.settings.iter().cloned().chain(own).collect();
        let text = applied(&request.text, &settings)?;
        let settings: Vec<String> = settings.iter().map(|s| format!("{}={}", s.key, shown(&s.value))).collect();
        let settings = settings.join(" ");
        let pointed =
            |error| SweepError::Cell { error: Box::new(error), settings: settings.clone(), text: text.clone() };
        let scenario = AnyScenario::parse(&request.name, &text).map_err(pointed)?;
        let scenario = match &request.file {
            Some(file) => scenario.in_folder_of(file),
            None => scenario,
        };
        scenario.check(request.method.as_deref()).map_err(pointed)?;
        let columns = scenario.sweep_columns().map_err(pointed)?;
        Ok(Self { values, columns, scenario, settings, text })
    }

    /// The scenario with the settings in it.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// Whether a seed changes anything.
    pub(crate) fn is_random(&self) -> bool {
        self.scenario.is_random()
    }

    /// The method that runs where none is chosen.
    pub(crate) fn judged_method(&self) -> Result<&'static str, SweepError> {
        Ok(self.scenario.subject(None).map_err(|error| self.pointed(error))?.method())
    }

    /// Runs the cell with a seed.
    pub(crate) fn run(&self, number: usize, method: &str, seed: Option<u64>) -> Result<SweepRow, SweepError> {
        let subject = self.scenario.subject(Some(method)).map_err(|error| self.pointed(error))?;
        SweepRun { number, subject, seed }.row().map_err(|error| self.pointed(error.into()))
    }

    fn pointed(&self, error: ScenarioError) -> SweepError {
        SweepError::Cell { error: Box::new(error), settings: self.settings.clone(), text: self.text.clone() }
    }
}

fn applied(text: &str, settings: &[Setting]) -> Result<String, SweepError> {
    if settings.is_empty() {
        return Ok(text.to_owned());
    }
    let unreadable = |message: String, span| SweepError::Cell {
        error: Box::new(ScenarioError::Syntax { message, span }),
        settings: String::new(),
        text: text.to_owned(),
    };
    let mut document: Table =
        text.parse().map_err(|e: toml::de::Error| unreadable(e.message().to_owned(), e.span()))?;
    for setting in settings {
        setting.apply(&mut document)?;
    }
    toml::to_string(&document).map_err(|error| unreadable(error.to_string(), None))
}
