use crate::speed::on_grid::{GridEntry, SolvedGrid};
use crate::speed::whole::{CertifiedFor, NoWhole, WholeOptimum, WorstCell, stop_in_words};
use serde::Serialize;
use slideway_baselines::path_bracket::PathBracket;
use slideway_lab::{Effort, Experiment, LimitUse, MethodSummary, Trace};
use slideway_path::{Likeness, PositionExcess, PositionSource, ProblemError, SplineDeviation};

/// A method's summary and what it means beside the optimum.
#[derive(Clone, Debug, Serialize)]
pub struct MethodEntry {
    /// Its numbers without the optimum.
    #[serde(flatten)]
    pub summary: MethodSummary,
    /// From the start of motion to the robot's arrival.
    pub travel_s: Option<f64>,
    /// `travel_s` over the optimum's duration.
    pub ratio: Option<f64>,
    /// `travel_s` over the optimum's upper and lower bound: the ratio lies between them.
    pub ratio_range: Option<[f64; 2]>,
    /// From the start of motion to the reference's end, over the optimum's duration. Below 1 the robot trails.
    pub reference_ratio: Option<f64>,
    /// The largest share of a joint-speed limit that a command used, catching up at the path's end included.
    pub command_use: f64,
    /// The largest use of each kind of limit that the scenario gives, besides constant joint-speed limits.
    pub limit_use: Vec<LimitUse>,
    /// Mean speed over the optimum's, `1 / ratio`.
    pub relative_speed: Option<f64>,
    /// Cost for the drives once under way.
    pub effort: Option<Effort>,
    /// Knowledge that the method has in advance.
    pub knows: &'static str,
}

/// The optimum that the methods are compared with, without its profile: of the whole path where that can be bracketed, else of the grid.
#[derive(Clone, Debug, Serialize)]
pub struct OptimumEntry {
    /// Time that the best known profile takes, s: the upper bound.
    pub duration_s: f64,
    /// Certified lower bound of the optimal time, s.
    pub lower_s: f64,
    /// Certified upper bound, s.
    pub upper_s: f64,
    /// `(upper - lower) / lower`.
    pub gap: f64,
    /// True if the gap is the one asked for.
    pub certified: bool,
    /// What the bounds hold for.
    pub certified_for: CertifiedFor,
    /// Why they do not hold for the whole path; null where they do.
    pub nodes_because: Option<String>,
    /// Largest deviation of the spline from the joint path that it stands for; null where the path itself is bracketed.
    pub spline: Option<SplineDeviation>,
    /// Cells of the bracket; null on the grid.
    pub cells: Option<usize>,
    /// Why their refinement ended; null on the grid.
    pub stop: Option<&'static str>,
    /// Cells that hold most of the gap, largest first; empty on the grid.
    pub worst_cells: Vec<WorstCell>,
    /// The solver: `structured` or `conic`, or both where pieces of a grid differ.
    pub solver: String,
    /// Time that it took, s.
    pub solve_s: f64,
    /// The optimum of the rows at the nodes of a grid on the same path.
    pub on_grid: GridEntry,
    /// Closed form under speed limits alone: the integral of the slowest joint's need, on a finer grid.
    pub closed_form_speed_s: f64,
}

impl OptimumEntry {
    /// The optimum in words, for a sentence that goes on with a method's distance from it.
    pub(crate) fn in_words(&self, duration: &str) -> String {
        let is = if self.certified {
            format!("is {duration} s")
        } else {
            format!("lies between {:.6} and {:.6} s", self.lower_s, self.upper_s)
        };
        match self.certified_for {
            CertifiedFor::Path | CertifiedFor::Spline => format!("certified optimum, knowing the whole path, {is}"),
            CertifiedFor::Nodes => {
                format!("optimum, certified at {} nodes and knowing the whole path, {is}", self.on_grid.grid_points)
            }
        }
    }
}

/// Both optima of a path: of the whole of it, or why not, and of a grid.
#[derive(Clone, Debug)]
pub(crate) struct Solved {
    pub(crate) whole: Result<WholeOptimum, NoWhole>,
    pub(crate) grid: SolvedGrid,
}

impl MethodEntry {
    pub(crate) fn new(experiment: &Experiment, trace: &Trace, optimum: &OptimumEntry) -> Result<Self, ProblemError> {
        let summary = MethodSummary::new(trace);
        let travel_s = summary.travel_s();
        let reference = summary.duration_s.zip(summary.motion_start_s).map(|(end, start)| end - start);
        Ok(Self {
            travel_s,
            ratio: travel_s.map(|t| t / optimum.duration_s),
            ratio_range: travel_s.map(|t| [t / optimum.upper_s, t / optimum.lower_s]),
            reference_ratio: reference.map(|t| t / optimum.duration_s),
            command_use: experiment.command_use(trace)?,
            limit_use: experiment.limit_use(trace),
            relative_speed: travel_s.map(|t| optimum.duration_s / t),
            effort: experiment.course(trace).effort(),
            knows: summary.method.knows(),
            summary,
        })
    }
}

impl OptimumEntry {
    pub(crate) fn new(solved: &Solved, closed_form_speed_s: f64, joint_names: &[String]) -> Self {
        let on_grid = GridEntry::new(&solved.grid);
        let grid = Self {
            duration_s: on_grid.upper_s,
            lower_s: on_grid.lower_s,
            upper_s: on_grid.upper_s,
            gap: on_grid.gap,
            certified: on_grid.certified,
            certified_for: CertifiedFor::Nodes,
            nodes_because: None,
            spline: None,
            cells: None,
            stop: None,
            worst_cells: Vec::new(),
            solver: on_grid.solver.clone(),
            solve_s: on_grid.solve_s,
            on_grid,
            closed_form_speed_s,
        };
        match &solved.whole {
            Err(why) => Self { nodes_because: Some(why.to_string()), ..grid },
            Ok(whole) => grid.of_whole(whole, joint_names),
        }
    }

    fn of_whole(self, whole: &WholeOptimum, joint_names: &[String]) -> Self {
        let PathBracket { lower_s, upper_s, gap, certified, cells, stop, .. } = whole.bracket;
        let polynomials = &whole.path.polynomials;
        let spline = match polynomials.likeness() {
            Likeness::Same => None,
            Likeness::Spline(deviation) => Some(deviation),
        };
        Self {
            duration_s: upper_s,
            lower_s,
            upper_s,
            gap,
            certified,
            certified_for: whole.certified_for(),
            spline,
            cells: Some(cells),
            stop: Some(stop_in_words(stop)),
            worst_cells: whole.worst_cells(joint_names),
            solver: whole.solver.to_string(),
            solve_s: whole.solve_s,
            ..self
        }
    }
}

/// A joint that leaves its range along the path.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExcessEntry {
    /// Name of the joint.
    pub joint: String,
    /// Path parameter where it is farthest outside.
    pub lambda: f64,
    /// Its position there, rad (m).
    pub position: f64,
    /// Lower end of its range.
    pub lower: f64,
    /// Upper end of its range.
    pub upper: f64,
    /// Who gave the range.
    pub source: PositionSource,
}

impl ExcessEntry {
    /// An excess of a joint by its name.
    pub(crate) fn new(excess: &PositionExcess, joint_names: &[String]) -> Self {
        let PositionExcess { joint, lambda, position, lower, upper, source } = *excess;
        Self { joint: joint_names[joint].clone(), lambda, position, lower, upper, source }
    }

    pub(crate) fn in_words(&self) -> String {
        let Self { joint, lambda, position, lower, upper, .. } = self;
        format!(
            "joint `{joint}` is at {position:.4} at path parameter {lambda:.4}, outside its range [{lower:.4}, {upper:.4}]"
        )
    }
}
