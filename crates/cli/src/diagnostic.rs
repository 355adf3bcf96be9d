use crate::journal_error::JournalError;
use crate::sweep_error::SweepFailure;
use crate::table::short;
use crate::verify_error::{VerifyFailure, of_campaign};
use miette::{Diagnostic, LabeledSpan, NamedSource, SourceCode};
use slideway_baselines::time_optimal::OptimumError;
use slideway_figures::FigureError;
use slideway_lab::ThreadsError;
use slideway_proofs::kept::KeptError;
use slideway_robot::models::Model;
use slideway_robot::{RobotError, UrdfError};
use slideway_scenario::{ScenarioError, locate};
use slideway_study::{Study, StudyError};
use slideway_verify::VerifyError;
use std::fmt;
use std::path::PathBuf;
use thiserror::Error;

/// What the command cannot do, with what it needs to show where and what to do.
#[derive(Debug, Error)]
pub(crate) enum CliError {
    /// A scenario that cannot be used, with its text if there is one.
    #[error("{error}")]
    Scenario { error: Box<ScenarioError>, file: String, text: Option<String> },
    /// Neither a built-in scenario nor a file.
    #[error("there is no built-in scenario and no file called `{name}`")]
    UnknownScenario { name: String, nearest: Option<&'static str> },
    /// No claim of that name.
    #[error("there is no claim called `{name}`")]
    UnknownClaim { name: String, nearest: Option<&'static str> },
    /// A case that cannot be replayed.
    #[error("{}: {error}", path.display())]
    Kept { path: PathBuf, error: KeptError },
    /// An option with a value that makes no sense.
    #[error("--{option} is {value}")]
    Option { option: &'static str, value: f64, remedy: &'static str },
    /// A file that exists and must not.
    #[error("{} exists already", path.display())]
    Exists { path: PathBuf },
    /// Neither a built-in robot nor a file.
    #[error("there is no built-in robot and no file called `{name}`")]
    UnknownRobot { name: String, nearest: Option<&'static str> },
    /// No study of that name.
    #[error("there is no study called `{name}`")]
    UnknownStudy { name: String, nearest: Option<&'static str> },
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
    /// No optimum.
    #[error("no optimum: {0}")]
    Optimum(#[from] OptimumError),
    /// Limits that no profile keeps, and by which share of their half ranges they would have to give way.
    #[error("no optimum: {error}")]
    Infeasible { error: OptimumError, widening: Option<f64> },
    /// An error that does not name its scenario itself, with the scenario's name or file.
    #[error("{file}: {error}")]
    InFile { file: String, error: Box<CliError> },
    /// No figures.
    #[error("no figures: {0}")]
    Figures(#[from] FigureError),
    /// A scenario that cannot be tuned.
    #[error("{name}: {error}")]
    Tune { error: Box<VerifyError>, name: String },
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
    /// Names the scenario where an error is about one and does not tell which.
    pub(crate) fn in_file(self, file: &str) -> Self {
        match self {
            Self::Optimum(_) | Self::Infeasible { .. } => Self::InFile { file: file.to_owned(), error: Box::new(self) },
            named => named,
        }
    }

    /// As a report that prints with file, line and remedy.
    pub(crate) fn into_report(self) -> miette::Report {
        let (source, span) = match &self {
            Self::Scenario { error, file, text: Some(text) } => {
                (Some(NamedSource::new(file.clone(), text.clone()).with_language("TOML")), locate(text, error))
            }
            Self::Urdf { error, file, text: Some(text) } => {
                (Some(NamedSource::new(file.clone(), text.clone()).with_language("XML")), error.locate(text))
            }
            Self::Sweep(failure) => failure.source_and_span(),
            _ => (None, None),
        };
        let help = self.remedy();
        miette::Report::new(Pointed { message: self.to_string(), source, span, help })
    }

    fn remedy(&self) -> String {
        match self {
            Self::Scenario { error, .. } => error.remedy(),
            Self::UnknownClaim { nearest: Some(nearest), .. } => {
                format!("did you mean `{nearest}`? `slideway claims` shows all of them")
            }
            Self::UnknownClaim { .. } => "`slideway claims` shows all of them".to_owned(),
            Self::UnknownScenario { nearest: Some(nearest), .. } => {
                format!("did you mean `{nearest}`? `slideway list` shows the built-in scenarios")
            }
            Self::UnknownScenario { nearest: None, .. } => {
                "`slideway list` shows the built-in scenarios, `slideway init FILE` writes one of your own".into()
            }
            Self::Kept { error, .. } => error.remedy().into(),
            Self::Option { remedy, .. } => (*remedy).into(),
            Self::UnknownRobot { nearest: Some(nearest), .. } => format!("did you mean `{nearest}`?"),
            Self::UnknownRobot { nearest: None, .. } => {
                let names: Vec<&str> = Model::ALL.iter().map(|m| m.name()).collect();
                format!("give the path of a URDF file, or one of {}", names.join(", "))
            }
            Self::UnknownStudy { nearest: Some(nearest), .. } => format!("did you mean `{nearest}`?"),
            Self::UnknownStudy { nearest: None, .. } => {
                let names: Vec<&str> = Study::ALL.iter().map(|s| s.name()).collect();
                format!("give one of {}, or --all", names.join(", "))
            }
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
            Self::Optimum(OptimumError::NoMotion { .. }) => "give a path along which the joints move".into(),
            Self::Infeasible { widening, .. } => match widening {
                Some(share) => format!(
                    "raise the limit named, or change the path or its speed at the ends there; if every such limit gave way by {} % \
                     of half its range, there would be a profile",
                    short(100.0 * share)
                ),
                None => "raise the limit named, or change the path or its speed at the ends there".into(),
            },
            Self::Optimum(_) => "a path that avoids singular configurations can be solved".into(),
            Self::InFile { error, .. } => error.remedy(),
            Self::Sweep(failure) => failure.remedy(),
            Self::Journal(error) => error.remedy(),
            Self::Verify(failure) => failure.remedy(),
            Self::Threads(error) => error.remedy(),
            Self::Tune { error, .. } => of_campaign(error),
            Self::Figures(_) => "check that the output folder may be written".into(),
        }
    }
}

/// An error with a place in a text and a remedy.
struct Pointed {
    message: String,
    source: Option<NamedSource<String>>,
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
        Some(Box::new(std::iter::once(LabeledSpan::new(Some("here".into()), span.start, span.len()))))
    }
}
