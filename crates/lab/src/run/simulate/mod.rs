use crate::error::LabError;
use crate::problem::{Integration, Problem};
use crate::robot::MAX_JOINTS;
use crate::run::controller::Demand;
use crate::run::disturbances::{World, displaced};
use crate::run::law::{Decision, Law, Method, Situation};
use crate::run::trace::{Chatter, Sample, Trace};
use slideway_conditioner::{AffineSpeed, Saturation, SpeedLimits, bounds};
use slideway_robot::{EulerAngles, JointVector};

/// Samples after which a run is given up whatever its duration: a trace of this length fills about 2 GB.
pub(crate) const MAX_SAMPLES: usize = 5_000_000;

/// Runs one method. `fixed_rate` is the rate of the fixed-speed methods, `horizon` the time after which to give up, s.
pub(crate) fn simulate<const N: usize>(
    problem: &Problem<N>,
    method: Method,
    fixed_rate: f64,
    horizon: f64,
) -> Result<Trace, LabError> {
    let mut run = Run::new(problem, method, fixed_rate)?;
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
    /// What the controller makes of what it sees.
    demand: Demand<N>,
    /// What it would make of the truth.
    truth: Demand<N>,
    /// What it sees less what is, where it does not see the truth.
    offset: Option<JointVector<N>>,
}

/// A run in progress.
struct Run<'a, const N: usize> {
    problem: &'a Problem<N>,
    law: Law<N>,
    integration: Integration,
    period: f64,
    /// What the sample before really lasted, s.
    elapsed: f64,
    /// By how much the clock is ahead of the counted samples, s.
    drift: f64,
    lambda: f64,
    q: JointVector<N>,
    euler: EulerAngles,
    /// Euler triple of the tool as the controller saw it one sample earlier.
    seen_euler: EulerAngles,
    world: World<N>,
    /// The sample before: demand and factor, for the change of the desired speed.
    before: Option<(Demand<N>, f64, [f64; N])>,
    /// Distance from the path's end at the sample before, while the robot settles there.
    settling: Option<f64>,
    trace: Trace,
}

impl<'a, const N: usize> Run<'a, N> {
    fn new(problem: &'a Problem<N>, method: Method, fixed_rate: f64) -> Result<Self, LabError> {
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
            elapsed: period,
            drift: 0.0,
            lambda: problem.path.start(),
            q: displaced(&problem.start, &problem.disturbances),
            euler: problem.start_euler,
            seen_euler: problem.start_euler,
            world: World::new(&problem.disturbances),
            before: None,
            settling: None,
            trace: Trace {
                method,
                joints: N,
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
    fn follow(&mut self) -> Result<(), LabError> {
        let t = self.t();
        let remaining = self.problem.path.end() - self.lambda;
        let observed = self.observe();
        let demand = observed.demand;
        let here = Situation {
            lambda: self.lambda,
            limits: self.problem.speed_limits_at(self.lambda)?,
            tool_rate: self.problem.tool_rate_limit(self.lambda),
            to_end: remaining / self.period,
        };
        let law_before = self.law.clone();
        let decision = self.law.step(self.problem, &demand, &here);
        self.record(t, &observed, &decision, &here.limits);
        self.begin_period();
        let rate = decision.command.path_rate;
        // A remainder below 1e-12 of the path is rounding of the summed steps.
        let span = self.problem.path.end() - self.problem.path.start();
        if remaining - decision.advance_rate * self.period <= 1e-12 * span && rate > 0.0 {
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

    /// One sample of the robot catching up with a reference at its end; whether it has arrived.
    fn settle(&mut self) -> Result<bool, LabError> {
        let t = self.t();
        let observed = self.observe();
        // To have arrived is a fact, whatever the controller sees.
        let distance = observed.truth.distance;
        if matches!(self.law, Law::Acceleration(_)) {
            return Ok(self.settle_under_acceleration_limits(t, &observed));
        }
        let desired: [f64; N] = observed.demand.feedback.into();
        let limits = self.problem.speed_limits_at(self.lambda)?;
        let saturation =
            if self.trace.method == Method::Saturated { Saturation::Direct } else { Saturation::DirectionPreserving };
        let mut joint_speed = limits.saturate(&desired, saturation).joint_speed;
        if self.trace.method == Method::Ideal {
            joint_speed = desired;
        }
        self.trace.samples.push(Sample {
            t,
            lambda: self.lambda,
            path_rate: 0.0,
            factor: 0.0,
            switch: if limits.contain(&desired) { 1.0 } else { 0.0 },
            direction_factor: limits.saturate(&desired, saturation).direction_factor,
            limit_ratio: limits.ratio(&desired),
            limiting_joint: limits.limiting_joint(&desired),
            error: observed.truth.error.into(),
            q: pad(&self.q),
            split: self.split(&observed.demand),
            desired: pad(&desired.into()),
            commanded: pad(&joint_speed.into()),
            chatter: None,
        });
        if distance <= 1.0 {
            self.trace.arrival_s = Some(self.arrival_time(t, distance));
            return Ok(true);
        }
        self.settling = Some(distance);
        self.begin_period();
        self.move_joints(joint_speed.into());
        Ok(false)
    }

    /// The same under acceleration limits, where to be there means to be able to stay: the joints can stand with the next sample.
    fn settle_under_acceleration_limits(&mut self, t: f64, observed: &Observed<N>) -> bool {
        let Law::Acceleration(law) = &mut self.law else { return true };
        let could_stand = law.can_stand();
        let decision = law.settle(self.problem, &observed.demand);
        self.record(t, observed, &decision, &self.problem.speed_limits);
        let distance = observed.truth.distance;
        if distance <= 1.0 && could_stand {
            let stopped_inside = self.settling.is_some_and(|before| before <= 1.0);
            self.trace.arrival_s = Some(if stopped_inside { t } else { self.arrival_time(t, distance) });
            return true;
        }
        self.settling = Some(distance);
        self.begin_period();
        self.move_joints(decision.command.joint_speed.into());
        false
    }

    /// The moment of arrival, interpolated between the sample before and this one, not before the reference's.
    fn arrival_time(&self, t: f64, distance: f64) -> f64 {
        match self.settling {
            // The sample before stood outside, with the reference already at its end.
            Some(before) => {
                let fraction = if before > distance { (before - 1.0) / (before - distance) } else { 1.0 };
                t - self.elapsed + self.elapsed * fraction.clamp(0.0, 1.0)
            }
            None => self.trace.finish_s.unwrap_or(t),
        }
    }

    /// `A` and `B` at a sample.
    fn split(&self, demand: &Demand<N>) -> AffineSpeed<MAX_JOINTS> {
        let feedforward = demand.path_speed * self.problem.control.target_rate;
        AffineSpeed { feedback: pad(&demand.feedback), feedforward: pad(&feedforward) }
    }

    fn record(&mut self, t: f64, observed: &Observed<N>, decision: &Decision<N>, limits: &SpeedLimits<N>) {
        let (command, demand) = (&decision.command, &observed.demand);
        let shortened = decision.advance_rate < command.path_rate;
        let chatter = match (&self.before, self.trace.method.bounds_chattering() && !shortened) {
            (Some(before), true) => Some(self.chatter(before, demand, command.factor, &decision.desired)),
            _ => None,
        };
        self.trace.samples.push(Sample {
            t,
            lambda: self.lambda,
            path_rate: command.path_rate,
            factor: command.factor,
            switch: command.switch,
            direction_factor: command.direction_factor,
            limit_ratio: command.limit_ratio,
            limiting_joint: limits.limiting_joint(&decision.desired),
            error: observed.truth.error.into(),
            q: pad(&self.q),
            split: self.split(demand),
            desired: pad(&decision.desired.into()),
            commanded: pad(&command.joint_speed.into()),
            chatter,
        });
        self.before = Some((*demand, command.factor, decision.desired));
    }

    /// The change of `q̇d = A + f B` since the sample before, its bound and the paper's estimate.
    fn chatter(
        &self,
        before: &(Demand<N>, f64, [f64; N]),
        demand: &Demand<N>,
        factor: f64,
        desired: &[f64; N],
    ) -> Chatter {
        let control = &self.problem.control;
        let filter_step = control.filter_step();
        let (last, last_factor, last_desired) = before;
        let mut chatter = Chatter { measured: 0.0, bound: 0.0, estimate: 0.0 };
        let limits = &self.problem.speed_limits;
        for i in 0..N {
            let limit = limits.upper()[i].min(-limits.lower()[i]);
            let feedforward = demand.path_speed[i] * control.target_rate;
            let drift = last_factor * (feedforward - last.path_speed[i] * control.target_rate).abs()
                + (demand.feedback[i] - last.feedback[i]).abs();
            let bound = bounds::chattering_bound(feedforward, factor - last_factor, drift);
            let estimate = bounds::chattering_estimate(demand.path_speed[i], filter_step, control.target_rate);
            chatter.measured = chatter.measured.max((desired[i] - last_desired[i]).abs() / limit);
            chatter.bound = chatter.bound.max(bound / limit);
            chatter.estimate = chatter.estimate.max(estimate / limit);
        }
        chatter
    }
}

/// Joint values in an array of every number of joints.
pub(crate) fn pad<const N: usize>(values: &JointVector<N>) -> [f64; MAX_JOINTS] {
    let mut padded = [0.0; MAX_JOINTS];
    for (slot, value) in padded.iter_mut().zip(values.iter()) {
        *slot = *value;
    }
    padded
}
