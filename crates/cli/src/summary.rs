use crate::laws::{ModelErrorEntry, ScaledLimits};
use crate::verdict::Verdict;
use crate::windows::WindowEntry;
use serde::Serialize;
use slideway_baselines::time_optimal::{
    OptimumError, Refined, TimeOptimum, Violation, reachable_profile, refine_optimum, refine_profile, time_optimum,
};
use slideway_lab::{
    Disturbances, Effort, Experiment, LabError, LimitKind, LimitUse, MethodSummary, PositionExcess, SampledPath, Trace,
};

/// What `summary.json` holds. Times in s, lengths in m, angles in rad.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Summary {
    /// Name of the scenario.
    pub(crate) scenario: String,
    /// Its description.
    pub(crate) description: String,
    /// One entry per method.
    pub(crate) methods: Vec<MethodEntry>,
    /// The optimum under all limits the scenario gives.
    pub(crate) optimum: OptimumEntry,
    /// The optimum under the speed limits alone, where the scenario limits accelerations too.
    pub(crate) optimum_speed_only: Option<OptimumEntry>,
    /// What the optimum costs the drives.
    pub(crate) optimum_effort: Option<Effort>,
    /// Mean speeds under other joint-speed limits; empty unless the scenario has a `[natural]` table.
    pub(crate) scaled_limits: Vec<ScaledLimits>,
    /// What a controller with wrong masses does to each law; empty unless the scenario has a `[natural]` table and the robot masses.
    pub(crate) model_error: Vec<ModelErrorEntry>,
    /// Proven bound on the largest use of a speed limit on the path without tracking error; null where its hypotheses fail.
    pub(crate) limit_ratio_bound: Option<f64>,
    /// Joints beyond the tool coordinates of the path, moved as little as the path allows (pseudo-inverse).
    pub(crate) spare_joints: usize,
    /// Joints that leave their position ranges along the path.
    pub(crate) position_excesses: Vec<PositionExcess>,
    /// What disturbed the methods' runs; null where nothing did. The optimum is that of the undisturbed problem.
    pub(crate) disturbances: Option<Disturbances>,
    /// The look-ahead with windows of several lengths; empty without acceleration limits.
    pub(crate) look_ahead: Vec<WindowEntry>,
    /// The verdict.
    pub(crate) verdict: Verdict,
}

/// A method's summary and what it means beside the optimum.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct MethodEntry {
    #[serde(flatten)]
    pub(crate) summary: MethodSummary,
    /// From the start of motion to the robot's arrival.
    pub(crate) travel_s: Option<f64>,
    /// `travel_s` over the optimum's duration.
    pub(crate) ratio: Option<f64>,
    /// `travel_s` over the optimum's upper and lower bound: the ratio lies between them.
    pub(crate) ratio_range: Option<[f64; 2]>,
    /// From the start of motion to the reference's end, over the optimum's duration. Below 1 the robot trails.
    pub(crate) reference_ratio: Option<f64>,
    /// The largest share of a joint-speed limit that a command used, catching up at the path's end included.
    pub(crate) command_use: f64,
    /// The largest use of each kind of limit that the scenario gives, besides constant joint-speed limits.
    pub(crate) limit_use: Vec<LimitUse>,
    /// Mean speed over the optimum's, `1 / ratio`.
    pub(crate) relative_speed: Option<f64>,
    /// What it costs the drives once under way.
    pub(crate) effort: Option<Effort>,
    /// What the method knows in advance.
    pub(crate) knows: &'static str,
}

/// What a run used of the limits.
#[derive(Clone, Debug)]
pub(crate) struct Uses {
    /// See [`MethodEntry::command_use`].
    pub(crate) command_use: f64,
    /// See [`MethodEntry::limit_use`].
    pub(crate) limit_use: Vec<LimitUse>,
}

impl Uses {
    pub(crate) fn new(experiment: &Experiment, trace: &Trace) -> Result<Self, LabError> {
        Ok(Self { command_use: experiment.command_use(trace)?, limit_use: experiment.limit_use(trace) })
    }
}

/// A certified optimum, without its profile.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct OptimumEntry {
    pub(crate) duration_s: f64,
    pub(crate) lower_s: f64,
    pub(crate) upper_s: f64,
    /// `(upper - lower) / lower`.
    pub(crate) gap: f64,
    /// Whether the gap is small enough for the answer to count.
    pub(crate) certified: bool,
    pub(crate) grid_points: usize,
    /// The solver whose answer the bounds are from: `structured` or `conic`, or both where pieces differ.
    pub(crate) solver: String,
    /// What it said; it decides nothing.
    pub(crate) status: String,
    pub(crate) iterations: u32,
    pub(crate) solve_s: f64,
    /// Largest violation of each kind of limit between grid points, as a share of the limit.
    pub(crate) between_nodes: BetweenNodes,
    /// Tolerance to which refinement drove the violations between grid points; null without refinement.
    pub(crate) inter_sample_tolerance: Option<f64>,
    /// Samples between grid points whose limits refinement added.
    pub(crate) refining_samples: usize,
    /// The greedy profile by reachability on the same rows: feasible, not the optimum, hundreds of times faster; null where it was
    /// not found.
    pub(crate) reachable_s: Option<f64>,
    /// Closed form under speed limits alone: the integral of the slowest joint's need, on a finer grid.
    pub(crate) closed_form_speed_s: f64,
    /// The optimum on a grid twice as fine.
    pub(crate) refined_s: f64,
}

/// Largest violations between grid points, as shares of the limits.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct BetweenNodes {
    pub(crate) joint_speed: f64,
    pub(crate) joint_acceleration: f64,
    pub(crate) joint_torque: f64,
    pub(crate) tool_speed: f64,
    pub(crate) tool_acceleration: f64,
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

impl Summary {
    /// Remarks on the joint path and the runs, in words.
    pub(crate) fn notes(&self) -> Vec<String> {
        let spare = (self.spare_joints > 0).then(|| {
            format!(
                "{} more than the path prescribes: of all joint motions the smallest is taken (pseudo-inverse), by every method and \
                 by the joint path of the optimum",
                if self.spare_joints == 1 { "one joint".into() } else { format!("{} joints", self.spare_joints) }
            )
        });
        let outside = |excess| format!("{}; ranges of joints are reported, not enforced", excess_in_words(excess));
        let disturbed = self.disturbances.as_ref().map(|d| format!("the runs are disturbed: {d}; the optimum is not"));
        spare.into_iter().chain(self.position_excesses.iter().map(outside)).chain(disturbed).collect()
    }
}

/// A joint that leaves its range, in words.
pub(crate) fn excess_in_words(excess: &PositionExcess) -> String {
    let PositionExcess { joint, lambda, position, lower, upper, .. } = excess;
    format!(
        "joint {} is at {position:.4} at path parameter {lambda:.4}, outside its range [{lower:.4}, {upper:.4}]",
        joint + 1
    )
}

impl OptimumEntry {
    /// The time of the greedy profile in words.
    pub(crate) fn greedy_in_words(&self) -> String {
        self.reachable_s.map_or_else(|| "not found".into(), |time| format!("{time:.6} s"))
    }

    /// The violations between grid points in words.
    pub(crate) fn between_in_words(&self) -> String {
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

/// How an optimum was found, and what it is checked by.
#[derive(Clone, Debug)]
pub(crate) struct Solved {
    pub(crate) optimum: TimeOptimum,
    pub(crate) inter_sample_tolerance: Option<f64>,
    pub(crate) refining_samples: usize,
    /// Time of the greedy profile, s. It is an extra: the optimum has its own certificate and stands without it.
    pub(crate) reachable_s: Option<f64>,
    /// The optimum on a grid twice as fine, s.
    pub(crate) refined_s: f64,
}

impl Solved {
    /// Solves on a path, and on one twice as fine; with a tolerance, limits are kept between grid points as well.
    pub(crate) fn new(path: &SampledPath, finer: &SampledPath, tolerance: Option<f64>) -> Result<Self, OptimumError> {
        let Some(tolerance) = tolerance else {
            let optimum = time_optimum(path)?;
            let reachable_s = reachable_profile(path).ok().map(|profile| profile.duration_s);
            let refined_s = time_optimum(finer)?.duration_s;
            return Ok(Self { optimum, inter_sample_tolerance: None, refining_samples: 0, reachable_s, refined_s });
        };
        let Refined { result: optimum, added, .. } = refine_optimum(path, tolerance)?;
        let reachable_s = refine_profile(path, tolerance).ok().map(|refined| refined.result.duration_s);
        let refined_s = time_optimum(finer)?.duration_s;
        Ok(Self { optimum, inter_sample_tolerance: Some(tolerance), refining_samples: added, reachable_s, refined_s })
    }
}

impl MethodEntry {
    pub(crate) fn new(trace: &Trace, uses: Uses, effort: Option<Effort>, optimum: &OptimumEntry) -> Self {
        let Uses { command_use, limit_use } = uses;
        let summary = MethodSummary::new(trace);
        let travel_s = summary.travel_s();
        let reference = summary.duration_s.zip(summary.motion_start_s).map(|(end, start)| end - start);
        Self {
            travel_s,
            ratio: travel_s.map(|t| t / optimum.duration_s),
            ratio_range: travel_s.map(|t| [t / optimum.upper_s, t / optimum.lower_s]),
            reference_ratio: reference.map(|t| t / optimum.duration_s),
            command_use,
            limit_use,
            relative_speed: travel_s.map(|t| optimum.duration_s / t),
            effort,
            knows: summary.method.knows(),
            summary,
        }
    }
}

impl OptimumEntry {
    pub(crate) fn new(solved: &Solved, closed_form_speed_s: f64) -> Self {
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
            closed_form_speed_s,
            refined_s: solved.refined_s,
        }
    }
}
