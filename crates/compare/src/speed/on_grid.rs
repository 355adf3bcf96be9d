//! The optimum of the rows at the nodes of a grid.

use serde::Serialize;
use slideway_baselines::time_optimal::{
    OptimumError, Refined, Solver, TimeOptimum, Violation, reachable_profile, refine_optimum_by, refine_profile,
    time_optimum_by,
};
use slideway_path::{LimitKind, SampledPath};

/// The optimum of the rows at the nodes of a grid: of a problem that lies off that of the path by an amount of the first order in the grid.
#[derive(Clone, Debug, Serialize)]
pub struct GridEntry {
    /// Duration of the profile, s.
    pub duration_s: f64,
    /// Certified lower bound of the grid's optimal time, s.
    pub lower_s: f64,
    /// Certified upper bound, s.
    pub upper_s: f64,
    /// `(upper - lower) / lower`.
    pub gap: f64,
    /// True if the gap is small enough for the answer to count.
    pub certified: bool,
    /// Grid points.
    pub grid_points: usize,
    /// The solver that the bounds are from: `structured` or `conic`, or both where pieces differ.
    pub solver: String,
    /// The solver's own word; it decides nothing.
    pub status: String,
    /// Iterations of the solver.
    pub iterations: u32,
    /// Time that solving took, s.
    pub solve_s: f64,
    /// Largest violation of each kind of limit between grid points, as a share of the limit.
    pub between_nodes: BetweenNodes,
    /// Tolerance to which refinement drove the violations between grid points; null without refinement.
    pub inter_sample_tolerance: Option<f64>,
    /// Samples between grid points whose limits refinement added.
    pub refining_samples: usize,
    /// The greedy profile by reachability on the same rows: feasible, not the optimum, hundreds of times faster; null where it was
    /// not found.
    pub reachable_s: Option<f64>,
    /// The optimum on a grid twice as fine.
    pub refined_s: f64,
}

/// Largest violations between grid points, as shares of the limits.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct BetweenNodes {
    /// Joint speed.
    pub joint_speed: f64,
    /// Joint acceleration.
    pub joint_acceleration: f64,
    /// Joint torque.
    pub joint_torque: f64,
    /// Tool speed.
    pub tool_speed: f64,
    /// Tool acceleration.
    pub tool_acceleration: f64,
}

impl From<Violation> for BetweenNodes {
    fn from(violation: Violation) -> Self {
        Self {
            joint_speed: violation.speed,
            joint_acceleration: violation.acceleration,
            joint_torque: violation.torque,
            tool_speed: violation.tool_speed,
            tool_acceleration: violation.tool_acceleration,
        }
    }
}

impl GridEntry {
    /// The time of the greedy profile in words.
    #[must_use]
    pub fn greedy_in_words(&self) -> String {
        self.reachable_s.map_or_else(|| "not found".into(), |time| format!("{time:.6} s"))
    }

    /// The violations between grid points in words.
    #[must_use]
    pub fn between_in_words(&self) -> String {
        let between = &self.between_nodes;
        let kinds = [
            (LimitKind::JointSpeed, between.joint_speed),
            (LimitKind::JointAcceleration, between.joint_acceleration),
            (LimitKind::JointTorque, between.joint_torque),
            (LimitKind::ToolSpeed, between.tool_speed),
            (LimitKind::ToolAcceleration, between.tool_acceleration),
        ];
        let words: Vec<String> =
            kinds.iter().filter(|(_, v)| *v != 0.0).map(|(kind, v)| format!("{kind} {v:.1e}")).collect();
        let found = if words.is_empty() { "none".into() } else { words.join(", ") + " of the limit" };
        match self.inter_sample_tolerance {
            Some(tolerance) => {
                format!("{found} (refined to {tolerance:.0e} with {} samples more)", self.refining_samples)
            }
            None => found,
        }
    }
}

/// A grid's optimum, how it was found, and what it is checked by.
#[derive(Clone, Debug)]
pub(crate) struct SolvedGrid {
    pub(crate) optimum: TimeOptimum,
    inter_sample_tolerance: Option<f64>,
    refining_samples: usize,
    /// Time of the greedy profile, s. It is an extra: the optimum has its own certificate and stands without it.
    reachable_s: Option<f64>,
    /// The optimum on a grid twice as fine, s.
    refined_s: f64,
}

impl SolvedGrid {
    /// Solves on the nodes of a path, and of one twice as fine; with a tolerance, limits are kept between grid points as well.
    pub(crate) fn new(
        [path, finer]: [&SampledPath; 2],
        tolerance: Option<f64>,
        solver: Solver,
    ) -> Result<Self, OptimumError> {
        let (optimum, refining_samples, reachable_s) = match tolerance {
            None => (time_optimum_by(path, solver)?, 0, reachable_profile(path).ok().map(|profile| profile.duration_s)),
            Some(tolerance) => {
                let Refined { result, added, .. } = refine_optimum_by(path, tolerance, solver)?;
                (result, added, refine_profile(path, tolerance).ok().map(|refined| refined.result.duration_s))
            }
        };
        let refined_s = time_optimum_by(finer, solver)?.duration_s;
        Ok(Self { optimum, inter_sample_tolerance: tolerance, refining_samples, reachable_s, refined_s })
    }
}

impl GridEntry {
    pub(crate) fn new(solved: &SolvedGrid) -> Self {
        let optimum = &solved.optimum;
        let distinct = |mut names: Vec<String>| {
            names.sort_unstable();
            names.dedup();
            names.join(", ")
        };
        Self {
            duration_s: optimum.duration_s,
            lower_s: optimum.lower_s,
            upper_s: optimum.upper_s,
            gap: optimum.gap(),
            certified: optimum.is_certified(),
            grid_points: optimum.grid_points,
            solver: distinct(optimum.solvers.iter().map(ToString::to_string).collect()),
            status: distinct(optimum.status.clone()),
            iterations: optimum.iterations,
            solve_s: optimum.solve_s,
            between_nodes: optimum.between.into(),
            inter_sample_tolerance: solved.inter_sample_tolerance,
            refining_samples: solved.refining_samples,
            reachable_s: solved.reachable_s,
            refined_s: solved.refined_s,
        }
    }
}
