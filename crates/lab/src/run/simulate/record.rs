//! Record of a sample in the trace.

use super::{Observed, Run};
use crate::joints::{MAX_JOINTS, pad};
use crate::run::controller::Demand;
use crate::run::decision::Decision;
use crate::run::trace::{Chatter, Sample};
use slideway_conditioner::{AffineSpeed, SpeedLimits, bounds};

impl<const N: usize> Run<'_, N> {
    /// `A` and `B` at a sample.
    pub(super) fn split(&self, demand: &Demand<N>) -> AffineSpeed<MAX_JOINTS> {
        let feedforward = demand.path_speed * self.problem.control.target_rate;
        AffineSpeed { feedback: pad(&demand.feedback), feedforward: pad(&feedforward) }
    }

    pub(super) fn record(&mut self, t: f64, observed: &Observed<N>, decision: &Decision<N>, limits: &SpeedLimits<N>) {
        let (command, demand) = (&decision.command, &observed.demand);
        let shortened = decision.advance_rate < command.path_rate;
        let chatter = match (&self.before, self.trace.method.bounds_chattering() && !shortened) {
            (Some(before), true) => Some(self.chatter(before, demand, decision.demand_factor, &decision.desired)),
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
        self.before = Some((*demand, decision.demand_factor, decision.desired));
    }

    /// The change of `q̇d = A + g B` since the sample before, its bound and the paper's estimate.
    ///
    /// `g` is `f` unless the tool's speed limit caps the path rate. The bound needs nothing of where `g` comes from:
    /// `Δ(A + g B) = ΔA + g ΔB + B' Δg` with the newer `B'`, whatever the sequence of `g`, so `|B'_i| |Δg| + g |ΔB_i| + |ΔA_i|` holds, a
    /// change of the cap included. The estimate is the law's own part.
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
        let limits = &self.problem.path.speed_limits;
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
