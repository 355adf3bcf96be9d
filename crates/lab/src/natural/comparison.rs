use super::follow::{NaturalSample, NaturalTrace, Run};
use super::law::{Ramp, SpeedLaw};
use super::problem::NaturalProblem;
use super::survey::Survey;
use crate::joints::JointUnits;
use crate::joints::MAX_JOINTS;
use crate::joints::pad;
use crate::method::Method;
use crate::problem::Problem;
use crate::run::simulate::MAX_SAMPLES;
use crate::run::trace::{EndRounding, Sample, Trace, has_reached_end};
use slideway_conditioner::AffineSpeed;
use slideway_path::CartesianPath;
use slideway_path::{Fault, ProblemError};
use slideway_robot::EulerAngles;

/// Constant speed and natural motion as methods of a comparison.
///
/// Both know the whole path: a survey finds the largest speed at which no joint exceeds its limit anywhere (times the
/// scenario's `natural.share`), so that they have the peak joint speed that the other methods are allowed. The arm is exactly on
/// the path from its first point on; without a ramp it runs at full speed there, as an optimum with free ends does.
#[derive(Clone, Debug)]
pub(crate) struct NaturalLaws<const N: usize> {
    problem: NaturalProblem<N, CartesianPath>,
    rise: f64,
    share: f64,
}

/// The fastest speeds of both laws, from the survey of a path.
struct Fastest {
    /// Natural motion's `b`, with the sign that goes forward.
    b: f64,
    /// Its duration without ramps, s.
    natural_s: f64,
    /// The constant `q̇*`; 0 where a singularity on the path leaves none.
    path_speed: f64,
}

impl<const N: usize> NaturalLaws<N> {
    /// The laws where a problem asks for them.
    ///
    /// # Errors
    ///
    /// A value that cannot be used; a path of the joints; an arm with more joints than the task has coordinates.
    pub(crate) fn new(problem: &Problem<N>) -> Result<Option<Self>, ProblemError> {
        let Some(settings) = &problem.natural else { return Ok(None) };
        let natural = NaturalProblem::of(&problem.path, settings.factor)?;
        settings.check()?;
        Ok(Some(Self { problem: natural, rise: settings.rise, share: settings.share }))
    }

    /// Runs one of the two laws with the sampling period of the fixed speeds.
    ///
    /// # Errors
    ///
    /// [`ProblemError::NoFiniteSpeed`] where the path turns back at a singularity; a ramp longer than the run.
    #[allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, clippy::cast_sign_loss)]
    pub(crate) fn run(&self, problem: &Problem<N>, method: Method) -> Result<Trace, ProblemError> {
        let length = problem.path.end() - problem.path.begin();
        let fastest = self.fastest(problem, &self.problem.survey(problem.path.end())?)?;
        let (law, seconds) = if method == Method::NaturalMotion {
            (SpeedLaw::Natural { b: fastest.b }, fastest.natural_s)
        } else {
            (SpeedLaw::Constant { path_speed: fastest.path_speed }, length / fastest.path_speed)
        };
        let period = problem.fixed_speed.sampling_period;
        // What the two ramps cost together is the length of one.
        let steps = ((seconds + self.rise) / period).ceil();
        if !(steps <= MAX_SAMPLES as f64) {
            return Ok(standing(problem, method));
        }
        let ramp = Ramp::new(self.rise, seconds + self.rise).map_err(|_| {
            let fault = Fault::OutOfRange { value: self.rise, least: 0.0, most: seconds };
            ProblemError::value("natural.rise", fault)
        })?;
        let run = Run { law, ramp, steps: (steps as usize).max(1) };
        as_trace(problem, method, &run, &self.problem.follow(&run)?)
    }

    /// The largest speeds at which every joint, and the tool where its speed is limited, keeps its limit.
    fn fastest(&self, problem: &Problem<N>, survey: &Survey<N>) -> Result<Fastest, ProblemError> {
        let sign = self.problem.flow(self.problem.start()).direction.path.signum();
        let (mut of_b, mut of_path_speed) = (0.0_f64, 0.0_f64);
        for point in &survey.points {
            let lambda = point.place.parameter;
            let joints = self.problem.flow(&point.place).direction.joints * sign;
            let of_limits = problem.path.speed_limits_at(lambda)?.ratio(&joints.into());
            let tool = problem.path.tool_rate_limit(lambda);
            of_b = of_b.max(of_limits.max(point.factor / tool));
            of_path_speed = of_path_speed.max((of_limits / point.factor).max(1.0 / tool));
        }
        let b = self.share / of_b;
        Ok(Fastest { b: sign * b, natural_s: survey.duration(b), path_speed: self.share / of_path_speed })
    }
}

/// A run that takes longer than any trace can hold: it never moves.
fn standing<const N: usize>(problem: &Problem<N>, method: Method) -> Trace {
    let demand = problem.demand(&problem.path.start, &problem.start_euler, problem.path.begin());
    Trace {
        method,
        joints: N,
        joint_names: problem.joint_names.clone(),
        units: JointUnits::of(&problem.path.arm),
        sampling_period: problem.fixed_speed.sampling_period,
        finish_s: None,
        arrival_s: None,
        samples: vec![Sample {
            t: 0.0,
            lambda: problem.path.begin(),
            path_rate: 0.0,
            factor: 1.0,
            switch: 1.0,
            direction_factor: 1.0,
            limit_ratio: 0.0,
            limiting_joint: None,
            error: demand.error.into(),
            q: pad(&problem.path.start),
            split: AffineSpeed { feedback: [0.0; MAX_JOINTS], feedforward: [0.0; MAX_JOINTS] },
            desired: [0.0; MAX_JOINTS],
            commanded: [0.0; MAX_JOINTS],
            chatter: None,
        }],
    }
}

fn as_trace<const N: usize>(
    problem: &Problem<N>,
    method: Method,
    run: &Run,
    natural: &NaturalTrace<N>,
) -> Result<Trace, ProblemError> {
    let mut trace = Trace { sampling_period: run.step(), samples: Vec::new(), ..standing(problem, method) };
    let mut euler = problem.start_euler;
    let (mut distance, mut lambda) = (f64::INFINITY, problem.path.begin());
    for sample in &natural.samples {
        let (recorded, nearness) = record(problem, sample, &mut euler)?;
        (distance, lambda) = (nearness, recorded.lambda);
        trace.samples.push(recorded);
    }
    // The time was planned; at a singularity that the flow does not cross the arm turns back all the same.
    let (begin, end) = (problem.path.begin(), problem.path.end());
    trace.finish_s =
        Some(run.ramp.interval()).filter(|_| has_reached_end(end - lambda, end - begin, EndRounding::Integration));
    trace.arrival_s = trace.finish_s.filter(|_| distance <= 1.0);
    Ok(trace)
}

/// A sample, and the arm's distance from its place in units of the arrival tolerances.
fn record<const N: usize>(
    problem: &Problem<N>,
    natural: &NaturalSample<N>,
    euler: &mut EulerAngles,
) -> Result<(Sample, f64), ProblemError> {
    let (place, speed) = (&natural.place, natural.motion.joint_speed);
    let demand = problem.demand(&place.q, euler, place.parameter);
    *euler = demand.euler;
    let limits = problem.path.speed_limits_at(place.parameter)?;
    let sample = Sample {
        t: natural.time,
        lambda: place.parameter,
        path_rate: natural.motion.path_speed,
        factor: 1.0,
        switch: 1.0,
        direction_factor: 1.0,
        limit_ratio: limits.ratio(&speed.into()),
        limiting_joint: limits.limiting_joint(&speed.into()),
        error: demand.error.into(),
        q: pad(&place.q),
        split: AffineSpeed { feedback: [0.0; MAX_JOINTS], feedforward: pad(&speed) },
        desired: pad(&speed),
        commanded: pad(&speed),
        chatter: None,
    };
    Ok((sample, demand.distance))
}
