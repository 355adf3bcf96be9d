use super::disturbances::Surroundings;
use super::problem::{ConditioningProblem, MarginChoice};
use super::trace::{ConditionedSample, ConditionedTrace, MAX_CONSTRAINTS, PathMethod, Phase};
use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{
    Constraint, ConstraintSample, Margin, Motion, PathForm, PathOutcome, PathSettings, PathState, PathStep, TrapPhase,
    Walk,
};
use slideway_path::ProblemError;

/// How far past the end of the reference a sample still counts as at it, s: half a nanosecond covers the rounding of summed
/// sampling periods.
pub const CLOCK_ROUNDING: f64 = 5e-10;

/// Samples after which a run is given up.
const MAX_SAMPLES: usize = 5_000_000;

/// Runs one of the conditioner's forms.
///
/// Every sample stands one whole sampling period after the one before, with the reference as far on as its pace takes it: the
/// last is the last one at which the reference has not passed its end. Where the end falls between two samples,
/// [`ConditionedTrace::finish_s`] is interpolated; there is no sample beyond the end, where the reference need not be
/// defined, nor one at it, where the filters would have moved on by a whole period and the reference by a part of it.
///
/// # Errors
///
/// Parameters that the conditioner refuses.
pub fn run_conditioner(problem: &ConditioningProblem, method: PathMethod) -> Result<ConditionedTrace, ProblemError> {
    match problem.constraints.len() {
        1 => run::<1>(problem, method),
        2 => run::<2>(problem, method),
        3 => run::<3>(problem, method),
        4 => run::<4>(problem, method),
        5 => run::<5>(problem, method),
        6 => run::<6>(problem, method),
        7 => run::<7>(problem, method),
        _ => run::<8>(problem, method),
    }
}

/// Checks the parameters of one of the conditioner's forms without running it.
///
/// # Errors
///
/// Parameters that the conditioner refuses: those that [`run_conditioner`] would report.
pub fn check_conditioner(problem: &ConditioningProblem, method: PathMethod) -> Result<(), ProblemError> {
    match problem.constraints.len() {
        1 => conditioner::<1>(problem, method).map(drop),
        2 => conditioner::<2>(problem, method).map(drop),
        3 => conditioner::<3>(problem, method).map(drop),
        4 => conditioner::<4>(problem, method).map(drop),
        5 => conditioner::<5>(problem, method).map(drop),
        6 => conditioner::<6>(problem, method).map(drop),
        7 => conditioner::<7>(problem, method).map(drop),
        _ => conditioner::<8>(problem, method).map(drop),
    }
}

impl ConditioningProblem {
    /// Evaluates the first `M` constraints at a motion.
    #[must_use]
    pub fn sample<const M: usize>(&self, motion: &Motion<3>) -> [ConstraintSample<3>; M] {
        std::array::from_fn(|i| self.constraints[i].sample(motion))
    }

    /// Approach times of the first `M` constraints, s.
    #[must_use]
    pub fn approach<const M: usize>(&self) -> [f64; M] {
        std::array::from_fn(|i| self.constraints[i].approach)
    }

    fn settings<const M: usize>(&self, method: PathMethod) -> PathSettings<M> {
        let form = match method {
            PathMethod::SlidingModePaper => PathForm::Appendix { law: self.law },
            PathMethod::SlidingModeImplicit => PathForm::Implicit { recovery_rate: self.recovery_rate },
            _ => PathForm::Sliding { law: self.law, reserve: self.reserve },
        };
        let explicit = matches!(form, PathForm::Sliding { .. });
        let margin = match &self.margin {
            MarginChoice::None => Margin::None,
            MarginChoice::Band if method == PathMethod::SlidingMode => Margin::Band,
            MarginChoice::Band => Margin::None,
            MarginChoice::Fixed(margins) => Margin::Fixed(std::array::from_fn(|i| margins[i])),
        };
        // The safe walk belongs to the explicit form, which refuses it without a reserve; the other forms walk as published.
        let trap = self.trap.map(|trap| {
            if explicit { trap } else { slideway_conditioner::path::TrapSettings { walk: Walk::Paper, ..trap } }
        });
        PathSettings {
            sampling_period: self.sampling_period,
            push_cutoff: self.push_cutoff,
            approach: self.approach(),
            margin,
            form,
            trap,
        }
    }
}

fn conditioner<const M: usize>(
    problem: &ConditioningProblem,
    method: PathMethod,
) -> Result<PathConditioner<3, M>, ProblemError> {
    PathConditioner::new(problem.settings(method)).map_err(|error| ProblemError::value("conditioner", error))
}

#[allow(clippy::cast_precision_loss)]
fn run<const M: usize>(problem: &ConditioningProblem, method: PathMethod) -> Result<ConditionedTrace, ProblemError> {
    let conditioner = conditioner::<M>(problem, method)?;
    let mut state = start(problem, &conditioner)?;
    let mut world = Surroundings::<M>::new(&problem.disturbances, problem.sampling_period);
    let mut trace = ConditionedTrace {
        method,
        constraints: problem.constraints.iter().map(|c| c.name.clone()).collect(),
        sampling_period: problem.sampling_period,
        finish_s: None,
        samples: Vec::new(),
    };
    // By how much the true time is ahead of the counted one, s: jitter.
    let (mut clock, mut drift) = (0.0, 0.0);
    let duration = problem.reference.duration();
    while trace.samples.len() < MAX_SAMPLES {
        let t = trace.samples.len() as f64 * problem.sampling_period + drift;
        if t > problem.reference.max_duration() {
            break;
        }
        let reference = problem.reference.at(t, clock, state.pace());
        world.measure();
        let step =
            conditioner.step(&mut state, &reference, |motion| world.seen(problem.sample(&world.seen_at(motion))));
        trace.samples.push(sample(problem, clock, &reference, &step, &world));
        if clock + CLOCK_ROUNDING >= duration {
            trace.finish_s = Some(t);
            break;
        }
        let period = world.period(problem.sampling_period);
        drift += period - problem.sampling_period;
        let next = clock + step.advance * (period / problem.sampling_period);
        if next > duration + CLOCK_ROUNDING {
            let arrival = t + period * (duration - clock) / (next - clock);
            trace.finish_s =
                Some(arrival).filter(|arrival| *arrival <= problem.reference.max_duration() + CLOCK_ROUNDING);
            break;
        }
        clock = next.min(duration);
    }
    Ok(trace)
}

/// On the reference and with its velocity, or at rest where the scenario puts it.
fn start<const M: usize>(
    problem: &ConditioningProblem,
    conditioner: &PathConditioner<3, M>,
) -> Result<PathState<3, M>, ProblemError> {
    let error = problem.disturbances.initial_error;
    if error == [0.0; 3] {
        return Ok(conditioner.on_reference());
    }
    let mut position = problem.reference.at(0.0, 0.0, 1.0).position;
    for (p, e) in position.iter_mut().zip(&error) {
        *p += e;
    }
    conditioner.at_rest(&position).map_err(|refused| ProblemError::value("disturbances.initial_error", refused))
}

fn sample<const M: usize>(
    problem: &ConditioningProblem,
    clock: f64,
    reference: &Motion<3>,
    step: &PathStep<3, M>,
    world: &Surroundings<M>,
) -> ConditionedSample {
    let truth = problem.sample::<M>(&step.motion);
    let (mut sigma, mut phi) = (step.sigma, step.phi);
    if !world.shows_the_truth() {
        let approach = problem.approach::<M>();
        sigma = truth.map(|s| s.value);
        phi = std::array::from_fn(|i| truth[i].phi(approach[i], &step.motion.velocity));
    }
    let gradient = truth.map(|s| s.gradient.iter().map(|g| g * g).sum::<f64>().sqrt());
    ConditionedSample {
        t: reference.time,
        lambda: problem.reference.lambda(clock),
        reference: reference.position,
        position: step.motion.position,
        sigma: pad(&sigma),
        phi: pad(&phi),
        seen_phi: pad(&step.phi),
        share: pad(&step.share),
        gradient: pad(&gradient),
        push: step.push,
        reserve: step.reserve,
        walk: step.walk,
        phase: phase(step.outcome, step.trap),
    }
}

fn phase(outcome: PathOutcome, trap: TrapPhase) -> Phase {
    match (outcome, trap) {
        (PathOutcome::Held(_), _) => Phase::Held,
        (_, TrapPhase::Walking | TrapPhase::Returning | TrapPhase::Blocked) => Phase::Trapped,
        (PathOutcome::Reserve, _) => Phase::Reserve,
        (PathOutcome::Acting, _) => Phase::Acting,
        (PathOutcome::Free, _) => Phase::Free,
    }
}

fn pad<const M: usize>(values: &[f64; M]) -> [f64; MAX_CONSTRAINTS] {
    let mut padded = [0.0; MAX_CONSTRAINTS];
    for (slot, value) in padded.iter_mut().zip(values) {
        *slot = *value;
    }
    padded
}
