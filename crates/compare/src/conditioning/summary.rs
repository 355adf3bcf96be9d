use crate::conditioning::convergence::Convergence;
use crate::rivals::ProjectedTrace;
use serde::Serialize;
use slideway_lab::conditioning::{PathDisturbances, PathMethod, PathMethodSummary};

/// A comparison of path conditioners in numbers and words. Times in s, lengths in m.
#[derive(Clone, Debug, Serialize)]
pub struct ConditioningSummary {
    /// Name of the scenario.
    pub scenario: String,
    /// Its description.
    pub description: String,
    /// Names of the constraints, in the order of the lists below.
    pub constraints: Vec<String>,
    /// One entry per method.
    pub methods: Vec<PathMethodSummary>,
    /// Disturbances of the runs of the conditioner's forms; null where nothing did.
    pub disturbances: Option<PathDisturbances>,
    /// The projection; `None` where the allowed set is empty somewhere.
    pub projection: Option<ProjectionEntry>,
    /// Distance of the sliding mode from the QP path against the sampling period; empty with trap avoidance.
    pub convergence: Vec<Convergence>,
    /// The verdict.
    pub verdict: ConditioningVerdict,
}

/// The projection: how it was found, and how good it is.
#[derive(Clone, Debug, Serialize)]
pub struct ProjectionEntry {
    /// In words.
    pub kind: &'static str,
    /// Largest distance less its lower bound, m; for several starts, the last step of the descents.
    pub worst_gap_m: f64,
}

impl ProjectionEntry {
    pub(crate) fn new(projected: &ProjectedTrace) -> Self {
        Self { kind: projected.kind.describe(), worst_gap_m: projected.worst_gap }
    }
}

/// A verdict on conditioning: did the sliding mode keep its promise?
#[derive(Clone, Debug, Serialize)]
pub struct ConditioningVerdict {
    /// The method judged.
    pub method: PathMethod,
    /// Mean deviation over that of the projection, the least possible; null without a projection.
    pub ratio: Option<f64>,
    /// By how much the ratio may exceed 1, if a limit was asked for.
    pub tolerance: Option<f64>,
    /// True if it holds.
    pub holds: bool,
    /// The verdict in words.
    pub sentence: String,
}

impl ConditioningVerdict {
    pub(crate) fn new(methods: &[PathMethodSummary], constraints: &[String], tolerance: Option<f64>) -> Self {
        let method = PathMethod::JUDGED;
        let find = |wanted: PathMethod| methods.iter().find(|m| m.method == wanted);
        let Some(entry) = find(method) else {
            let sentence = "No: the sliding mode was not run.".into();
            return Self { method, ratio: None, tolerance, holds: false, sentence };
        };
        let ratio = find(PathMethod::Projection)
            // Where a trap stopped the reference the two ran by different clocks.
            .filter(|p| p.mean_deviation_m > 0.0 && entry.mean_distance_to_projection_m.is_some())
            .map(|p| entry.mean_deviation_m / p.mean_deviation_m);
        let worst = worst(&entry.max_sigma_m);
        let kept = worst.is_some_and(|(_, sigma)| sigma <= 0.0);
        let near = match (ratio, tolerance) {
            (Some(ratio), Some(tolerance)) => ratio <= 1.0 + tolerance,
            _ => true,
        };
        let holds = kept && entry.completed && entry.audit.held_share == 0.0 && near;
        let mut sentence = if holds { String::from("Yes: ") } else { String::from("No: ") };
        sentence += &match worst {
            Some((_, sigma)) if sigma <= 0.0 => format!(
                "the sliding mode kept every constraint with {:.3} mm to spare and stayed within {:.2} mm of the reference on \
                 average",
                -1e3 * sigma,
                1e3 * entry.mean_deviation_m
            ),
            Some((i, sigma)) => format!("the sliding mode broke `{}` by {:.3} mm", constraints[i], 1e3 * sigma),
            None => "the constraints have no finite value".into(),
        };
        if let (Some(ratio), Some(projection)) = (ratio, find(PathMethod::Projection)) {
            sentence += &format!(
                "; no method can be nearer than {:.2} mm, the projection ({:.2} times that)",
                1e3 * projection.mean_deviation_m,
                ratio
            );
        }
        if !entry.completed {
            sentence += "; the reference did not reach its end";
        }
        if entry.audit.held_share > 0.0 {
            sentence += &format!("; it was held for {:.2} % of the samples", 100.0 * entry.audit.held_share);
        }
        if let Some(escape) = entry.escape_s {
            sentence += &format!("; a trap stopped the reference for {escape:.2} s");
        }
        Self { method, ratio, tolerance, holds, sentence: sentence + "." }
    }
}

/// The constraint with the largest value; `None` if one is not finite.
fn worst(sigma: &[f64]) -> Option<(usize, f64)> {
    if sigma.iter().any(|s| !s.is_finite()) {
        return None;
    }
    sigma.iter().copied().enumerate().max_by(|a, b| a.1.total_cmp(&b.1))
}
