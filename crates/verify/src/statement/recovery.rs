//! Excess of `φ` over its band, and the way back from outside.

use super::Guarantee;
use super::conditioning::ConditioningCase;
use super::entry::up_to;
use crate::error::VerifyError;
use slideway_conditioner::path::{Constraint, Motion, Reserve, SwitchingLaw, bounds};
use slideway_lab::conditioning::{
    ConditionedSample, ConditionedTrace, ConditioningProblem, MarginChoice, PathDisturbances, PathMethod,
    run_conditioner,
};

/// Distance outside a boundary from which the recovery is stated, m.
const OUTSIDE: f64 = 0.01;

/// Rest of a violated limit after the smallest push: 1e-12 of positions and velocities of up to 10, as in the claims, m.
pub(crate) const PUSH_ROUNDING: f64 = 1e-11;

/// Steps of Newton's method to a place at a distance from a boundary; shapes whose `σ` is a length take one or two.
const NEWTON_STEPS: usize = 50;

/// Rate at which `φ` is brought back to its band, m/s; `None` for a form that does not promise to.
pub(crate) fn recovery_rate(problem: &ConditioningProblem, method: PathMethod) -> Option<f64> {
    match (method, problem.reserve) {
        (PathMethod::SlidingModeImplicit, _) => Some(problem.recovery_rate),
        (PathMethod::SlidingMode, Reserve::On { recovery_rate }) => Some(recovery_rate),
        _ => None,
    }
}

/// `e_i`: `φ_i` plus margin, as the conditioner saw it, less the band that it is kept in: none in the implicit form, one full push in the
/// explicit one.
pub(crate) fn excess(
    problem: &ConditioningProblem,
    method: PathMethod,
    index: usize,
    sample: &ConditionedSample,
) -> f64 {
    let implicit = method == PathMethod::SlidingModeImplicit;
    let band = if implicit { 0.0 } else { full_push(problem, index, sample) };
    sample.seen_phi[index] + (margin(problem, method, index, sample) - band)
}

/// The margin that the method adds to `φ_i` at a sample; that of the band is one full push, and the explicit form's alone.
pub(super) fn margin(
    problem: &ConditioningProblem,
    method: PathMethod,
    index: usize,
    sample: &ConditionedSample,
) -> f64 {
    match &problem.margin {
        MarginChoice::Fixed(margins) => margins[index],
        MarginChoice::Band if method == PathMethod::SlidingMode => full_push(problem, index, sample),
        MarginChoice::Band | MarginChoice::None => 0.0,
    }
}

/// `G_i`: what the longest push of one sample that the law can give takes off `φ_i`, whichever constraints act.
pub(super) fn full_push(problem: &ConditioningProblem, index: usize, sample: &ConditionedSample) -> f64 {
    let cutoff = problem.push_cutoff;
    let constraints = problem.constraints.iter();
    let longest = match problem.law {
        SwitchingLaw::Normalised { amplitude } => amplitude,
        SwitchingLaw::Sum { gain } => {
            constraints.zip(&sample.gradient).map(|(c, g)| gain * cutoff * cutoff * c.approach * g).sum()
        }
    };
    let approach = problem.constraints[index].approach;
    bounds::push_per_sample(problem.sampling_period, cutoff, approach) * longest * sample.gradient[index]
}

/// Counted time after which every constraint stays in its band, s. `None` for a run that starts inside every band, or farther outside
/// than the statement is for, and of a form that does not promise to come back.
#[allow(clippy::cast_precision_loss)]
pub(crate) fn recovered(problem: &ConditioningProblem, trace: &ConditionedTrace) -> Option<f64> {
    recovery_rate(problem, trace.method)?;
    let above = |sample: &ConditionedSample| {
        let all = (0..problem.constraints.len()).map(|index| excess(problem, trace.method, index, sample));
        all.fold(f64::NEG_INFINITY, |a, b| if b.is_nan() { f64::INFINITY } else { a.max(b) })
    };
    let start = above(trace.samples.first()?);
    if !(start > PUSH_ROUNDING && start <= farthest(problem)) {
        return None;
    }
    let last = trace.samples.iter().rposition(|sample| above(sample) > PUSH_ROUNDING)?;
    Some((last + 1) as f64 * problem.sampling_period)
}

/// The largest `e_i` of a start at rest [`OUTSIDE`], m.
fn farthest(problem: &ConditioningProblem) -> f64 {
    match &problem.margin {
        MarginChoice::Fixed(margins) => OUTSIDE + margins.iter().copied().fold(0.0, f64::max),
        MarginChoice::None | MarginChoice::Band => OUTSIDE,
    }
}

impl ConditioningCase {
    /// The excess falls by `ρ T` a sample, so that the start's is gone after `⌈e / ρT⌉` of them.
    pub(super) fn recovery(&self) -> Result<Option<Guarantee>, VerifyError> {
        let Some(rate) = recovery_rate(&self.problem, self.method) else { return Ok(None) };
        let text = format!(
            "from φ of at most {:.0} mm (a start at rest as far outside) until every φ is back in its band; σ follows with the approach time",
            1e3 * OUTSIDE
        );
        let claim = if self.method == PathMethod::SlidingModeImplicit { "path-implicit" } else { "path-reserve" };
        // A quotient next to a whole number may be rounded up: a part in 1e9 is more than that.
        let time = (farthest(&self.problem) / rate) * (1.0 + 1e-9) + self.problem.sampling_period;
        let guarantee = up_to("recovery", claim, &text, "s", time, &["held"]);
        Ok(Some(Guarantee { measured: self.recovered()?, ..guarantee }))
    }

    /// The longest way back over runs that start outside, one behind each boundary. `None` where no boundary has such a place next to the
    /// reference's start, or samples were held.
    fn recovered(&self) -> Result<Option<f64>, VerifyError> {
        let mut times: Vec<f64> = recovered(&self.problem, &self.trace).into_iter().collect();
        for index in 0..self.problem.constraints.len() {
            let Some(initial_error) = beyond(&self.problem, index) else { continue };
            let disturbances = PathDisturbances { initial_error, ..PathDisturbances::default() };
            let problem = ConditioningProblem { disturbances, ..self.problem.clone() };
            let trace = run_conditioner(&problem, self.method)?;
            if !super::conditioning::any_held(&trace) {
                times.extend(recovered(&problem, &trace));
            }
        }
        Ok(times.into_iter().reduce(f64::max))
    }
}

/// From the reference's start to a place [`OUTSIDE`] behind the boundary of a constraint, along its gradients.
fn beyond(problem: &ConditioningProblem, index: usize) -> Option<[f64; 3]> {
    let start = problem.reference.at(0.0, 0.0, 1.0);
    let mut place = Motion { velocity: [0.0; 3], ..start };
    // A part in a million short of it, so that what is left of the search does not lead beyond.
    let wanted = (1.0 - 1e-6) * OUTSIDE;
    for _ in 0..NEWTON_STEPS {
        let sample = problem.constraints[index].sample(&place);
        let missing = wanted - sample.value;
        if missing.abs() <= 1e-7 * OUTSIDE {
            return Some(std::array::from_fn(|axis| place.position[axis] - start.position[axis]));
        }
        let square: f64 = sample.gradient.iter().map(|g| g * g).sum();
        for (p, g) in place.position.iter_mut().zip(&sample.gradient) {
            *p += missing / square * g;
        }
    }
    None
}
