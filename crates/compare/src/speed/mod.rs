//! Speed laws beside the certified time optimum.

pub(crate) mod entries;
mod judged;
pub(crate) mod laws;
pub(crate) mod motion;
mod obstacle;
pub(crate) mod on_grid;
pub(crate) mod summary;
pub(crate) mod verdict;
pub(crate) mod whole;
pub(crate) mod windows;

use crate::error::{CompareError, check_refinement, check_shares};
use crate::progress::{Stage, Steps, Watch};
use entries::{ExcessEntry, MethodEntry, OptimumEntry, Solved};
use judged::Judged;
use laws::{LawCourse, LawModelError, ModelErrorEntry};
use motion::OptimumMotion;
use on_grid::SolvedGrid;
use slideway_baselines::path_bracket::BracketOptions;
use slideway_baselines::time_optimal::{OptimumError, Solver, TimeOptimum, needed_widening};
use slideway_lab::{Experiment, Method, Trace};
use slideway_path::{LimitKind, SampledPath};
use slideway_robot::RobotSummary;
use summary::{LeftOut, SpeedSummary};
use verdict::SpeedVerdict;
use whole::{NoWhole, WholeOptimum, WholeOptions};
use windows::windows;

/// Samples between grid points at which violations are looked for.
const BETWEEN: usize = 7;

/// Options of a comparison of speed laws.
#[derive(Clone, Debug)]
pub struct SpeedOptions {
    /// Name of the problem, for the summary.
    pub name: String,
    /// A line about it, for the summary.
    pub description: String,
    /// The robot, for the summary.
    pub robot: Option<RobotSummary>,
    /// Method that the verdict is about; `None` for the experiment's own choice.
    pub judged: Option<Method>,
    /// Largest difference of the judged method's time from the optimum's, as a share of the optimum's.
    pub tolerance: f64,
    /// Share of each limit to which the optimum keeps the limits between grid points too; `None` for at grid points alone.
    pub inter_sample: Option<f64>,
    /// Grid points of the optimum, at least 1 interval.
    pub grid_points: usize,
    /// Relative gap of the bounds of the whole path's optimum that refinement aims at.
    pub gap: f64,
    /// Most cells of its bracket.
    pub cells: usize,
    /// The solver of both optima, the whole path's and the grid's. No bound rests on it.
    pub solver: Solver,
}

impl SpeedOptions {
    /// The defaults of a scenario: a tolerance of 2 %, a gap of 1e-5 with at most 20 000 cells, 1000 grid points whose limits are kept there alone.
    #[must_use]
    pub fn named(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            description: String::new(),
            robot: None,
            judged: None,
            tolerance: 0.02,
            inter_sample: None,
            grid_points: 1000,
            gap: BracketOptions::default().gap,
            cells: BracketOptions::default().cells,
            solver: Solver::default(),
        }
    }
}

impl SpeedOptions {
    fn whole(&self) -> WholeOptions {
        WholeOptions { gap: self.gap, cells: self.cells, solver: self.solver }
    }
}

/// A finished comparison of speed laws.
#[derive(Clone, Debug)]
pub struct SpeedComparison {
    /// Its numbers, with the verdict.
    pub summary: SpeedSummary,
    /// One run per method, in the order of the experiment's methods.
    pub traces: Vec<Trace>,
    /// The optimum of the whole path; `None` where its limits are taken at the nodes of a grid only.
    pub whole: Option<WholeOptimum>,
    /// The grid's optimum, with its profile and certificate.
    pub optimum: TimeOptimum,
    /// The joint path on the optimum's grid.
    pub path: SampledPath,
    /// Courses of the joints under the laws of `[N]`, the optimum's first; empty unless the experiment runs natural motion.
    pub courses: Vec<LawCourse>,
    /// Runs of those courses with wrong masses; empty where the masses are unknown.
    pub model_errors: Vec<LawModelError>,
}

/// Runs every speed law of an experiment and puts it beside the certified time optimum. The same experiment and options give the
/// same comparison, but for the time that solving took.
///
/// # Errors
///
/// An option that cannot be used, a method or parameters that cannot be run, no optimum, or an end by the caller.
pub fn compare_speed(
    experiment: &Experiment,
    options: &SpeedOptions,
    watch: &mut Watch<'_>,
) -> Result<SpeedComparison, CompareError> {
    check_shares(Some(options.tolerance), options.inter_sample)?;
    check_refinement(Some(options.gap), Some(options.cells))?;
    let judged = experiment.judged_method(options.judged)?;
    let methods = experiment.methods();
    let mut steps = Steps::new(watch, methods.len() + 2);
    let mut traces = Vec::new();
    for method in methods {
        steps.at(Stage::SpeedLaw(method))?;
        traces.push(experiment.run(method)?);
    }
    steps.at(Stage::Optimum)?;
    let path = experiment.sample(options.grid_points, BETWEEN)?;
    let finer = experiment.sample(2 * options.grid_points, 0)?;
    let whole = WholeOptimum::new(experiment, options.whole());
    let grid = SolvedGrid::new([&path, &finer], options.inter_sample, options.solver)
        .map_err(|error| no_optimum(error, &path, experiment.joint_names()))?;
    let solved = Solved { whole, grid };
    let study = Study { experiment, options, path: &path, finer: &finer, judged };
    let mut summary = study.summarise(&traces, &solved)?;
    steps.at(Stage::Variations)?;
    summary.look_ahead = windows(experiment, &summary.optimum, &mut steps)?;
    let course = laws::optimum_course(experiment, &solved.grid.optimum)?;
    summary.optimum_effort = course.effort();
    summary.scaled_limits = laws::sweep_limits(experiment, &path, &mut steps)?;
    let courses = laws::courses(experiment, &traces, &course);
    let model_errors = laws::model_errors(experiment, &courses)?;
    summary.model_error = model_errors.iter().map(ModelErrorEntry::from).collect();
    let (whole, optimum) = (solved.whole.ok(), solved.grid.optimum);
    Ok(SpeedComparison { summary, traces, whole, optimum, path, courses, model_errors })
}

/// Adds the name of the joint whose limit no profile keeps, and by how much such limits would have to give way.
fn no_optimum(error: OptimumError, path: &SampledPath, joint_names: &[String]) -> CompareError {
    let joint = match error {
        OptimumError::Infeasible {
            kind: LimitKind::JointSpeed | LimitKind::JointAcceleration | LimitKind::JointTorque,
            index,
            ..
        } => joint_names.get(index).cloned(),
        _ => None,
    };
    let widening = matches!(error, OptimumError::Infeasible { .. }).then(|| needed_widening(path)).flatten();
    CompareError::NoOptimum { error, joint, widening }
}

/// An experiment with its path on a grid and on one twice as fine.
struct Study<'a> {
    experiment: &'a Experiment,
    options: &'a SpeedOptions,
    path: &'a SampledPath,
    finer: &'a SampledPath,
    judged: Method,
}

impl SpeedComparison {
    /// The optimum as a motion of the joints at the controller's sampling period, for the experiment compared.
    ///
    /// # Errors
    ///
    /// The inverse kinematics fails at a place it passed while tracing.
    pub fn optimum_motion(&self, experiment: &Experiment) -> Result<OptimumMotion, CompareError> {
        let period = experiment.control().sampling_period;
        Ok(OptimumMotion::new(experiment, self.whole.as_ref(), &self.optimum, period)?)
    }
}

impl Study<'_> {
    fn summarise(&self, traces: &[Trace], solved: &Solved) -> Result<SpeedSummary, CompareError> {
        let Self { experiment, options, path, .. } = self;
        let optimum = OptimumEntry::new(solved, path.speed_limited_time(), experiment.joint_names());
        let speed_only = self.under_speed_limits_alone(&solved.whole)?;
        let entry = |trace| MethodEntry::new(experiment, trace, &optimum);
        let methods = traces.iter().map(entry).collect::<Result<Vec<_>, _>>()?;
        let judge = |(entry, trace)| Judged {
            entry,
            trace,
            optimum: &optimum,
            speed_only: speed_only.as_ref(),
            disturbances: experiment.disturbances(),
            tolerance: options.tolerance,
        };
        let of_judged = methods.iter().zip(traces).find(|(_, trace)| trace.method == self.judged).map(judge);
        let verdict = SpeedVerdict::new(self.judged, options.tolerance, of_judged.as_ref());
        let named = |excess| ExcessEntry::new(excess, experiment.joint_names());
        let position_excesses: Vec<_> = experiment.position_excesses().iter().map(named).collect();
        Ok(SpeedSummary {
            scenario: options.name.clone(),
            description: options.description.clone(),
            robot: options.robot.clone(),
            verdict: verdict.under_position_limits(&position_excesses),
            methods,
            optimum,
            optimum_speed_only: speed_only,
            optimum_effort: None,
            scaled_limits: Vec::new(),
            model_error: Vec::new(),
            limit_ratio_bound: experiment.control().limit_ratio_bound(path),
            spare_joints: experiment.spare_joints(),
            position_excesses,
            disturbances: Some(experiment.disturbances().clone()).filter(|d| !d.are_none()),
            left_out: experiment.left_out().map(|(methods, reason)| LeftOut { methods, reason }),
            look_ahead: Vec::new(),
        })
    }

    /// The optimum under the speed limits alone, where the path limits more.
    fn under_speed_limits_alone(
        &self,
        whole: &Result<WholeOptimum, NoWhole>,
    ) -> Result<Option<OptimumEntry>, CompareError> {
        if !self.path.pieces.iter().any(|piece| self.path.limits_acceleration(piece)) {
            return Ok(None);
        }
        let (path, finer) = (self.path.under_speed_limits_alone(), self.finer.under_speed_limits_alone());
        let names = self.experiment.joint_names();
        let whole = match whole {
            Ok(whole) => whole.under_speed_limits_alone(self.options.whole()),
            Err(why) => Err(why.clone()),
        };
        let grid = SolvedGrid::new([&path, &finer], None, self.options.solver)
            .map_err(|error| no_optimum(error, &path, names))?;
        Ok(Some(OptimumEntry::new(&Solved { whole, grid }, self.path.speed_limited_time(), names)))
    }
}
