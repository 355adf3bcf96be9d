use super::natural::Ceiling;
use super::walk::{INTERVALS, Nodes, along, place};
use super::{Regulation, ToolCurve, ToolFault, ToolKinematics};
use crate::{MotionError, MotionLimits};
use slideway_conditioner::acceleration::{
    AccelerationLimits, AccelerationRegulator, AccelerationSettings, AccelerationState, LookAhead, LookAheadSettings,
    Preview, Recovery,
};
use slideway_conditioner::{AffineSpeed, SpeedLimits};
use slideway_robot::JointVector;

/// Share of the acceleration limits that the law keeps for what happens between its samples: what it bounds is the change of a
/// joint's speed from sample to sample, and within one the acceleration differs from its mean by half a period of its jerk.
pub(super) const ROOM: f64 = 0.01;

/// The same of the speed limits: between samples the speed differs from the straight line by an eighth of the squared period times
/// the jerk.
const SPEED_ROOM: f64 = 1e-3;

/// Ratio of the target rate to the fastest that the speed limits allow anywhere.
const OVERSPEED: f64 = 2.0;

/// Rounds in which a sample's place and rate are found.
const ROUNDS: usize = 2;

/// A remainder of the curve that is rounding of `u`.
const ARRIVED: f64 = 1e-12;

/// The law of a curve: what decides its rate, sample by sample.
#[derive(Clone, Copy, Debug)]
pub(super) struct Regulator<const N: usize> {
    period: f64,
    regulator: AccelerationRegulator<N>,
    look_ahead: LookAhead<N>,
    /// The joints' limits, a little inside.
    speeds: SpeedLimits<N>,
    accelerations: [f64; N],
    target_rate: f64,
    ceiling: Ceiling,
    /// Distance before the end at which the plan ahead ends, and the largest rate of the last sample in motion: see [`Regulator::new`].
    reserve: f64,
    last_rate: f64,
    /// `q'(u)` at the nodes.
    path_speeds: [[f64; N]; INTERVALS + 1],
    /// Largest `u̇²` at the nodes from which the end can be reached at rest.
    ranges: [f64; INTERVALS + 1],
}

/// Where a curve is followed at a sample, at which rate, and the rate that comes next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PathState<const N: usize> {
    /// `u` at the sample.
    pub(super) place: f64,
    /// `u̇` at the sample.
    pub(super) rate: f64,
    /// `u̇` at the next one.
    pub(super) next: f64,
    /// `ü` between them; once the next sample is reached, as it was before it.
    pub(super) slope: f64,
    /// Time left until the next sample, s; none when it has to be decided.
    pub(super) left: f64,
    /// The sliding mode's factor.
    factor: f64,
    /// Joint speed at the sample, rad/s.
    speed: [f64; N],
    /// A joint position close by.
    pub(super) q: JointVector<N>,
}

impl<const N: usize> PathState<N> {
    pub(super) fn at_rest(q: JointVector<N>) -> Self {
        Self { place: 0.0, rate: 0.0, next: 0.0, slope: 0.0, left: 0.0, factor: 0.0, speed: [0.0; N], q }
    }

    pub(super) fn is_resting(&self) -> bool {
        self.rate == 0.0 && self.next == 0.0 && self.slope == 0.0
    }

    /// True if the curve is at its end, at rest.
    pub(super) fn has_arrived(&self) -> bool {
        self.left == 0.0 && self.rate == 0.0 && 1.0 - self.place <= 2.0 * ARRIVED
    }
}

impl<const N: usize> Regulator<N> {
    pub(super) fn new(
        limits: &MotionLimits<N>,
        regulation: &Regulation,
        nodes: &Nodes<N>,
    ) -> Result<Self, MotionError> {
        let speeds = limits.axes().map(|axis| (1.0 - SPEED_ROOM) * axis.velocity());
        let accelerations = limits.axes().map(|axis| (1.0 - ROOM) * axis.acceleration());
        let path_speeds = nodes.map(|node| node.qd.into());
        let speed_limits = SpeedLimits::symmetric(speeds)?;
        let acceleration_limits = AccelerationLimits::symmetric(accelerations)?;
        let Regulation { sampling_period, bandwidth, margin } = *regulation;
        let target_rate = OVERSPEED * path_speeds.iter().map(|v| 1.0 / speed_limits.ratio(v)).fold(0.0, f64::max);
        let settings = AccelerationSettings {
            speed_limits,
            acceleration_limits,
            sampling_period,
            bandwidth,
            target_rate,
            recovery: Recovery::AsDemanded,
        };
        let plan = LookAheadSettings { speed_limits, acceleration_limits, sampling_period, target_rate, margin };
        let look_ahead = LookAhead::new(plan)?;
        let mut ranges = [0.0; INTERVALS + 1];
        look_ahead.ranges(place(1), &path_speeds, &mut ranges);
        let last = path_speeds.last().into_iter().flatten();
        let braking = last.zip(&accelerations).map(|(v, a)| a / v.abs()).fold(f64::MAX, f64::min);
        Ok(Self {
            period: sampling_period,
            regulator: AccelerationRegulator::new(settings)?,
            look_ahead,
            speeds: speed_limits,
            accelerations,
            target_rate,
            ceiling: Ceiling::Limits,
            reserve: braking * sampling_period * sampling_period / 8.0,
            last_rate: 0.9 * braking * sampling_period,
            path_speeds,
            ranges,
        })
    }

    pub(super) fn under(self, ceiling: Ceiling) -> Self {
        Self { ceiling, ..self }
    }

    /// The limits that the law keeps: speeds and accelerations.
    pub(super) fn limits(&self) -> (&[f64; N], &[f64; N]) {
        (self.speeds.upper(), &self.accelerations)
    }

    pub(super) fn period(&self) -> f64 {
        self.period
    }

    /// Decides the rate at the next sample.
    ///
    /// Between samples `u̇` is linear in time, so the next one is at `u + Ts (u̇ + u̇⁺) / 2`; seen from `u + Ts u̇ / 2` that is the
    /// midpoint of a sample of the held rate `u̇⁺`, which is what the look-ahead is exact for. The joint speed there is found in
    /// two rounds, the first at the place that the present rate leads to: after the second the place is off by the change of the
    /// rate between the rounds.
    pub(super) fn decide(
        &self,
        kinematics: &ToolKinematics<N>,
        curve: &ToolCurve,
        state: &mut PathState<N>,
        pace: f64,
    ) -> Result<(), ToolFault> {
        let before = AccelerationState::moving(state.factor, state.speed, &self.speeds);
        let Ok(before) = before else { return Err(self.too_fast(&state.speed)) };
        let begun = state.place + 0.5 * self.period * state.rate;
        let seen = self.seen_from((begun + self.reserve).min(1.0));
        let mut next = state.rate;
        let mut seed = state.q;
        let (mut ahead, mut command);
        let mut round = 0;
        loop {
            let coming = curve.at((begun + 0.5 * self.period * next).clamp(0.0, 1.0));
            ahead = along(kinematics, &coming, &seed)?;
            seed = ahead.q;
            let natural = self.ceiling.rate(kinematics, &coming, &ahead.q);
            let ceiling = self.end_within(begun, pace, pace * seen.min(natural));
            let demand = AffineSpeed { feedback: [0.0; N], feedforward: (ahead.qd * self.target_rate).into() };
            command = self.regulator.step_below(&mut before.clone(), &demand, ceiling);
            next = command.path_rate;
            round += 1;
            if round == ROUNDS {
                break;
            }
        }
        self.check(&command.desired, &command.joint_speed, &state.speed)?;
        state.next = next;
        state.slope = (state.next - state.rate) / self.period;
        state.left = self.period;
        state.factor = command.factor;
        for (speed, (demand, most)) in state.speed.iter_mut().zip(command.desired.iter().zip(self.speeds.upper())) {
            *speed = demand.clamp(-most, *most);
        }
        state.q = ahead.q;
        Ok(())
    }

    /// A rate that leads no further than the end: the last sample in motion ends there, if one is enough.
    fn end_within(&self, begun: f64, pace: f64, rate: f64) -> f64 {
        let left = if 1.0 - begun > ARRIVED { (1.0 - begun) / self.period } else { 0.0 };
        let is_last = pace > 0.0 && left <= self.last_rate;
        if is_last { left } else { rate.min(left) }
    }

    /// The largest rate from which the curve can be followed to its end at rest.
    fn seen_from(&self, u: f64) -> f64 {
        // `u` is in [0, 1], where a node lies at or before it.
        let behind = ((u * INTERVALS as f64) as usize).min(INTERVALS);
        let (path_speeds, ranges) = (&self.path_speeds[behind..], &self.ranges[behind..]);
        let preview = Preview { offset: (u - place(behind)).max(0.0), spacing: place(1), path_speeds };
        self.look_ahead.greatest_rate_within(&preview, ranges)
    }

    /// Checks that a demand is as good as commanded: off by no more than what was kept in reserve.
    fn check(&self, demand: &[f64; N], command: &[f64; N], before: &[f64; N]) -> Result<(), ToolFault> {
        for joint in 0..N {
            let limit = self.accelerations[joint] / (1.0 - ROOM);
            if !((demand[joint] - command[joint]).abs() <= 0.5 * ROOM * limit * self.period) {
                let acceleration = (demand[joint] - before[joint]) / self.period;
                return Err(ToolFault::TooRough { joint, acceleration, limit });
            }
        }
        Ok(())
    }

    fn too_fast(&self, speeds: &[f64; N]) -> ToolFault {
        let over = |(joint, (speed, limit)): (usize, (&f64, &f64))| {
            (!(speed.abs() <= *limit)).then_some(ToolFault::TooFast { joint, speed: speed.abs(), limit: *limit })
        };
        let nan = ToolFault::TooFast { joint: 0, speed: f64::NAN, limit: f64::NAN };
        speeds.iter().zip(self.speeds.upper()).enumerate().find_map(over).unwrap_or(nan)
    }

    /// An estimate of the time from rest to rest at full pace, s: on the nodes, by the look-ahead forwards and backwards.
    pub(super) fn estimated_duration(
        &self,
        kinematics: &ToolKinematics<N>,
        curve: &ToolCurve,
        nodes: &Nodes<N>,
    ) -> f64 {
        let mut reversed = self.path_speeds;
        reversed.reverse();
        let mut from_start = [0.0; INTERVALS + 1];
        self.look_ahead.ranges(place(1), &reversed, &mut from_start);
        from_start.reverse();
        let (mut time, mut last) = (0.0, 0.0);
        for (index, ((node, ahead), behind)) in nodes.iter().zip(&self.ranges).zip(&from_start).enumerate() {
            let natural = self.ceiling.rate(kinematics, &curve.at(place(index)), &node.q);
            let rate = ahead.min(*behind).sqrt().min(natural);
            if index > 0 {
                time += 2.0 * place(1) / (last + rate);
            }
            last = rate;
        }
        time
    }
}
