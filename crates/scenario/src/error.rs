use crate::encoding::Encoding;
use crate::read::number_table::TableError;
use slideway_path::curve::CurveError;
use slideway_path::{Fault, ProblemError};
use slideway_robot::UrdfError;
use std::ops::Range;
use std::path::PathBuf;
use thiserror::Error;

/// Everything that can be wrong with a scenario.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ScenarioError {
    /// The file cannot be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Message of the system.
        source: std::io::Error,
    },
    /// The file is no text in UTF-8.
    #[error("{} is {encoding}, not UTF-8", path.display())]
    NotUtf8 {
        /// The file.
        path: PathBuf,
        /// How it is written.
        encoding: Encoding,
    },
    /// The text is not a scenario: bad TOML, an unknown key, a value of the wrong kind.
    #[error("{message}")]
    Text {
        /// Message of the parser, with the key it is about.
        message: String,
        /// What to do about it.
        remedy: String,
        /// Place, as a range of bytes of the text.
        span: Option<Range<usize>>,
    },
    /// The text is not TOML.
    #[error("{message}")]
    Syntax {
        /// Message of the parser.
        message: String,
        /// Place, as a range of bytes of the text.
        span: Option<Range<usize>>,
    },
    /// A CSV file that does not hold way-points.
    #[error("`{key}`: {}: {error}", path.display())]
    Csv {
        /// The key that names the file.
        key: String,
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        error: TableError,
    },
    /// Way-points in a CSV file that no curve joins.
    #[error("`{key}`: {}: {}{error}", path.display(), line.map_or_else(String::new, |line| format!("line {line}: ")))]
    CsvWaypoint {
        /// The key that names the file.
        key: String,
        /// The file.
        path: PathBuf,
        /// The line of the way-point, counted from 1, if the error is about a single one.
        line: Option<u64>,
        /// What is wrong.
        error: CurveError,
    },
    /// A URDF that gives no arm.
    #[error("`{key}`: {}: {error}", path.display())]
    Urdf {
        /// The key that names the file.
        key: String,
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        error: Box<UrdfError>,
    },
    /// A method that there is not, or that is no form of what is judged.
    #[error("there is no method `{name}` for this kind of scenario")]
    UnknownMethod {
        /// What was given.
        name: String,
        /// What there is.
        known: Vec<&'static str>,
    },
    /// A value of the right shape that cannot be used, or a path that cannot be followed.
    #[error(transparent)]
    Problem(#[from] ProblemError),
}

impl ScenarioError {
    /// A value at a key of the scenario that cannot be used.
    #[must_use]
    pub fn value(key: impl Into<String>, fault: impl Into<Fault>) -> Self {
        Self::Problem(ProblemError::value(key, fault))
    }

    /// The key of the value that the error is about, dotted, list elements counted from 0.
    #[must_use]
    pub fn key(&self) -> Option<&str> {
        match self {
            Self::Csv { key, .. } | Self::CsvWaypoint { key, .. } | Self::Urdf { key, .. } => Some(key),
            Self::Problem(ProblemError::Value { key, .. }) => Some(key),
            _ => None,
        }
    }

    /// What to do about it, in one sentence.
    #[must_use]
    pub fn remedy(&self) -> String {
        match self {
            Self::Read { .. } => {
                "give the path of a TOML file, or the name of a built-in scenario (`slideway list` shows them)".into()
            }
            Self::NotUtf8 { .. } => "save the file as UTF-8".into(),
            Self::Text { remedy, .. } => remedy.clone(),
            Self::Syntax { .. } => "write `key = value`, one a line, and strings in quotes".into(),
            Self::Csv { error, .. } => error.remedy().into(),
            Self::CsvWaypoint { error, .. } => error.remedy().into(),
            Self::Urdf { error, .. } => error.remedy(),
            Self::UnknownMethod { known, .. } => format!("choose one of {}", known.join(", ")),
            Self::Problem(error) => error.remedy(),
        }
    }
}
