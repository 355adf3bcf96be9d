use super::setting::{Axis, Setting};
use std::path::PathBuf;

/// What a sweep is asked to do.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepRequest {
    /// Name of the scenario.
    pub name: String,
    /// Its text.
    pub text: String,
    /// Its file, if it has one: files that the scenario names lie beside it.
    pub file: Option<PathBuf>,
    /// The method; without one the one that a comparison judges.
    pub method: Option<String>,
    /// Seeds `1..=N` of the random walk and the disturbances; without them the scenario's own.
    pub seeds: Option<u64>,
    /// Values replaced in every run.
    pub settings: Vec<Setting>,
    /// Values varied: the runs cover every combination.
    pub axes: Vec<Axis>,
}

impl SweepRequest {
    /// One run of a scenario as it is.
    #[must_use]
    pub fn of(name: &str, text: String) -> Self {
        Self {
            name: name.to_owned(),
            text,
            file: None,
            method: None,
            seeds: None,
            settings: Vec::new(),
            axes: Vec::new(),
        }
    }
}
