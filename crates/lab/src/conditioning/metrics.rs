use super::problem::ConditioningProblem;
use super::trace::{ConditionedSample, ConditionedTrace, PathMethod, Phase};
use serde::{Deserialize, Serialize};
use slideway_conditioner::path::bounds;

/// Summary of one run. One entry per constraint where a list is given.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PathMethodSummary {
    /// The method.
    pub method: PathMethod,
    /// True if the reference reached its end.
    pub completed: bool,
    /// When it did, s.
    pub duration_s: Option<f64>,
    /// Mean distance from the reference, m.
    pub mean_deviation_m: f64,
    /// Largest distance from the reference, m.
    pub max_deviation_m: f64,
    /// Mean distance from the projection of the reference onto the allowed set, m; null where it was not computed.
    pub mean_distance_to_projection_m: Option<f64>,
    /// Largest distance from that projection, m.
    pub max_distance_to_projection_m: Option<f64>,
    /// Mean distance from the path of the QP safety filter, sample by sample, m; null where the clocks differ.
    pub mean_distance_to_qp_m: Option<f64>,
    /// Largest distance from that path, m.
    pub max_distance_to_qp_m: Option<f64>,
    /// Largest `σ_i`.
    pub max_sigma_m: Vec<f64>,
    /// Largest `φ_i`; null for methods without a velocity.
    pub max_phi_m: Vec<Option<f64>>,
    /// Clearance left unused, `-max σ_i`; negative where the constraint was broken.
    pub clearance_m: Vec<f64>,
    /// Time from first to last contact of each stretch in which the constraint acted, summed, s.
    pub active_s: Vec<f64>,
    /// The stretches themselves.
    pub active_intervals: Vec<Vec<Contact>>,
    /// Time in which all constraints acted at once, s.
    pub all_active_s: f64,
    /// Time from the last contact until the reference is followed within 1 mm again, s.
    pub return_s: Option<f64>,
    /// Time for which a trap stopped the reference, s; null if it never did, or if the run ended in the trap.
    pub escape_s: Option<f64>,
    /// Chattering of `φ` while a constraint acts.
    pub chattering: Option<PathChattering>,
    /// The audit.
    pub audit: ContactSummary,
}

/// A stretch of time in which a constraint acted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Contact {
    /// First sample, s.
    pub from_s: f64,
    /// Last sample, s.
    pub to_s: f64,
}

/// Chattering of the worst constraint.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PathChattering {
    /// Largest change of `φ` over one sample while the constraint acts.
    pub measured: f64,
    /// Rigorous: a full push plus the largest drift of one sample without a push.
    pub bound: f64,
    /// The paper's estimate `T α1² K ‖u‖ ‖∇σ‖`, `[G12] eq 22`.
    pub paper_estimate: f64,
}

/// The audit: how often what acted. The filter is never bypassed: every sample is one of these.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ContactSummary {
    /// Samples in all.
    pub samples: usize,
    /// Share of samples in which each constraint acted.
    pub acting_share: Vec<f64>,
    /// Share of samples in which the reserve acted.
    pub reserve_share: f64,
    /// Share of samples in which the reference was held.
    pub held_share: f64,
    /// Share of samples in which a trap stopped the reference.
    pub trapped_share: f64,
}

/// Contacts this far apart belong to one stretch, s: a constraint that slides acts in every few samples.
const SAME_CONTACT: f64 = 0.1;

impl PathMethodSummary {
    /// Summarises a trace; `projection` and `qp` are the traces to measure distances from.
    #[must_use]
    pub fn new(
        problem: &ConditioningProblem,
        trace: &ConditionedTrace,
        projection: Option<&ConditionedTrace>,
        qp: Option<&ConditionedTrace>,
    ) -> Self {
        let count = trace.constraints.len();
        let deviations: Vec<f64> = trace.samples.iter().map(ConditionedSample::deviation).collect();
        let contacts: Vec<Vec<Contact>> = (0..count).map(|i| contacts(trace, i)).collect();
        let to_projection = projection.and_then(|p| distances(trace, p));
        let to_qp = qp.and_then(|q| distances(trace, q));
        let max_sigma_m: Vec<f64> = (0..count).map(|i| largest(trace, |s| s.sigma[i])).collect();
        Self {
            method: trace.method,
            completed: trace.finish_s.is_some(),
            duration_s: trace.finish_s,
            mean_deviation_m: mean(&deviations),
            max_deviation_m: deviations.iter().copied().fold(0.0, f64::max),
            mean_distance_to_projection_m: to_projection.as_deref().map(mean),
            max_distance_to_projection_m: to_projection.as_deref().map(|d| d.iter().copied().fold(0.0, f64::max)),
            mean_distance_to_qp_m: to_qp.as_deref().map(mean),
            max_distance_to_qp_m: to_qp.as_deref().map(|d| d.iter().copied().fold(0.0, f64::max)),
            clearance_m: max_sigma_m.iter().map(|s| -s).collect(),
            max_sigma_m,
            max_phi_m: (0..count).map(|i| Some(largest(trace, |s| s.phi[i])).filter(|p| p.is_finite())).collect(),
            active_s: contacts.iter().map(|c| c.iter().map(|c| c.to_s - c.from_s).sum()).collect(),
            all_active_s: all_active(&contacts),
            return_s: return_time(trace, &contacts),
            active_intervals: contacts,
            escape_s: escape_time(trace),
            chattering: trace.method.is_conditioner().then(|| chattering(problem, trace)),
            audit: audit(trace),
        }
    }
}

/// Distances between two traces sample by sample; `None` if their references do not run alike.
#[must_use]
pub fn distances(a: &ConditionedTrace, b: &ConditionedTrace) -> Option<Vec<f64>> {
    if a.samples.len() != b.samples.len() {
        return None;
    }
    let apart = |x: &[f64; 3], y: &[f64; 3]| x.iter().zip(y).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt();
    a.samples
        .iter()
        .zip(&b.samples)
        .map(|(a, b)| ((a.lambda - b.lambda).abs() < 1e-9).then(|| apart(&a.position, &b.position)))
        .collect()
}

#[allow(clippy::cast_precision_loss)]
fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

fn largest(trace: &ConditionedTrace, value: impl Fn(&ConditionedSample) -> f64) -> f64 {
    trace.samples.iter().map(value).fold(f64::NEG_INFINITY, f64::max)
}

/// Stretches in which constraint `i` acted.
fn contacts(trace: &ConditionedTrace, i: usize) -> Vec<Contact> {
    let mut contacts: Vec<Contact> = Vec::new();
    for sample in trace.samples.iter().filter(|s| s.share[i] > 0.0) {
        match contacts.last_mut() {
            Some(last) if sample.t - last.to_s <= SAME_CONTACT => last.to_s = sample.t,
            _ => contacts.push(Contact { from_s: sample.t, to_s: sample.t }),
        }
    }
    contacts
}

/// Time in which every constraint is within one of its stretches.
fn all_active(contacts: &[Vec<Contact>]) -> f64 {
    let mut common: Vec<Contact> = contacts.first().cloned().unwrap_or_default();
    for other in &contacts[1.min(contacts.len())..] {
        let overlap = |a: &Contact, b: &Contact| {
            let (from_s, to_s) = (a.from_s.max(b.from_s), a.to_s.min(b.to_s));
            (from_s < to_s).then_some(Contact { from_s, to_s })
        };
        common = common.iter().flat_map(|a| other.iter().filter_map(move |b| overlap(a, b))).collect();
    }
    common.iter().map(|c| c.to_s - c.from_s).sum()
}

fn return_time(trace: &ConditionedTrace, contacts: &[Vec<Contact>]) -> Option<f64> {
    let last = contacts.iter().flatten().map(|c| c.to_s).fold(f64::NEG_INFINITY, f64::max);
    let back = trace.samples.iter().find(|s| s.t > last && s.deviation() < 1e-3)?;
    last.is_finite().then_some(back.t - last)
}

#[allow(clippy::cast_precision_loss)]
fn escape_time(trace: &ConditionedTrace) -> Option<f64> {
    let trapped = trace.samples.iter().filter(|s| s.phase == Phase::Trapped).count();
    (trapped > 0 && trace.finish_s.is_some()).then_some(trapped as f64 * trace.sampling_period)
}

/// Change of `φ` per sample while a constraint acts; the drift is measured between samples without a push.
fn chattering(problem: &ConditioningProblem, trace: &ConditionedTrace) -> PathChattering {
    let (period, cutoff) = (trace.sampling_period, problem.push_cutoff);
    let mut worst = PathChattering { measured: 0.0, bound: 0.0, paper_estimate: 0.0 };
    for (i, constraint) in problem.constraints.iter().enumerate() {
        let acts = |s: &ConditionedSample| s.share[i] > 0.0 && s.phase != Phase::Held;
        let mut drift = 0.0_f64;
        for pair in trace.samples.windows(2) {
            let change = pair[1].phi[i] - pair[0].phi[i];
            if !change.is_finite() {
                continue;
            }
            // Upwards `φ` goes by its drift alone: the push of an acting constraint only ever lowers it.
            drift = drift.max(if pair[1].phi[i] > -0.01 { change } else { 0.0 });
            if acts(&pair[0]) || acts(&pair[1]) {
                worst.measured = worst.measured.max(change.abs());
            }
            if acts(&pair[0]) {
                // The implicit form's push belongs to the past interval, the explicit ones' to the coming one.
                let push = norm(&pair[0].push).max(norm(&pair[1].push));
                let estimate =
                    bounds::chattering_estimate(period, cutoff, constraint.approach, push, pair[0].gradient[i]);
                worst.paper_estimate = worst.paper_estimate.max(estimate);
            }
        }
        worst.bound = worst.bound.max(drift + worst.paper_estimate * full_push(period, constraint.approach));
    }
    worst
}

/// Full push of one sample on `φ = σ + K σ̇`, relative to the paper's `T α1² K ‖u‖ ‖∇σ‖`: the position's share adds at most
/// `T / (2 K)` to it (`½ T² α1²` against `T α1² K`).
fn full_push(period: f64, approach: f64) -> f64 {
    1.0 + 0.5 * period / approach
}

fn norm(vector: &[f64; 3]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[allow(clippy::cast_precision_loss)]
fn audit(trace: &ConditionedTrace) -> ContactSummary {
    let samples = trace.samples.len();
    let share = |predicate: &dyn Fn(&ConditionedSample) -> bool| {
        trace.samples.iter().filter(|s| predicate(s)).count() as f64 / samples.max(1) as f64
    };
    ContactSummary {
        samples,
        acting_share: (0..trace.constraints.len()).map(|i| share(&|s| s.share[i] > 0.0)).collect(),
        reserve_share: share(&|s| s.phase == Phase::Reserve),
        held_share: share(&|s| s.phase == Phase::Held),
        trapped_share: share(&|s| s.phase == Phase::Trapped),
    }
}
