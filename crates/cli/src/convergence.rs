use serde::Serialize;
use slideway_baselines::rivals::qp_filter_trace;
use slideway_figures::ConvergencePoint;
use slideway_lab::conditioning::{ConditioningProblem, PathMethod, distances, run_conditioner};
use slideway_path::ProblemError;

/// Distance of the sliding mode from the QP path at one sampling period.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Convergence {
    /// Sampling period, s.
    pub(crate) period_s: f64,
    /// Mean distance, m.
    pub(crate) mean_distance_m: f64,
    /// Largest distance, m.
    pub(crate) max_distance_m: f64,
}

impl Convergence {
    /// As the figure wants it.
    pub(crate) fn point(&self) -> ConvergencePoint {
        ConvergencePoint {
            period_s: self.period_s,
            mean_distance_m: self.mean_distance_m,
            max_distance_m: self.max_distance_m,
        }
    }
}

/// By how much the sampling period is shortened.
const DIVISORS: [f64; 5] = [1.0, 2.0, 5.0, 10.0, 20.0];

/// Samples beyond which a run is left out: seconds of computing.
const MOST_SAMPLES: f64 = 500_000.0;

/// The distance at ever shorter sampling periods. Empty with trap avoidance, where the two run by different clocks.
///
/// # Errors
///
/// Parameters that the conditioner refuses.
#[allow(clippy::cast_precision_loss)]
pub(crate) fn convergence(problem: &ConditioningProblem) -> Result<Vec<Convergence>, ProblemError> {
    let mut points = Vec::new();
    if problem.trap.is_some() {
        return Ok(points);
    }
    for divisor in DIVISORS {
        let period_s = problem.sampling_period / divisor;
        if problem.reference.duration() / period_s > MOST_SAMPLES {
            break;
        }
        let problem = ConditioningProblem { sampling_period: period_s, ..problem.clone() };
        let sliding = run_conditioner(&problem, PathMethod::SlidingMode)?;
        if let Some(apart) = distances(&sliding, &qp_filter_trace(&problem)) {
            points.push(Convergence {
                period_s,
                mean_distance_m: apart.iter().sum::<f64>() / apart.len().max(1) as f64,
                max_distance_m: apart.iter().copied().fold(0.0, f64::max),
            });
        }
    }
    Ok(points)
}
