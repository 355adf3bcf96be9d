//! Runs of a conditioning scenario, and what they are held against.

use super::draw::{Draw, Ranges};
use super::{Always, Check, Judgement, held_against};
use crate::error::VerifyError;
use crate::options::VerifyOptions;
use crate::statement::{ConditioningCase, Guarantee, Observer, PUSH_ROUNDING, Statement, excess, recovery_rate};
use slideway_conditioner::path::Reserve;
use slideway_lab::conditioning::{
    ConditionedTrace, ConditioningProblem, PathDisturbances, PathMethod, Phase, Shape3, run_conditioner,
};

const RESERVE: Always = Always {
    name: "path-reserve",
    text: "excess of φ, as the conditioner saw it, over its band and over what is left of an earlier excess; none, whatever disturbs it",
    unit: "m",
};
const IMPLICIT: Always = Always {
    name: "path-implicit",
    text: "excess of φ, as the conditioner saw it, over zero and over what is left of an earlier excess; none, whatever disturbs it",
    unit: "m",
};

/// Under jitter the conditioner's velocities are per counted second: `σ` is no lag of the `φ` they give, and constraints that move do so
/// by another clock.
const COUNTED: &str = "period-as-counted";
/// Constraints that move, seen late.
const IN_TIME: &str = "constraints-seen-in-time";
/// A start that the initial error put outside, or above the bound itself.
const START: &str = "start-inside";
/// Noise: its effect on a bound is derived for the bands of `φ` and `σ`, and for the change of `φ` without a reserve, which noise
/// does not enter; not where the reserve answers to noise.
const EXACT: &str = "distances-as-they-are";

/// A conditioning scenario and one form of the conditioner, made ready to be run again and again.
#[derive(Clone, Debug)]
pub(crate) struct PathSubject {
    problem: ConditioningProblem,
    observer: Observer,
    method: PathMethod,
    ranges: Ranges,
    moving: bool,
}

impl PathSubject {
    /// The subject, and what is stated of it.
    pub(crate) fn new(
        problem: ConditioningProblem,
        method: PathMethod,
        options: &VerifyOptions,
    ) -> Result<(Self, Statement), VerifyError> {
        let case = ConditioningCase::new(problem, method)?;
        let mut statement = case.statement()?;
        let ConditioningCase { problem, trace: nominal, .. } = case;
        let subject = Self {
            observer: Observer::for_conditioning(problem.clone()),
            ranges: Ranges::of_conditioning(options, extent(&problem)),
            // A formula may depend on time by itself.
            moving: problem.constraints.iter().any(|c| c.is_carried() || matches!(c.shape, Shape3::Formula(_))),
            problem,
            method,
        };
        let found = subject.always(&nominal, &subject.problem.disturbances);
        let always = [RESERVE, IMPLICIT];
        let stated = found.iter().filter_map(|c| always.iter().find(|a| a.name == c.guarantee).map(|a| a.guarantee(c)));
        statement.guarantees.extend(stated.collect::<Vec<_>>());
        Ok((subject, statement))
    }

    pub(crate) fn draw(&self, seed: u64, number: u64) -> Draw {
        Draw::new(seed, number, &self.ranges)
    }

    /// The run of a trial.
    pub(crate) fn run(&self, disturbances: &PathDisturbances) -> Result<ConditionedTrace, VerifyError> {
        disturbances.check()?;
        let problem = ConditioningProblem { disturbances: *disturbances, ..self.problem.clone() };
        Ok(run_conditioner(&problem, self.method)?)
    }

    /// Runs the subject under disturbances and holds the run against a statement.
    ///
    /// Noise of at most `n` on `σ` shifts what the conditioner sees of `φ` by at most `n`: where it keeps `φ <= D̄` of what it sees, the
    /// truth keeps `D̄ + n`. For the explicit form that is so because it pushes wherever the truth exceeds `n`, and below that one sample
    /// adds at most `D̄`. By the lag `σ` keeps what `φ` does. From a start outside what is seen falls, but it may be seen `n` too high
    /// at first and `n` too low afterwards: the truth keeps the start's `φ + 2n`.
    pub(crate) fn judge(
        &self,
        disturbances: &PathDisturbances,
        statement: &Statement,
    ) -> Result<Judgement, VerifyError> {
        let trace = self.run(disturbances)?;
        let observed = self.observer.conditioning(&trace);
        let mut outside = statement.outside(&observed);
        let noise = disturbances.distance_noise;
        let start = self.start(&trace);
        let mut allowed = statement.clone();
        for guarantee in allowed.guarantees.iter_mut().filter(|g| is_band(g)) {
            guarantee.upper.iter_mut().for_each(|upper| *upper += if start > 0.0 { 2.0 * noise } else { noise });
        }
        let measured = |guarantee: &Guarantee| observed.guarantee(&guarantee.name);
        let leave = |guarantee: &Guarantee| self.loses(guarantee, disturbances, start);
        let mut checks = held_against(&allowed, &mut outside, measured, leave);
        let stated = |check: &Check| statement.guarantees.iter().any(|g| g.name == check.guarantee);
        checks.extend(self.always(&trace, disturbances).into_iter().filter(stated));
        Ok(Judgement { outside, checks })
    }

    /// Name of an assumption of a guarantee that the disturbances break, if any. `start` is the largest of `σ` and `φ` at the first sample.
    fn loses(&self, guarantee: &Guarantee, disturbances: &PathDisturbances, start: f64) -> Option<&'static str> {
        if guarantee.name == "recovery" {
            // It is about what was seen, in counted samples, from outside.
            return (self.moving && disturbances.delay > 0).then_some(IN_TIME);
        }
        let moved = disturbances.initial_error != [0.0; 3];
        let above = is_band(guarantee) && guarantee.upper.is_some_and(|upper| start > upper);
        if moved && (start > 0.0 || above) {
            return Some(START);
        }
        if self.moving && disturbances.delay > 0 {
            return Some(IN_TIME);
        }
        if disturbances.jitter > 0.0 && (self.moving || guarantee.claim == "path-lag") {
            return Some(COUNTED);
        }
        let reserve = self.problem.reserve != Reserve::Off;
        let derived = is_band(guarantee) || (guarantee.unit == "m" && !reserve);
        (disturbances.distance_noise > 0.0 && !derived).then_some(EXACT)
    }

    fn start(&self, trace: &ConditionedTrace) -> f64 {
        let Some(first) = trace.samples.first() else { return f64::INFINITY };
        let both = (0..self.problem.constraints.len()).map(|i| first.sigma[i].max(first.phi[i]));
        both.fold(f64::NEG_INFINITY, |a, b| if b.is_nan() { f64::INFINITY } else { a.max(b) })
    }

    /// Checks of the bound that holds whatever disturbs the loop: `e[k+1] <= max(0, e[k] - ρ T)` for the excess `e` of what was seen over
    /// its band, from the first sample on and again after every sample that was held.
    fn always(&self, trace: &ConditionedTrace, disturbances: &PathDisturbances) -> Vec<Check> {
        // The band follows from the gradient, which the trace has as it is and not as it was seen.
        let late = self.moving && disturbances.delay > 0;
        let implicit = self.method == PathMethod::SlidingModeImplicit;
        let Some(rate) = recovery_rate(&self.problem, self.method).filter(|_| implicit || !late) else {
            return Vec::new();
        };
        let always = if implicit { IMPLICIT } else { RESERVE };
        let fall = rate * self.problem.sampling_period;
        let mut worst = 0.0_f64;
        for i in 0..self.problem.constraints.len() {
            let mut beyond = f64::INFINITY;
            for sample in &trace.samples {
                if sample.phase == Phase::Held {
                    beyond = f64::INFINITY;
                    continue;
                }
                let left = (beyond - fall).max(0.0);
                beyond = excess(&self.problem, self.method, i, sample);
                let more = beyond - left;
                worst = if more.is_nan() { f64::INFINITY } else { worst.max(more) };
            }
        }
        vec![Check::at_most(always.name, worst, PUSH_ROUNDING, always.unit)]
    }
}

/// Bounds on `φ` and `σ` themselves, which noise shifts by its size.
fn is_band(guarantee: &Guarantee) -> bool {
    matches!(guarantee.name.as_str(), "phi" | "penetration")
}

/// Diagonal of the box around the reference, m.
fn extent(problem: &ConditioningProblem) -> f64 {
    let reference = &problem.reference;
    let at = |i: u32| {
        let clock = reference.duration() * f64::from(i) / 100.0;
        reference.at(clock, clock, 1.0).position
    };
    let sides = (0..3).map(|axis| {
        let places = || (0..=100).map(|i| at(i)[axis]);
        places().fold(f64::NEG_INFINITY, f64::max) - places().fold(f64::INFINITY, f64::min)
    });
    sides.map(|side| side * side).sum::<f64>().sqrt()
}
