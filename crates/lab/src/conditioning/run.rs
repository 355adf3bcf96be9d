use super::disturbances::Surroundings;
use super::problem::{ConditioningProblem, MarginChoice};
use super::trace::{ConditionedSample, ConditionedTrace, MAX_CONSTRAINTS, PathMethod, Phase};
use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{
    Constraint, ConstraintSample, Margin, Motion, PathForm, PathOutcome, PathSettings, PathState, PathStep, TrapPhase,
    Walk,
};
use slideway_path::ProblemError;

/// Time past the end of the reference up to which a sample still counts as at it, s: half a nanosecond covers the rounding of
/// summed sampling periods.
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
    Ok(run_and_settle(problem, method, &mut |_| true)?.0)
}

/// Runs one of the conditioner's forms, then leaves the reference at rest at its end until `arrived` is true of a sample. The trace is
/// that of [`run_conditioner`], without the samples at rest; beside it stands the time from the reference's arrival to the
/// conditioned point's, s: `None` where either never arrived.
///
/// The reference rests for at most [`ConditioningProblem::settling`] seconds, with trap avoidance until its longest duration.
///
/// # Errors
///
/// Parameters that the conditioner refuses.
pub fn run_and_settle(
    problem: &ConditioningProblem,
    method: PathMethod,
    arrived: &mut dyn FnMut(&ConditionedSample) -> bool,
) -> Result<(ConditionedTrace, Option<f64>), ProblemError> {
    match problem.constraints.len() {
        1 => run::<1>(problem, method, arrived),
        2 => run::<2>(problem, method, arrived),
        3 => run::<3>(problem, method, arrived),
        4 => run::<4>(problem, method, arrived),
        5 => run::<5>(problem, method, arrived),
        6 => run::<6>(problem, method, arrived),
        7 => run::<7>(problem, method, arrived),
        _ => run::<8>(problem, method, arrived),
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

/// Time constants for which a conditioned point is given time to settle: `e^-20` is below any resolution.
const SETTLING: f64 = 20.0;

impl ConditioningProblem {
    /// Longest wait of a reference at rest at its end for the conditioned point, s: twenty times the slowest approach and the push
    /// filter's time constant together.
    #[must_use]
    pub fn settling(&self) -> f64 {
        let slowest = self.constraints.iter().map(|c| c.approach).fold(0.0, f64::max);
        SETTLING * (slowest + self.push_cutoff.recip())
    }

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

/// One run under way.
struct Loop<'a, const M: usize> {
    problem: &'a ConditioningProblem,
    conditioner: PathConditioner<3, M>,
    state: PathState<3, M>,
    world: Surroundings<M>,
    /// Time of the reference's own clock, s.
    clock: f64,
    /// By how much the true time is ahead of the counted one, s: jitter.
    drift: f64,
}

impl<const M: usize> Loop<'_, M> {
    /// Time of sample `k`, s.
    #[allow(clippy::cast_precision_loss)]
    fn time(&self, k: usize) -> f64 {
        k as f64 * self.problem.sampling_period + self.drift
    }

    /// One sample at time `t` of a reference that runs at `pace` of its rate; how long its period lasts, s, and by how much the
    /// reference's clock goes on, s.
    fn step(&mut self, t: f64, pace: f64) -> (ConditionedSample, f64, f64) {
        let reference = self.problem.reference.at(t, self.clock, pace);
        self.world.measure();
        let (problem, world) = (self.problem, &self.world);
        let seen = |motion: &Motion<3>| world.seen(problem.sample(&world.seen_at(motion)));
        let step = self.conditioner.step(&mut self.state, &reference, seen);
        let sample = sample(problem, self.clock, &reference, &step, world);
        let period = self.world.period(problem.sampling_period);
        self.drift += period - problem.sampling_period;
        (sample, period, step.advance * (period / problem.sampling_period))
    }

    /// Leaves the reference at its end; how long after `finish` the conditioned point arrived, s.
    fn settle(
        &mut self,
        samples: usize,
        finish: f64,
        arrived: &mut dyn FnMut(&ConditionedSample) -> bool,
    ) -> Option<f64> {
        let most = self.problem.reference.max_duration().max(finish + self.problem.settling());
        let until = if self.problem.trap.is_some() { most } else { finish + self.problem.settling() };
        self.clock = self.problem.reference.duration();
        for k in samples..MAX_SAMPLES {
            let t = self.time(k);
            if t > until {
                break;
            }
            if arrived(&self.step(t, 0.0).0) {
                return Some((t - finish).max(0.0));
            }
        }
        None
    }
}

fn run<const M: usize>(
    problem: &ConditioningProblem,
    method: PathMethod,
    arrived: &mut dyn FnMut(&ConditionedSample) -> bool,
) -> Result<(ConditionedTrace, Option<f64>), ProblemError> {
    let conditioner = conditioner::<M>(problem, method)?;
    let state = start(problem, &conditioner)?;
    let world = Surroundings::<M>::new(&problem.disturbances, problem.sampling_period);
    let mut course = Loop { problem, conditioner, state, world, clock: 0.0, drift: 0.0 };
    let mut trace = ConditionedTrace {
        method,
        constraints: problem.constraints.iter().map(|c| c.name.clone()).collect(),
        sampling_period: problem.sampling_period,
        finish_s: None,
        samples: Vec::new(),
    };
    let duration = problem.reference.duration();
    while trace.samples.len() < MAX_SAMPLES {
        let t = course.time(trace.samples.len());
        if t > problem.reference.max_duration() {
            break;
        }
        let (sample, period, advance) = course.step(t, course.state.pace());
        trace.samples.push(sample);
        if course.clock + CLOCK_ROUNDING >= duration {
            trace.finish_s = Some(t);
            break;
        }
        let next = course.clock + advance;
        if next > duration + CLOCK_ROUNDING {
            let arrival = t + period * (duration - course.clock) / (next - course.clock);
            trace.finish_s =
                Some(arrival).filter(|arrival| *arrival <= problem.reference.max_duration() + CLOCK_ROUNDING);
            break;
        }
        course.clock = next.min(duration);
    }
    let last = trace.samples.last().is_some_and(&mut *arrived);
    let after = trace.finish_s.and_then(|finish| match last {
        true => Some(0.0),
        false => course.settle(trace.samples.len(), finish, arrived),
    });
    Ok((trace, after))
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
