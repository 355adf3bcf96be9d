use crate::error::CompareError;
use crate::progress::{Stage, Steps};
use crate::rivals::qp_filter_trace;
use serde::Serialize;
use slideway_lab::conditioning::{ConditioningProblem, PathMethod, distances, run_conditioner};

/// Distance of the sliding mode from the QP path at one sampling period.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Convergence {
    /// Sampling period, s.
    pub period_s: f64,
    /// Mean distance, m.
    pub mean_distance_m: f64,
    /// Largest distance, m.
    pub max_distance_m: f64,
}

/// Samples beyond which a run is left out: seconds of computing.
const MOST_SAMPLES: f64 = 500_000.0;

/// The distance at ever shorter sampling periods. Empty with trap avoidance, where the two run by different clocks.
///
/// # Errors
///
/// Parameters that the conditioner refuses.
#[allow(clippy::cast_precision_loss)]
pub(crate) fn convergence(
    problem: &ConditioningProblem,
    divisors: &[f64],
    steps: &mut Steps<'_, '_>,
) -> Result<Vec<Convergence>, CompareError> {
    let mut points = Vec::new();
    if problem.trap.is_some() {
        return Ok(points);
    }
    for divisor in divisors {
        let period_s = problem.sampling_period / divisor;
        if problem.reference.duration() / period_s > MOST_SAMPLES {
            break;
        }
        steps.at(Stage::ShorterPeriods)?;
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
