//! Scenarios of a regulated speed: a robot, a path, limits and a controller, in TOML.

use crate::built_in::BUILT_IN;
use crate::encoding::Encoding;
use crate::error::ScenarioError;
use crate::read::problem::read_problem;
use crate::read::robot::describe;
use crate::tables::{Expectation, ScenarioFile, SolverName};
use crate::text::from_toml;
use slideway_lab::{Experiment, Method, Problem};
use slideway_path::Fault;
use slideway_robot::RobotDescription;
use slideway_verify::VerifyOptions;
use std::path::{Path, PathBuf};

/// A scenario: its text and what the text says.
#[derive(Clone, Debug)]
pub struct Scenario {
    name: String,
    text: String,
    folder: PathBuf,
    pub(crate) file: ScenarioFile,
}

/// Grid points that make sense: below, nothing is resolved; above, the solver needs minutes.
const GRID_POINTS: std::ops::RangeInclusive<usize> = 10..=100_000;
/// Cells of the whole path's bracket: a million take a minute.
const CELLS: std::ops::RangeInclusive<usize> = 10..=1_000_000;
/// Gaps of its bounds: below, rounding is of that size; above, they say nothing.
const GAPS: std::ops::RangeInclusive<f64> = 1e-10..=1.0;

impl Scenario {
    /// A built-in scenario, if there is one of that name.
    #[must_use]
    pub fn built_in(name: &str) -> Option<Result<Self, ScenarioError>> {
        BUILT_IN.iter().find(|b| b.name == name).map(|b| Self::parse(b.name, b.text))
    }

    /// Reads a scenario file; its name is the file's stem.
    ///
    /// # Errors
    ///
    /// The file cannot be read, or what [`Scenario::parse`] refuses.
    pub fn read(path: &Path) -> Result<Self, ScenarioError> {
        let text = Self::read_text(path)?;
        let name = path.file_stem().map_or_else(|| "scenario".into(), |stem| stem.to_string_lossy().into_owned());
        Ok(Self::parse(&name, &text)?.in_folder_of(path))
    }

    /// The text of a scenario file, for showing errors in it.
    ///
    /// # Errors
    ///
    /// The file cannot be read.
    pub fn read_text(path: &Path) -> Result<String, ScenarioError> {
        let bytes = std::fs::read(path).map_err(|source| ScenarioError::Read { path: path.to_owned(), source })?;
        // A byte order mark of UTF-8 says nothing.
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").map_or(bytes.clone(), <[u8]>::to_vec);
        String::from_utf8(bytes).map_err(|error| {
            let encoding = Encoding::of(error.as_bytes());
            ScenarioError::NotUtf8 { path: path.to_owned(), encoding }
        })
    }

    /// Parses the text of a scenario.
    ///
    /// # Errors
    ///
    /// Bad TOML, an unknown or missing key, a value of the wrong kind. What the values mean is checked when a problem is
    /// made from the scenario.
    pub fn parse(name: &str, text: &str) -> Result<Self, ScenarioError> {
        let of_file = |file| Self { name: name.to_owned(), text: text.to_owned(), folder: PathBuf::new(), file };
        from_toml(text, |file| of_file(file).experiment().err()).map(of_file)
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

    /// The problem of an arm of `N` joints, read and checked, and the methods' settings.
    ///
    /// # Errors
    ///
    /// The first value that cannot be used, with its key; a robot of another number of joints.
    pub fn problem<const N: usize>(&self) -> Result<Problem<N>, ScenarioError> {
        self.problem_of(&self.robot()?)
    }

    /// The experiment it describes: the problem, and its joint path traced.
    ///
    /// # Errors
    ///
    /// The first value that cannot be used, or a path that the robot cannot follow.
    pub fn experiment(&self) -> Result<Experiment, ScenarioError> {
        let robot = self.robot()?;
        Ok(match robot.joint_count() {
            1 => Experiment::try_from(self.problem_of::<1>(&robot)?)?,
            2 => Experiment::try_from(self.problem_of::<2>(&robot)?)?,
            3 => Experiment::try_from(self.problem_of::<3>(&robot)?)?,
            4 => Experiment::try_from(self.problem_of::<4>(&robot)?)?,
            5 => Experiment::try_from(self.problem_of::<5>(&robot)?)?,
            6 => Experiment::try_from(self.problem_of::<6>(&robot)?)?,
            _ => Experiment::try_from(self.problem_of::<7>(&robot)?)?,
        })
    }

    /// The robot, before its file or table is made into an arm.
    ///
    /// # Errors
    ///
    /// No robot or several, a file that gives none, or a number of joints that is not supported.
    pub fn robot(&self) -> Result<RobotDescription, ScenarioError> {
        describe(&self.file.robot, &self.folder)
    }

    fn problem_of<const N: usize>(&self, robot: &RobotDescription) -> Result<Problem<N>, ScenarioError> {
        self.check_options()?;
        read_problem(&self.file, &self.folder, robot)
    }

    /// Checks what concerns the comparison rather than the problem.
    fn check_options(&self) -> Result<(), ScenarioError> {
        let points = self.grid_points();
        if !(GRID_POINTS.contains(&points)) {
            let fault = Fault::OutOfRange {
                value: points as f64,
                least: *GRID_POINTS.start() as f64,
                most: *GRID_POINTS.end() as f64,
            };
            return Err(ScenarioError::value("optimum.grid_points", fault));
        }
        let cells = self.optimum_cells();
        if !CELLS.contains(&cells) {
            let fault =
                Fault::OutOfRange { value: cells as f64, least: *CELLS.start() as f64, most: *CELLS.end() as f64 };
            return Err(ScenarioError::value("optimum.cells", fault));
        }
        let gap = self.optimum_gap();
        if !GAPS.contains(&gap) {
            let fault = Fault::OutOfRange { value: gap, least: *GAPS.start(), most: *GAPS.end() };
            return Err(ScenarioError::value("optimum.gap", fault));
        }
        self.verify_options()?;
        if !(self.tolerance() > 0.0) {
            return Err(ScenarioError::value("compare.tolerance", Fault::NotPositive(self.tolerance())));
        }
        Ok(())
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
    pub fn verify_options(&self) -> Result<VerifyOptions, ScenarioError> {
        self.file.verify.read()
    }

    /// Relative gap that the bounds of the whole path's optimum are to come to.
    #[must_use]
    pub fn optimum_gap(&self) -> f64 {
        self.file.optimum.gap.map_or(1e-5, |gap| gap.0)
    }

    /// Most cells of its bracket.
    #[must_use]
    pub fn optimum_cells(&self) -> usize {
        self.file.optimum.cells.unwrap_or(20_000) as usize
    }

    /// The solver of the optimum.
    #[must_use]
    pub fn optimum_solver(&self) -> SolverName {
        self.file.optimum.solver
    }

    /// Grid points of the optimum.
    #[must_use]
    pub fn grid_points(&self) -> usize {
        self.file.optimum.grid_points.unwrap_or(1000) as usize
    }
}
