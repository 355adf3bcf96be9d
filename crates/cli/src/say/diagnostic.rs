use crate::say::failures::journal::JournalError;
use crate::say::failures::sweep::SweepFailure;
use crate::say::failures::verify::{VerifyFailure, of_tuning};
use crate::say::snippet::{LONGEST_ECHO, Snippet, short_echo};
use miette::{Diagnostic, LabeledSpan, SourceCode};
use slideway_baselines::time_optimal::OptimumError;
use slideway_compare::CompareError;
use slideway_figures::FigureError;
use slideway_lab::ThreadsError;
use slideway_proofs::kept::KeptError;
use slideway_robot::models::Model;
use slideway_robot::{RobotError, UrdfError};
use slideway_scenario::{ScenarioError, TuningError, locate};
use slideway_study::{Study, StudyError};
use std::fmt;
use std::path::PathBuf;
use thiserror::Error;

/// What the command cannot do, with what it needs to show where and what to do.
#[derive(Debug, Error)]
pub(crate) enum CliError {
    /// A scenario that cannot be used, with its text if there is one.
    #[error("{error}")]
    Scenario { error: Box<ScenarioError>, file: String, text: Option<String> },
    /// A name that nothing has, and the one that may be meant.
    #[error("there is no {} called `{name}`", what.kind())]
    Unknown { what: Named, name: String, nearest: Option<&'static str> },
    /// A case that cannot be replayed.
    #[error("{}: {error}", path.display())]
    Kept { path: PathBuf, error: KeptError },
    /// An option with a value that makes no sense.
    #[error("--{option} is {value}")]
    Option { option: &'static str, value: f64, remedy: &'static str },
    /// A file that exists and must not.
    #[error("{} exists already", path.display())]
    Exists { path: PathBuf },
    /// A study that could not be run.
    #[error("{name}: {error}")]
    Study { error: Box<StudyError>, name: &'static str },
    /// A URDF that gives no arm, with its text if it could be read.
    #[error("{file}: {error}")]
    Urdf { error: Box<UrdfError>, file: String, text: Option<String> },
    /// A robot that cannot do what is asked for.
    #[error("{name}: {error}")]
    Robot { error: Box<RobotError>, name: String },
    /// An arm with too many joints.
    #[error("{name}: {} joints between `{base}` and `{tip}` ({}); at most {most} are supported", joints.len(), joints.join(", "))]
    TooManyJoints { name: String, base: String, tip: String, joints: Vec<String>, most: usize },
    /// An option with a list of numbers that cannot be used.
    #[error("--{option}: {message}")]
    Numbers { option: &'static str, message: String, remedy: String },
    /// An option that the robot has no data for.
    #[error("--{option}: `{name}` has no {what}")]
    NoData { option: &'static str, name: String, what: &'static str },
    /// A file or folder that cannot be written.
    #[error("cannot write {}: {source}", path.display())]
    Write { path: PathBuf, source: std::io::Error },
    /// Standard output that takes no more.
    #[error("cannot write to standard output: {0}")]
    Print(std::io::Error),
    /// No comparison, or no optimum; with the scenario's name or file where one of several is meant.
    #[error("{}{error}", file.as_ref().map_or(String::new(), |file| format!("{file}: ")))]
    Compare { error: Box<CompareError>, file: Option<String> },
    /// No figures.
    #[error("no figures: {0}")]
    Figures(#[from] FigureError),
    /// A scenario that cannot be tuned.
    #[error("{name}: {error}")]
    Tune { error: Box<TuningError>, name: String },
    /// No sweep.
    #[error(transparent)]
    Sweep(#[from] SweepFailure),
    /// A journal that cannot be used.
    #[error(transparent)]
    Journal(#[from] JournalError),
    /// No campaign.
    #[error(transparent)]
    Verify(#[from] VerifyFailure),
    /// No threads.
    #[error(transparent)]
    Threads(#[from] ThreadsError),
}

impl CliError {
    /// As a report that prints with file, line and remedy.
    pub(crate) fn into_report(self) -> miette::Report {
        let (source, span) = match &self {
            Self::Scenario { error, file, text: Some(text) } => (Some(Snippet::new(file, text)), locate(text, error)),
            Self::Urdf { error, file, text: Some(text) } => (Some(Snippet::new(file, text)), error.locate(text)),
            Self::Sweep(failure) => failure.source_and_span(),
            _ => (None, None),
        };
        let (message, help) = (short_echo(&self.to_string()), short_echo(&self.remedy()));
        miette::Report::new(Pointed { message, source, span, help })
    }

    fn remedy(&self) -> String {
        match self {
            Self::Scenario { error, .. } => error.remedy(),
            Self::Unknown { what, nearest, .. } => what.remedy(*nearest),
            Self::Kept { error, .. } => error.remedy().into(),
            Self::Option { remedy, .. } => (*remedy).into(),
            Self::Study { error, .. } => error.remedy().into(),
            Self::Urdf { error, .. } => error.remedy(),
            Self::Robot { error, .. } => error.remedy(),
            Self::TooManyJoints { .. } => "choose a shorter arm with --base LINK and --tip LINK".into(),
            Self::Numbers { remedy, .. } => remedy.clone(),
            Self::NoData { .. } => "leave the option out, or describe the robot with these data in a URDF file".into(),
            Self::Exists { .. } => "choose another name, or remove the file first".into(),
            Self::Write { .. } => {
                "check that the folder exists and may be written, or choose another with --out".into()
            }
            Self::Print(_) => {
                "let what reads it read to the end, or send it to a file on a disk with room; results in a folder are whole".into()
            }
            Self::Compare { error, .. } => error.remedy(),
            Self::Sweep(failure) => failure.remedy(),
            Self::Journal(error) => error.remedy(),
            Self::Verify(failure) => failure.remedy(),
            Self::Threads(error) => error.remedy(),
            Self::Tune { error, .. } => of_tuning(error),
            Self::Figures(_) => "check that the output folder may be written".into(),
        }
    }
}

/// Things that have names.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Named {
    Scenario,
    Claim,
    Robot,
    Study,
}

impl Named {
    fn kind(self) -> &'static str {
        match self {
            Self::Scenario => "built-in scenario and no file",
            Self::Claim => "claim",
            Self::Robot => "built-in robot and no file",
            Self::Study => "study",
        }
    }

    /// The name that may be meant, and where all names are shown.
    fn remedy(self, nearest: Option<&str>) -> String {
        let meant = nearest.map(|name| format!("did you mean `{name}`?"));
        let list = match self {
            Self::Claim => "`slideway claims` shows all of them",
            Self::Scenario if nearest.is_some() => "`slideway list` shows the built-in scenarios",
            Self::Scenario => {
                "`slideway list` shows the built-in scenarios, `slideway init FILE` writes one of your own"
            }
            Self::Robot | Self::Study if nearest.is_some() => "",
            Self::Robot => {
                let names: Vec<&str> = Model::ALL.iter().map(|m| m.name()).collect();
                return format!("give the path of a URDF file, or one of {}", names.join(", "));
            }
            Self::Study => {
                let names: Vec<&str> = Study::ALL.iter().map(|s| s.name()).collect();
                return format!("give one of {}, or --all", names.join(", "));
            }
        };
        [meant.as_deref().unwrap_or_default(), list].join(" ").trim().to_owned()
    }
}

impl From<CompareError> for CliError {
    fn from(error: CompareError) -> Self {
        match error {
            CompareError::Option { option, value, remedy } => Self::Option { option, value, remedy },
            error => Self::Compare { error: Box::new(error), file: None },
        }
    }
}

/// Of verification and tuning, which have one scenario.
impl From<OptimumError> for CliError {
    fn from(error: OptimumError) -> Self {
        CompareError::NoOptimum { error, joint: None, widening: None }.into()
    }
}

/// An error with a place in a text and a remedy.
struct Pointed {
    message: String,
    source: Option<Snippet>,
    span: Option<std::ops::Range<usize>>,
    help: String,
}

impl fmt::Debug for Pointed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl fmt::Display for Pointed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Pointed {}

impl Diagnostic for Pointed {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(&self.help))
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.source.as_ref().map(|s| s as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let span = self.span.clone()?;
        let length = span.len().min(LONGEST_ECHO / 2);
        Some(Box::new(std::iter::once(LabeledSpan::new(Some("here".into()), span.start, length))))
    }
}
