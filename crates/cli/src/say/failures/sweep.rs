use crate::say::snippet::Snippet;
use slideway_scenario::locate;
use slideway_scenario::sweep::SweepError;
use std::ops::Range;
use thiserror::Error;

/// Why a sweep cannot be made.
#[derive(Debug, Error)]
#[error("{error}")]
pub(crate) struct SweepFailure {
    pub(crate) error: Box<SweepError>,
    /// What the user called the scenario.
    pub(crate) file: String,
}

impl SweepFailure {
    pub(crate) fn remedy(&self) -> String {
        self.error.remedy()
    }

    /// The scenario's text with the settings of the cell in it, and where in it the error lies.
    pub(crate) fn source_and_span(&self) -> (Option<Snippet>, Option<Range<usize>>) {
        let Self { error, file } = self;
        let SweepError::Cell { error, settings, text } = error.as_ref() else { return (None, None) };
        let name = if settings.is_empty() { file.clone() } else { format!("{file} with {settings}") };
        (Some(Snippet::new(&name, text)), locate(text, error))
    }
}
