use crate::verdict::Verdict;
use crate::windows::WindowEntry;
use serde::Serialize;
use slideway_baselines::time_optimal::TimeOptimum;
use slideway_lab::{MethodSummary, Trace};

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
    /// Proven bound on the largest use of a speed limit on the path without tracking error; null where its hypotheses fail.
    pub(crate) limit_ratio_bound: Option<f64>,
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
    /// Largest use of a joint-acceleration limit while the reference moves; null without such limits.
    pub(crate) acceleration_ratio: Option<f64>,
    /// What the method knows in advance.
    pub(crate) knows: &'static str,
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
    /// What the solver said; it decides nothing.
    pub(crate) status: String,
    pub(crate) iterations: u32,
    pub(crate) solve_s: f64,
    /// Largest violation of a speed limit between grid points, as a share of the limit.
    pub(crate) between_nodes_speed: f64,
    /// Largest violation of an acceleration limit between grid points, as a share of the limit.
    pub(crate) between_nodes_acceleration: f64,
    /// Closed form under speed limits alone: the integral of the slowest joint's need, on a finer grid.
    pub(crate) closed_form_speed_s: f64,
    /// The optimum on a grid twice as fine.
    pub(crate) refined_s: f64,
}

impl MethodEntry {
    pub(crate) fn new(trace: &Trace, optimum: &OptimumEntry, acceleration: Option<&[f64]>) -> Self {
        let summary = MethodSummary::new(trace);
        let travel_s = summary.travel_s();
        let reference = summary.duration_s.zip(summary.motion_start_s).map(|(end, start)| end - start);
        Self {
            travel_s,
            ratio: travel_s.map(|t| t / optimum.duration_s),
            ratio_range: travel_s.map(|t| [t / optimum.upper_s, t / optimum.lower_s]),
            reference_ratio: reference.map(|t| t / optimum.duration_s),
            acceleration_ratio: acceleration.map(|limits| {
                let uses = summary.peak_acceleration.iter().zip(limits).map(|(peak, limit)| peak / limit);
                uses.fold(0.0, f64::max)
            }),
            knows: summary.method.knows(),
            summary,
        }
    }
}

impl OptimumEntry {
    pub(crate) fn new(optimum: &TimeOptimum, closed_form_speed_s: f64, refined_s: f64) -> Self {
        let mut status: Vec<&str> = optimum.status.iter().map(String::as_str).collect();
        status.sort_unstable();
        status.dedup();
        Self {
            duration_s: optimum.duration_s,
            lower_s: optimum.lower_s,
            upper_s: optimum.upper_s,
            gap: optimum.gap(),
            certified: optimum.is_certified(),
            grid_points: optimum.grid_points,
            status: status.join(", "),
            iterations: optimum.iterations,
            solve_s: optimum.solve_s,
            between_nodes_speed: optimum.between.speed,
            between_nodes_acceleration: optimum.between.acceleration,
            closed_form_speed_s,
            refined_s,
        }
    }
}
