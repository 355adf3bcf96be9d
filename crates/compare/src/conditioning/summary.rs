use crate::conditioning::arrival::Arrival;
use crate::conditioning::convergence::Convergence;
use crate::rivals::ProjectedTrace;
use crate::words::{decimals, fixed};
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
    pub methods: Vec<PathMethodEntry>,
    /// Disturbances of the runs of the conditioner's forms; null where nothing did.
    pub disturbances: Option<PathDisturbances>,
    /// The projection; `None` where the allowed set is empty somewhere.
    pub projection: Option<ProjectionEntry>,
    /// Distance of the sliding mode from the QP path against the sampling period; empty with trap avoidance.
    pub convergence: Vec<Convergence>,
    /// The verdict.
    pub verdict: ConditioningVerdict,
}

/// One method: its run, and where it came to rest.
#[derive(Clone, Debug, Serialize)]
pub struct PathMethodEntry {
    /// Numbers of its run.
    #[serde(flatten)]
    pub summary: PathMethodSummary,
    /// Where it came to rest.
    #[serde(flatten)]
    pub arrival: Arrival,
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

/// A verdict on conditioning: the sliding mode kept every constraint, was never held, and came to rest where the reference's end
/// projects to.
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
    pub(crate) fn new(methods: &[PathMethodEntry], constraints: &[String], tolerance: Option<f64>) -> Self {
        let method = PathMethod::JUDGED;
        let find = |wanted: PathMethod| methods.iter().find(|m| m.summary.method == wanted);
        let Some(PathMethodEntry { summary: entry, arrival }) = find(method) else {
            let sentence = "No: the sliding mode was not run.".into();
            return Self { method, ratio: None, tolerance, holds: false, sentence };
        };
        let least = find(PathMethod::Projection).map(|p| p.summary.mean_deviation_m);
        // Where a trap stopped the reference the two ran by different clocks.
        let comparable = |least: &f64| *least > 0.0 && entry.mean_distance_to_projection_m.is_some();
        let ratio = least.filter(comparable).map(|least| entry.mean_deviation_m / least);
        let kept = worst(&entry.max_sigma_m).is_some_and(|(_, sigma)| sigma <= 0.0);
        let near = ratio.zip(tolerance).is_none_or(|(ratio, tolerance)| ratio <= 1.0 + tolerance);
        let arrived = entry.completed && arrival.arrives_after_s.is_some();
        let holds = kept && arrived && entry.audit.held_share == 0.0 && near;
        let mut sentence = String::from(if holds { "Yes: " } else { "No: " });
        sentence += &constraints_in_words(entry, constraints);
        if let (Some(ratio), Some(least)) = (ratio, least) {
            let (least, ratio) = (decimals(1e3 * least, 2), decimals(ratio, 2));
            sentence += &format!("; no method can be nearer than {least} mm, the projection ({ratio} times that)");
        }
        if let (false, Some(tolerance)) = (near, tolerance) {
            let [excess, allowed] = fixed([100.0 * (ratio.unwrap_or(f64::NAN) - 1.0), 100.0 * tolerance], 2);
            sentence += &format!("; that is {excess} % more, and the tolerance is {allowed} %");
        }
        sentence += &arrival_in_words(entry, arrival);
        if entry.audit.held_share > 0.0 {
            sentence += &format!("; it was held for {} % of the samples", decimals(100.0 * entry.audit.held_share, 2));
        }
        Self { method, ratio, tolerance, holds, sentence: sentence + "." }
    }
}

/// Words on the constraints: kept or broken, and by how much.
fn constraints_in_words(entry: &PathMethodSummary, constraints: &[String]) -> String {
    match worst(&entry.max_sigma_m) {
        Some((_, sigma)) if sigma <= 0.0 => format!(
            "the sliding mode kept every constraint with {} mm to spare and stayed within {} mm of the reference on average",
            decimals(-1e3 * sigma, 3),
            decimals(1e3 * entry.mean_deviation_m, 2)
        ),
        Some((i, sigma)) => format!("the sliding mode broke `{}` by {} mm", constraints[i], decimals(1e3 * sigma, 3)),
        None => "the constraints have no finite value".into(),
    }
}

/// Words on the arrival of reference and point, if and when, and on the cost of a trap.
fn arrival_in_words(entry: &PathMethodSummary, arrival: &Arrival) -> String {
    let trapped = arrival.trapped_s;
    let mut words = match (entry.completed, arrival.arrives_after_s, arrival.end_distance_m) {
        (false, ..) => "; the reference did not reach its end".into(),
        (true, Some(after), _) if after > 0.0 => {
            format!("; its point arrived {} s after the reference", decimals(after, 2))
        }
        (true, Some(_), _) => String::new(),
        (true, None, Some(distance)) => {
            format!(
                "; its point never arrived: it ended {} mm from the nearest allowed point to the reference's end",
                decimals(1e3 * distance, 1)
            )
        }
        (true, None, None) => "; no allowed point was found for the reference's end".into(),
    };
    match entry.escape_s {
        Some(escape) => words += &format!("; a trap stopped the reference for {} s", decimals(escape, 2)),
        None if trapped > 0.0 => words += &format!("; a trap held the point for {} s", decimals(trapped, 2)),
        None => {}
    }
    words
}

/// The constraint with the largest value; `None` if one is not finite.
fn worst(sigma: &[f64]) -> Option<(usize, f64)> {
    if sigma.iter().any(|s| !s.is_finite()) {
        return None;
    }
    sigma.iter().copied().enumerate().max_by(|a, b| a.1.total_cmp(&b.1))
}
