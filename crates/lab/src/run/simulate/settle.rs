//! The robot catches up with a reference at its end.

use super::{Observed, Run};
use crate::joints::pad;
use crate::method::Method;
use crate::run::law::Law;
use crate::run::trace::Sample;
use slideway_conditioner::Saturation;
use slideway_path::ProblemError;

/// Joints that would not go farther than this in all the time that is left stand, rad (m): a hundred-thousandth of what counts as arrival.
const STANDS: f64 = 1e-9;

impl<const N: usize> Run<'_, N> {
    /// One sample of the robot catching up with a reference at its end; whether there is nothing to wait for: it has arrived, or it stands
    /// elsewhere, where a controller that is wrong about its joints sees it arrived.
    pub(super) fn settle(&mut self) -> Result<bool, ProblemError> {
        let t = self.t();
        let observed = self.observe();
        // To have arrived is a fact, whatever the controller sees.
        let distance = observed.truth.distance;
        if matches!(self.law, Law::Acceleration(_)) {
            return Ok(self.settle_under_acceleration_limits(t, &observed));
        }
        let desired: [f64; N] = observed.demand.feedback.into();
        let limits = self.problem.path.speed_limits_at(self.lambda)?;
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
        Ok(self.stands(&joint_speed))
    }

    /// The same under acceleration limits, where to be there means to be able to stay: the joints can stand with the next sample.
    fn settle_under_acceleration_limits(&mut self, t: f64, observed: &Observed<N>) -> bool {
        let Law::Acceleration(law) = &mut self.law else { return true };
        let could_stand = law.can_stand();
        let decision = law.settle(self.problem, &observed.demand);
        self.record(t, observed, &decision, &self.problem.path.speed_limits);
        let distance = observed.truth.distance;
        if distance <= 1.0 && could_stand {
            let stopped_inside = self.settling.is_some_and(|before| before <= 1.0);
            self.trace.arrival_s = Some(if stopped_inside { t } else { self.arrival_time(t, distance) });
            return true;
        }
        self.settling = Some(distance);
        self.begin_period();
        self.move_joints(decision.command.joint_speed.into());
        self.stands(&decision.command.joint_speed)
    }

    /// True if the joints have stood for longer than measurements are late, so that the controller has seen them stand. NaN moves.
    fn stands(&mut self, commanded: &[f64; N]) -> bool {
        let left = self.horizon - self.t();
        let stand = commanded.iter().all(|speed| speed.abs() * left < STANDS);
        self.standing = if stand { self.standing + 1 } else { 0 };
        self.standing > self.problem.disturbances.delay + 1
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
}
