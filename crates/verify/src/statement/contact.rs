//! Signals of one run of the path conditioner beside its constraints.

use super::recovery::{full_push, margin};
use slideway_conditioner::path::{Constraint, Motion, Reserve, bounds};
use slideway_lab::conditioning::{ConditionedSample, ConditionedTrace, ConditioningProblem, PathMethod, Phase};

/// Suprema over the samples and constraints of a run. Lengths in m, of `φ` unless said otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ContactSignals {
    /// Largest drift over push at acting samples: above 1 the push does not win. Infinite where the push that constraints share drives
    /// one of them outwards.
    pub(crate) push_share: f64,
    /// Largest rise from a sample at which the constraint does not act, near to acting.
    pub(crate) rise: f64,
    /// Largest fall by drift alone at acting samples.
    pub(crate) fall: f64,
    /// Largest full push of a sample: the one given, with a reserve the longest that the law can give, which is its band.
    pub(crate) push: f64,
    /// Largest rise between two samples.
    pub(crate) bulge: f64,
    /// Smallest margin that is added to `φ`.
    pub(crate) margin: f64,
    /// Share of samples held.
    pub(crate) held: f64,
    /// Share of samples that the reserve answered.
    pub(crate) reserve: f64,
    /// Largest `σ` and `φ` at the first sample.
    pub(crate) start: f64,
}

/// One constraint over one sample.
struct Step {
    /// Drift: the change of `φ` without the push.
    drift: f64,
    /// The push on `φ`, positive inwards.
    push: f64,
    /// The longest push, whatever its direction.
    full: f64,
    acts: bool,
    change: f64,
    /// `φ` plus margin: the constraint acts from 0 on.
    excess: f64,
    /// Length of what was pushed, the reserve included.
    given: f64,
    /// Neither this sample nor the next one was answered by anything but push and drift.
    plain: bool,
    /// Both were served at all.
    served: bool,
}

impl ContactSignals {
    pub(crate) fn of(problem: &ConditioningProblem, trace: &ConditionedTrace) -> Self {
        let mut signals = Self {
            push_share: 0.0,
            rise: 0.0,
            fall: 0.0,
            push: 0.0,
            bulge: 0.0,
            margin: narrowest(problem, trace),
            held: share_of(trace, |s| s.phase == Phase::Held),
            reserve: share_of(trace, |s| s.reserve != [0.0; 3]),
            start: trace.samples.first().map_or(0.0, |s| start(s, problem.constraints.len())),
        };
        for index in 0..problem.constraints.len() {
            let steps: Vec<Step> =
                trace.samples.windows(2).map(|pair| step(problem, trace.method, index, pair)).collect();
            signals.take(problem, index, &steps);
        }
        signals
    }

    fn take(&mut self, problem: &ConditioningProblem, index: usize, steps: &[Step]) {
        let reach = steps.iter().filter(|s| s.acts).map(|s| s.full).fold(0.0, f64::max);
        self.push = larger(self.push, reach);
        // Near to acting: within two full pushes of it, or two rises like this one, so that none is missed that ends inside the band.
        let near = |s: &Step| !(s.excess < -2.0 * reach.max(s.given).max(s.change));
        for s in steps.iter().filter(|s| s.plain) {
            if s.acts {
                self.push_share = larger(self.push_share, s.share());
                self.fall = larger(self.fall, -s.drift);
            } else if near(s) {
                self.rise = larger(self.rise, s.change);
            }
        }
        // What the push itself bends within a sample: the filter's own curvature, √2 α, and the approach's, 1 / K.
        let (period, approach) = (problem.sampling_period, problem.constraints[index].approach);
        let bending = period * (std::f64::consts::SQRT_2 * problem.push_cutoff + 1.0 / approach);
        for pair in steps.windows(2).filter(|pair| pair[0].served && pair[1].served && near(&pair[0])) {
            let bent = bending * reach.max(pair[0].given).max(pair[1].given);
            let second = (pair[1].drift - pair[0].drift).abs();
            self.bulge = larger(self.bulge, bounds::between_samples(1.0, second + bent));
        }
    }
}

impl Step {
    /// Drift over the push against it.
    fn share(&self) -> f64 {
        match self.push > 0.0 {
            true => self.drift / self.push,
            false if self.change <= 0.0 => 0.0,
            false => f64::INFINITY,
        }
    }
}

#[allow(clippy::cast_precision_loss)]
fn share_of(trace: &ConditionedTrace, is: impl Fn(&ConditionedSample) -> bool) -> f64 {
    trace.samples.iter().filter(|s| is(s)).count() as f64 / trace.samples.len().max(1) as f64
}

fn larger(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::INFINITY } else { a.max(b) }
}

fn start(sample: &ConditionedSample, constraints: usize) -> f64 {
    let both = (0..constraints).map(|i| sample.sigma[i].max(sample.phi[i]));
    both.fold(f64::NEG_INFINITY, f64::max)
}

/// The smallest margin anywhere, of constraints that do not act too: their `φ` stays below their own margins.
fn narrowest(problem: &ConditioningProblem, trace: &ConditionedTrace) -> f64 {
    let of = |index: usize| trace.samples.iter().map(move |s| margin(problem, trace.method, index, s));
    (0..problem.constraints.len()).flat_map(of).fold(f64::INFINITY, f64::min)
}

fn step(problem: &ConditioningProblem, method: PathMethod, index: usize, pair: &[ConditionedSample]) -> Step {
    let [now, next] = [&pair[0], &pair[1]];
    let constraint = &problem.constraints[index];
    let still = Motion { time: now.t, position: now.position, velocity: [0.0; 3] };
    let gradient = constraint.sample(&still).gradient;
    let per_push = bounds::push_per_sample(problem.sampling_period, problem.push_cutoff, constraint.approach);
    // The implicit form records the push of the interval that ends at the sample.
    let taken = if method == PathMethod::SlidingModeImplicit { &next.push } else { &now.push };
    let whole: [f64; 3] = std::array::from_fn(|axis| taken[axis] + next.reserve[axis]);
    let on = |push: &[f64; 3]| -per_push * gradient.iter().zip(push).map(|(g, u)| g * u).sum::<f64>();
    let length = |v: &[f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let change = next.phi[index] - now.phi[index];
    let push = on(taken);
    let given = per_push * length(&gradient) * length(taken);
    let reserve = method == PathMethod::SlidingMode && problem.reserve != Reserve::Off;
    let held = |s: &ConditionedSample| s.phase == Phase::Held;
    // A sample of a trap may be answered by the reserve as well.
    let answered = |s: &ConditionedSample| held(s) || s.reserve != [0.0; 3];
    Step {
        drift: change + on(&whole),
        push,
        full: if reserve { full_push(problem, index, now) } else { given },
        acts: now.share[index] > 0.0,
        change,
        excess: now.phi[index] + margin(problem, method, index, now),
        given: per_push * length(&gradient) * length(&whole),
        plain: !answered(now) && !answered(next),
        served: !held(now) && !held(next),
    }
}
