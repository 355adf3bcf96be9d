use crate::error::ScenarioError;
use slideway_lab::ThreadsError;
use thiserror::Error;

/// Everything that can be wrong with a sweep.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SweepError {
    /// A setting or axis that is not `KEY=VALUE`.
    #[error("`{given}` is not a key, an equals sign and a value")]
    NotAssigned {
        /// What was given.
        given: String,
    },
    /// A value that begins like a list, a table or a quoted string and is none.
    #[error("`{key}`: `{value}` is no TOML value: {reason}")]
    Value {
        /// The key.
        key: String,
        /// The value.
        value: String,
        /// What the parser says.
        reason: String,
    },
    /// A key that leads through a plain value.
    #[error("`{key}`: `{at}` is {found}, not a table")]
    NotATable {
        /// The key.
        key: String,
        /// How far it leads.
        at: String,
        /// What is there.
        found: String,
    },
    /// A key with an element that a list does not have.
    #[error("`{key}`: `{at}` is a list of {length}; `{element}` is none of its elements")]
    NoElement {
        /// The key.
        key: String,
        /// The list.
        at: String,
        /// Its length.
        length: usize,
        /// What was asked for.
        element: String,
    },
    /// Two settings or axes of which one contains the other.
    #[error("`{first}` and `{second}` set the same thing")]
    Overlap {
        /// The one.
        first: String,
        /// The other.
        second: String,
    },
    /// Seeds for a scenario that draws nothing.
    #[error("`{scenario}` draws no random numbers: every seed gives the same run")]
    NothingRandom {
        /// The scenario.
        scenario: String,
    },
    /// No run at all, or more than a sweep may have.
    #[error("{runs} runs; between 1 and {most} are possible")]
    Runs {
        /// How many; the largest number there is if there are more.
        runs: u64,
        /// Most.
        most: u64,
    },
    /// Constraints that differ between grid cells, so that the rows do not share their columns.
    #[error("the grid changes the names or the number of the constraints")]
    Columns,
    /// A scenario that cannot be used with the settings of one grid cell.
    #[error("{error}")]
    Cell {
        /// What is wrong.
        error: Box<ScenarioError>,
        /// The settings that make the cell, empty without any.
        settings: String,
        /// The scenario's text with the settings in it.
        text: String,
    },
    /// The system gives no threads.
    #[error(transparent)]
    Threads(#[from] ThreadsError),
}

impl SweepError {
    /// What to do about it, in one sentence.
    #[must_use]
    pub fn remedy(&self) -> String {
        match self {
            Self::NotAssigned { .. } => {
                "write for example control.bandwidth=5 or, as a grid, control.bandwidth=5,10,20".into()
            }
            Self::Value { .. } => {
                "close every bracket and quote, and put the whole argument in single quotes for the shell".into()
            }
            Self::NotATable { at, .. } => format!("set `{at}` as a whole, for example {at}='{{ name = 1 }}'"),
            Self::NoElement { length: 0, .. } => "the list is empty; set it as a whole".into(),
            Self::NoElement { length, .. } => format!("count the elements from 0 to {}", length - 1),
            Self::Overlap { .. } => "keep one of them; --seeds sets `trap.seed` and `disturbances.seed`".into(),
            Self::NothingRandom { .. } => "leave out --seeds, or sweep over parameters with --grid KEY=V1,V2".into(),
            Self::Runs { .. } => "ask for fewer seeds or a coarser grid, and give every grid key a value".into(),
            Self::Columns => "sweep each set of constraints by itself".into(),
            Self::Cell { error, .. } => error.remedy(),
            Self::Threads(error) => error.remedy(),
        }
    }
}
