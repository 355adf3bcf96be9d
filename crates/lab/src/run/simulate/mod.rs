mod record;
mod settle;

use crate::joints::JointUnits;
use crate::method::Method;
use crate::problem::{Integration, Problem};
use crate::run::controller::Demand;
use crate::run::decision::{Decision, Situation};
use crate::run::law::Law;
use crate::run::trace::{EndRounding, Trace, has_reached_end};
use crate::run::world::{World, displaced};
use slideway_path::ProblemError;
use slideway_robot::{EulerAngles, JointVector};

/// Samples after which a run is given up whatever its duration: a trace of this length fills about 2 GB.
pub const MAX_SAMPLES: usize = 5_000_000;

/// Runs one method. `fixed_rate` is the rate of the fixed-speed methods, `horizon` the time after which to give up, s.
pub(crate) fn simulate<const N: usize>(
    problem: &Problem<N>,
    method: Method,
    fixed_rate: f64,
    horizon: f64,
) -> Result<Trace, ProblemError> {
    let mut run = Run::new(problem, method, fixed_rate, horizon)?;
    while run.t() < horizon && run.trace.samples.len() < MAX_SAMPLES && run.is_finite() {
        if run.trace.finish_s.is_none() {
            run.follow()?;
        } else if run.settle()? {
            break;
        }
    }
    Ok(run.trace)
}

/// One instant as it is and as the controller sees it.
struct Observed<const N: usize> {
    /// The controller's demand for the joint positions that it sees.
    demand: Demand<N>,
    /// Its demand if it saw the true ones.
    truth: Demand<N>,
    /// Joint positions seen less the true ones, rad (m); `None` where it sees the true ones.
    offset: Option<JointVector<N>>,
}

/// A run in progress.
struct Run<'a, const N: usize> {
    problem: &'a Problem<N>,
    law: Law<N>,
    integration: Integration,
    period: f64,
    /// When to give up, s.
    horizon: f64,
    /// Real length of the sample before, s.
    elapsed: f64,
    /// By how much the clock is ahead of the counted samples, s.
    drift: f64,
    lambda: f64,
    q: JointVector<N>,
    euler: EulerAngles,
    /// Euler triple of the tool as the controller saw it one sample earlier.
    seen_euler: EulerAngles,
    world: World<N>,
    /// The sample before: demand, its factor `g` and desired speed, for the change of the latter.
    before: Option<(Demand<N>, f64, [f64; N])>,
    /// Distance from the path's end at the sample before, while the robot settles there.
    settling: Option<f64>,
    /// Samples since the joints last moved, while the robot settles.
    standing: u32,
    trace: Trace,
}

impl<'a, const N: usize> Run<'a, N> {
    fn new(problem: &'a Problem<N>, method: Method, fixed_rate: f64, horizon: f64) -> Result<Self, ProblemError> {
        let (period, integration) = if method.is_regulated() {
            (problem.control.sampling_period, Integration::Euler)
        } else {
            (problem.fixed_speed.sampling_period, problem.fixed_speed.integration)
        };
        Ok(Self {
            problem,
            law: Law::new(problem, method, fixed_rate)?,
            integration,
            period,
            horizon,
            elapsed: period,
            drift: 0.0,
            lambda: problem.path.begin(),
            q: displaced(&problem.start, &problem.disturbances),
            euler: problem.start_euler,
            seen_euler: problem.start_euler,
            world: World::new(&problem.disturbances),
            before: None,
            settling: None,
            standing: 0,
            trace: Trace {
                method,
                joints: N,
                joint_names: problem.joint_names.clone(),
                units: JointUnits::of(&problem.path.arm),
                sampling_period: period,
                finish_s: None,
                arrival_s: None,
                samples: Vec::new(),
            },
        })
    }

    /// Samples are counted, not summed: the clock drifts by jitter alone.
    #[allow(clippy::cast_precision_loss)]
    fn t(&self) -> f64 {
        self.trace.samples.len() as f64 * self.period + self.drift
    }

    /// Once a sample: measures, and keeps both Euler triples for the next one.
    fn observe(&mut self) -> Observed<N> {
        let truth = self.problem.demand(&self.q, &self.euler, self.lambda);
        self.euler = truth.euler;
        let Some(seen) = self.world.measure(&self.q) else {
            return Observed { demand: truth, truth, offset: None };
        };
        let demand = self.problem.demand(&seen, &self.seen_euler, self.lambda);
        self.seen_euler = demand.euler;
        Observed { demand, truth, offset: Some(seen - self.q) }
    }

    /// Lets the joints move for one period, however long it really is.
    fn move_joints(&mut self, speed: JointVector<N>) {
        self.q += self.world.moved(speed) * self.elapsed;
    }

    /// Draws how long the coming period lasts. The sample of its begin must have been recorded with the clock before.
    fn begin_period(&mut self) {
        self.elapsed = self.world.period(self.period);
        self.drift += self.elapsed - self.period;
    }

    fn is_finite(&self) -> bool {
        self.q.iter().all(|q| q.is_finite())
    }

    /// One sample of following the path.
    fn follow(&mut self) -> Result<(), ProblemError> {
        let t = self.t();
        let remaining = self.problem.path.end() - self.lambda;
        let observed = self.observe();
        let demand = observed.demand;
        let here = Situation {
            lambda: self.lambda,
            limits: self.problem.path.speed_limits_at(self.lambda)?,
            tool_rate: self.problem.path.tool_rate_limit(self.lambda),
            to_end: remaining / self.period,
        };
        let law_before = self.law.clone();
        let decision = self.law.step(self.problem, &demand, &here);
        self.record(t, &observed, &decision, &here.limits);
        self.begin_period();
        let rate = decision.command.path_rate;
        let span = self.problem.path.end() - self.problem.path.begin();
        if has_reached_end(remaining - decision.advance_rate * self.period, span, EndRounding::SummedSteps)
            && rate > 0.0
        {
            // The controller counts on a whole period; its share is that of the real one.
            self.trace.finish_s = Some(t + remaining / rate * (self.elapsed / self.period));
            self.lambda = self.problem.path.end();
        } else {
            self.lambda += decision.advance_rate * self.period;
        }
        match self.integration {
            Integration::Euler => self.move_joints(decision.command.joint_speed.into()),
            Integration::Rk4 => self.q = self.rk4(&law_before, &decision, &here, observed.offset),
        }
        Ok(())
    }

    /// One Runge-Kutta step of the joint positions with the reference moving at its own rate. What is wrong with a measurement stays
    /// wrong with it until the next one.
    fn rk4(
        &self,
        law: &Law<N>,
        first: &Decision<N>,
        here: &Situation<N>,
        offset: Option<JointVector<N>>,
    ) -> JointVector<N> {
        let (h, rate) = (self.elapsed, first.advance_rate);
        let begin = self.lambda - if self.trace.finish_s.is_some() { 0.0 } else { rate * self.period };
        let slope = |q: JointVector<N>, fraction: f64| -> JointVector<N> {
            let lambda = (begin + fraction * rate * self.period).min(self.problem.path.end());
            let seen = offset.map_or(q, |offset| q + offset);
            let demand = self.problem.demand(&seen, &self.seen_euler, lambda);
            let here = Situation { lambda, to_end: rate, ..*here };
            self.world.moved(law.clone().step(self.problem, &demand, &here).command.joint_speed.into())
        };
        let k1 = self.world.moved(first.command.joint_speed.into());
        let k2 = slope(self.q + k1 * (h / 2.0), 0.5);
        let k3 = slope(self.q + k2 * (h / 2.0), 0.5);
        let k4 = slope(self.q + k3 * h, 1.0);
        self.q + (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (h / 6.0)
    }
}
