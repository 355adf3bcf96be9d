//! Scenario files: a robot, a path, limits and a controller, in TOML.

pub(crate) mod curves;
pub(crate) mod number;
pub(crate) mod schema;
pub(crate) mod verify_options;

use crate::error::{Fault, LabError};
use crate::run::law::Method;
use crate::scenario::verify_options::VerifyOptions;
pub use schema::Expectation;
use schema::ScenarioFile;
use serde::de::DeserializeOwned;
use std::ops::Range;
use std::path::{Path, PathBuf};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A scenario: its text and what the text says.
#[derive(Clone, Debug)]
pub struct Scenario {
    name: String,
    text: String,
    folder: PathBuf,
    pub(crate) file: ScenarioFile,
}

/// A built-in scenario.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BuiltIn {
    /// Its name on the command line.
    pub name: &'static str,
    /// Its text, the same as a user's file would hold.
    pub text: &'static str,
}

/// What a scenario file describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScenarioKind {
    /// A robot whose speed along a path is regulated.
    Speed,
    /// A reference that is kept inside constraints.
    Conditioning,
}

/// The kind of a scenario's text: a file with constraints is about conditioning.
#[must_use]
pub fn scenario_kind(text: &str) -> ScenarioKind {
    let has = |key: &str| DeTable::parse(text).is_ok_and(|document| document.get_ref().contains_key(key));
    if has("constraint") || has("reference") { ScenarioKind::Conditioning } else { ScenarioKind::Speed }
}

/// The built-in scenarios, tutorial first.
pub const BUILT_IN: [BuiltIn; 16] = [
    BuiltIn { name: "planar-line", text: include_str!("../../scenarios/planar-line.toml") },
    BuiltIn { name: "puma-helix", text: include_str!("../../scenarios/puma-helix.toml") },
    BuiltIn { name: "puma-helix-on-path", text: include_str!("../../scenarios/puma-helix-on-path.toml") },
    BuiltIn { name: "puma-wrist-singularity", text: include_str!("../../scenarios/puma-wrist-singularity.toml") },
    BuiltIn { name: "puma-helix-acceleration", text: include_str!("../../scenarios/puma-helix-acceleration.toml") },
    BuiltIn { name: "planar-bend", text: include_str!("../../scenarios/planar-bend.toml") },
    BuiltIn { name: "tiny-motion", text: include_str!("../../scenarios/tiny-motion.toml") },
    BuiltIn { name: "ur5e-poses", text: include_str!("../../scenarios/ur5e-poses.toml") },
    BuiltIn { name: "panda-line", text: include_str!("../../scenarios/panda-line.toml") },
    BuiltIn { name: "ur20-lift", text: include_str!("../../scenarios/ur20-lift.toml") },
    BuiltIn { name: "natural-2r", text: include_str!("../../scenarios/natural-2r.toml") },
    BuiltIn { name: "natural-pa10", text: include_str!("../../scenarios/natural-pa10.toml") },
    BuiltIn { name: "helix-plane-sphere", text: include_str!("../../scenarios/helix-plane-sphere.toml") },
    BuiltIn { name: "trap-ellipsoid", text: include_str!("../../scenarios/trap-ellipsoid.toml") },
    BuiltIn { name: "trap-two-ellipsoids", text: include_str!("../../scenarios/trap-two-ellipsoids.toml") },
    BuiltIn { name: "trap-booth-oval", text: include_str!("../../scenarios/trap-booth-oval.toml") },
];

/// The commented template that `slideway init` writes.
pub const TEMPLATE: &str = include_str!("../../scenarios/template.toml");

/// Grid points that make sense: below, nothing is resolved; above, the solver needs minutes.
const GRID_POINTS: std::ops::RangeInclusive<usize> = 10..=100_000;

/// The commented template of a path-conditioning scenario.
pub const CONDITIONING_TEMPLATE: &str = include_str!("../../scenarios/template-conditioning.toml");

impl Scenario {
    /// A built-in scenario, if there is one of that name.
    #[must_use]
    pub fn built_in(name: &str) -> Option<Result<Self, LabError>> {
        BUILT_IN.iter().find(|b| b.name == name).map(|b| Self::parse(b.name, b.text))
    }

    /// Reads a scenario file; its name is the file's stem.
    ///
    /// # Errors
    ///
    /// The file cannot be read, or what [`Scenario::parse`] refuses.
    pub fn read(path: &Path) -> Result<Self, LabError> {
        let text = Self::read_text(path)?;
        let name = path.file_stem().map_or_else(|| "scenario".into(), |stem| stem.to_string_lossy().into_owned());
        Ok(Self::parse(&name, &text)?.in_folder_of(path))
    }

    /// The text of a scenario file, for showing errors in it.
    ///
    /// # Errors
    ///
    /// The file cannot be read.
    pub fn read_text(path: &Path) -> Result<String, LabError> {
        std::fs::read_to_string(path).map_err(|source| LabError::Read { path: path.to_owned(), source })
    }

    /// Parses the text of a scenario.
    ///
    /// # Errors
    ///
    /// Bad TOML, an unknown or missing key, a value of the wrong kind. What the values mean is checked when a problem is
    /// made from the scenario.
    pub fn parse(name: &str, text: &str) -> Result<Self, LabError> {
        let file = from_toml(text)?;
        Ok(Self { name: name.to_owned(), text: text.to_owned(), folder: PathBuf::new(), file })
    }

    /// The same scenario with the paths in it relative to the folder of a file; as parsed they are relative to the current
    /// folder.
    #[must_use]
    pub fn in_folder_of(self, file: &Path) -> Self {
        Self { folder: file.parent().map(Path::to_owned).unwrap_or_default(), ..self }
    }

    /// The folder in which files that the scenario names lie.
    pub(crate) fn folder(&self) -> &Path {
        &self.folder
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

    /// Checks what concerns the comparison rather than the problem.
    pub(crate) fn check_options(&self) -> Result<(), LabError> {
        let points = self.grid_points();
        if !(GRID_POINTS.contains(&points)) {
            let fault = Fault::OutOfRange {
                value: points as f64,
                least: *GRID_POINTS.start() as f64,
                most: *GRID_POINTS.end() as f64,
            };
            return Err(LabError::value("optimum.grid_points", fault));
        }
        self.verify_options()?;
        if !(self.tolerance() > 0.0) {
            return Err(LabError::value("compare.tolerance", Fault::NotPositive(self.tolerance())));
        }
        Ok(())
    }

    /// The key of the path's first point, for errors about it.
    pub(crate) fn path_start_key(&self) -> String {
        self.file.path.start_key()
    }

    /// The method that the verdict is about, if the scenario says so.
    #[must_use]
    pub fn judged_method(&self) -> Option<Method> {
        self.file.compare.method
    }

    /// The verdict that it is expected to get.
    #[must_use]
    pub fn expectation(&self) -> Expectation {
        self.file.compare.expect
    }

    /// Default tolerance of the verdict, as a fraction.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        self.file.compare.tolerance.map_or(0.02, |t| t.0)
    }

    /// Whether a seed changes anything.
    pub(crate) fn is_random(&self) -> bool {
        let table = &self.file.disturbances;
        table.joint_noise.is_some_and(|n| n.0 != 0.0) || table.jitter.is_some_and(|j| j.0 != 0.0)
    }

    /// What a campaign of random trials around it is asked to do.
    ///
    /// # Errors
    ///
    /// A greatest disturbance that no scenario may have.
    pub fn verify_options(&self) -> Result<VerifyOptions, LabError> {
        self.file.verify.read()
    }

    /// Grid points of the optimum.
    #[must_use]
    pub fn grid_points(&self) -> usize {
        self.file.optimum.grid_points.unwrap_or(1000) as usize
    }
}

/// Reads what a TOML text says.
pub(crate) fn from_toml<T: DeserializeOwned>(text: &str) -> Result<T, LabError> {
    toml::from_str(text).map_err(|error| LabError::Syntax { message: error.message().to_owned(), span: error.span() })
}

/// Where an error lies in a text, as a range of bytes: the value at its key, or the nearest table around it.
#[must_use]
pub fn locate(text: &str, error: &LabError) -> Option<Range<usize>> {
    match error {
        LabError::Syntax { span, .. } => span.clone(),
        LabError::Value { key, .. } => locate_key(text, key),
        LabError::LeavesReach { .. } | LabError::NoFiniteSpeed { .. } => locate_key(text, "path.end"),
        LabError::BrokenPath { .. } => locate_key(text, "path.position"),
        LabError::Read { .. } => None,
    }
}

/// The span of the value at a dotted key, or of the innermost part of the key that is there.
fn locate_key(text: &str, key: &str) -> Option<Range<usize>> {
    let document = DeTable::parse(text).ok()?;
    let mut parts = key.split('.');
    let mut found: Option<&Spanned<DeValue<'_>>> = document.get_ref().get(parts.next()?);
    let mut span = found.map(Spanned::span);
    for part in parts {
        found = match found.map(Spanned::get_ref) {
            Some(DeValue::Table(table)) => table.get(part),
            Some(DeValue::Array(array)) => part.parse::<usize>().ok().and_then(|i| array.get(i)),
            _ => None,
        };
        if let Some(value) = found {
            span = Some(value.span());
        } else {
            break;
        }
    }
    span
}
