use crate::rivals::projected_end;
use serde::Serialize;
use slideway_baselines::projection::{Projection, ProjectionError};
use slideway_conditioner::path::bounds::push_per_sample;
use slideway_conditioner::path::{Constraint, Motion, SwitchingLaw};
use slideway_lab::conditioning::{
    ConditionedSample, ConditionedTrace, ConditioningProblem, MarginChoice, PathMethod, Phase,
};

/// Where a conditioned point comes to rest: beside the nearest allowed point to the reference's end. Lengths in m, times in s.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Arrival {
    /// Distance from the nearest allowed point to the reference's end, at the last sample; null if there is none, or if the reference
    /// never reached its end.
    pub end_distance_m: Option<f64>,
    /// Time from the reference's arrival until the point is as near to its end as [`Arrival::resolution_m`] allows, the reference at
    /// rest; null if it never is. Of the conditioner's forms alone.
    pub arrives_after_s: Option<f64>,
    /// Most that the point may be farther from the reference's end than the nearest allowed point and still count as arrived, m.
    pub resolution_m: f64,
    /// Time for which a trap held the point, s: the reference waited for it, or a constraint acted on it away from a reference that is
    /// allowed itself.
    pub trapped_s: f64,
}

/// Share of the reference's extent to which an arrival is resolved.
const RESOLUTION: f64 = 1e-3;

/// Samples at rest between two projections of a moving scene.
const LOOK: usize = 50;

/// The end of a reference and how near to it counts as arrived.
pub(crate) struct Goal<'a> {
    problem: &'a ConditioningProblem,
    end: [f64; 3],
    nearest: Result<Projection<3>, ProjectionError>,
    tolerance: f64,
    looked: usize,
}

impl<'a> Goal<'a> {
    /// The goal of one of the methods.
    pub(crate) fn new(problem: &'a ConditioningProblem, method: PathMethod) -> Self {
        let duration = problem.reference.duration();
        let end = problem.reference.at(duration, duration, 0.0);
        let nearest = projected_end(problem, duration);
        let extent = (0..=100)
            .map(|i| problem.reference.at(0.0, duration * f64::from(i) / 100.0, 0.0).position)
            .fold(0.0, |most: f64, point| most.max(apart(&point, &end.position)));
        let tolerance = RESOLUTION * extent + nearest.as_ref().map_or(0.0, |n| stand_off(problem, method, &end, n));
        Self { problem, end: end.position, nearest, tolerance, looked: 0 }
    }

    /// True of a sample that is as near to the end as any allowed point, to the tolerance.
    pub(crate) fn is_reached_by(&mut self, sample: &ConditionedSample) -> bool {
        let distance = apart(&sample.position, &self.end);
        if distance <= self.tolerance {
            return true;
        }
        // Scenes may move: the projection is that of the sample's instant, seen now and then.
        if self.looked.is_multiple_of(LOOK) {
            self.nearest = projected_end(self.problem, sample.t);
        }
        self.looked += 1;
        self.nearest.as_ref().is_ok_and(|nearest| distance <= nearest.distance + self.tolerance)
    }

    /// The arrival of a run whose point was there `after` seconds after the reference.
    pub(crate) fn arrival(&self, trace: &ConditionedTrace, after: Option<f64>) -> Arrival {
        let last = trace.samples.last().filter(|_| trace.finish_s.is_some());
        let nearest = last.and_then(|last| Some((last, projected_end(self.problem, last.t).ok()?)));
        Arrival {
            end_distance_m: nearest.map(|(last, nearest)| apart(&last.position, &nearest.point)),
            arrives_after_s: after,
            resolution_m: self.tolerance,
            trapped_s: trapped(self.problem, trace, self.tolerance),
        }
    }
}

/// Distance from the nearest allowed point at which the law itself keeps the point, m: its margins, and a full push of one sample, where
/// a constraint is felt at all.
fn stand_off(problem: &ConditioningProblem, method: PathMethod, end: &Motion<3>, nearest: &Projection<3>) -> f64 {
    let at = Motion { position: nearest.point, ..*end };
    let off = problem.constraints.iter().enumerate().filter_map(|(i, constraint)| {
        let sample = constraint.sample(&at);
        let steepness = sample.gradient.iter().map(|g| g * g).sum::<f64>().sqrt();
        let push = match problem.law {
            SwitchingLaw::Normalised { amplitude } => amplitude,
            SwitchingLaw::Sum { gain } => gain * problem.push_cutoff.powi(2) * constraint.approach * steepness,
        };
        let explicit = method != PathMethod::SlidingModeImplicit;
        let band = push * push_per_sample(problem.sampling_period, problem.push_cutoff, constraint.approach);
        let margin = match &problem.margin {
            MarginChoice::Fixed(margins) => margins.get(i).copied().unwrap_or_default() / steepness,
            MarginChoice::None | MarginChoice::Band => 0.0,
        };
        // The band holds the point off twice: as the margin, and as the width in which it chatters.
        let off = margin + if explicit { 2.0 * band } else { 0.0 };
        (sample.value + off * steepness > 0.0).then_some(off)
    });
    off.fold(0.0, f64::max)
}

/// Time for which a trap held the point: the reference waited for it, or a constraint acted on it away from a reference that is allowed
/// itself, `[G12] section 6`.
#[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn trapped(problem: &ConditioningProblem, trace: &ConditionedTrace, tolerance: f64) -> f64 {
    // A constraint that slides acts in every few samples: what acts within an approach is one contact.
    let slowest = problem.constraints.iter().map(|c| c.approach).fold(0.0, f64::max);
    let window = ((slowest / trace.sampling_period).ceil() as usize).max(1);
    let (mut count, mut since) = (0_usize, usize::MAX);
    for sample in &trace.samples {
        let acts = sample.share.iter().any(|share| *share > 0.0);
        since = if acts { 0 } else { since.saturating_add(1) };
        let reference = Motion { time: sample.t, position: sample.reference, velocity: [0.0; 3] };
        let is_allowed = || problem.constraints.iter().all(|c| c.sample(&reference).value <= 0.0);
        let away = since <= window && sample.deviation() > tolerance && is_allowed();
        count += usize::from(sample.phase == Phase::Trapped || away);
    }
    count as f64 * trace.sampling_period
}

fn apart(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}
