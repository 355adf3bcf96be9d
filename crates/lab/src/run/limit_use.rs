use crate::problem::Problem;
use crate::run::trace::{Sample, Trace};
use serde::{Deserialize, Serialize};
use slideway_path::JointRange;
use slideway_path::LimitKind;
use slideway_path::ProblemError;
use slideway_robot::JointVector;

/// The largest use that a run made of one kind of limit while the reference moved.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LimitUse {
    /// Kind of the limit.
    pub kind: LimitKind,
    /// Name of the joint; `None` for the tool.
    pub joint: Option<String>,
    /// Path parameter where.
    pub lambda: f64,
    /// Share of the limit: 1 is the limit itself.
    pub share: f64,
}

/// A motion of the joints at an instant.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct JointMotion {
    /// Path parameter.
    pub lambda: f64,
    /// Configuration, rad (m).
    pub q: Vec<f64>,
    /// Speeds, rad/s (m/s).
    pub speed: Vec<f64>,
    /// Accelerations, rad/s² (m/s²).
    pub acceleration: Vec<f64>,
}

/// What a motion of the joints asks of the robot at an instant.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionInstant {
    /// Torques, Nm (N for joints that slide); `None` without masses.
    pub torque: Option<Vec<f64>>,
    /// The limit that it uses most.
    pub limit: Option<LimitUse>,
}

/// The same at one sample.
#[derive(Clone, Copy)]
struct Use {
    kind: LimitKind,
    /// Counted from 0.
    joint: Option<usize>,
    lambda: f64,
    share: f64,
}

/// The motion at one sample: speeds are held over samples, accelerations are their change over one.
struct Instant<const N: usize> {
    lambda: f64,
    q: JointVector<N>,
    speed: JointVector<N>,
    acceleration: JointVector<N>,
    tool_speed: f64,
    tool_acceleration: f64,
}

impl<const N: usize> Problem<N> {
    /// Largest use that a run made of each kind of limit that the scenario gives, besides the constant joint-speed limits of
    /// [`crate::MethodSummary::limit_ratio_peak`]. Commanded speeds count, over the samples in which the reference moves.
    pub(crate) fn limit_use(&self, trace: &Trace) -> Vec<LimitUse> {
        let following = trace.following();
        let start = following.iter().position(|s| s.path_rate > 0.0).unwrap_or(following.len());
        let mut worst: Vec<Use> = Vec::new();
        for pair in following[start..].windows(2) {
            let instant = self.instant(&pair[0], &pair[1], trace.sampling_period);
            for found in self.uses(&instant) {
                match worst.iter_mut().find(|w| w.kind == found.kind) {
                    None => worst.push(found),
                    // Not a number is the worst of all.
                    Some(known) if !(found.share <= known.share) && !known.share.is_nan() => *known = found,
                    Some(_) => {}
                }
            }
        }
        worst.into_iter().map(|found| self.named(found)).collect()
    }

    fn named(&self, found: Use) -> LimitUse {
        let Use { kind, joint, lambda, share } = found;
        LimitUse { kind, joint: joint.map(|joint| self.joint_names[joint].clone()), lambda, share }
    }

    /// Largest share of a joint-speed limit used by a command; infinite for one that is not a number.
    pub(crate) fn command_use(&self, trace: &Trace) -> Result<f64, ProblemError> {
        let mut largest = 0.0_f64;
        for sample in &trace.samples {
            let limits = self.path.speed_limits_at(sample.lambda)?;
            largest = largest.max(limits.ratio(&std::array::from_fn(|i| sample.commanded[i])));
        }
        Ok(largest)
    }

    pub(crate) fn motion_instant(&self, motion: &JointMotion) -> MotionInstant {
        let vector = |values: &[f64]| JointVector::<N>::from_fn(|i, _| values[i]);
        let (q, speed, acceleration) = (vector(&motion.q), vector(&motion.speed), vector(&motion.acceleration));
        let jacobian = self.path.arm.jacobian(&q);
        let length = |twist: nalgebra::Vector6<f64>| twist.fixed_rows::<3>(0).norm();
        let instant = Instant {
            lambda: motion.lambda,
            q,
            speed,
            acceleration,
            tool_speed: length(jacobian * speed),
            tool_acceleration: length(jacobian * acceleration + self.path.arm.bias_acceleration(&q, &speed)),
        };
        let mut uses = self.uses(&instant);
        if self.path.speed_along.is_none() {
            let (lower, upper) = (*self.path.speed_limits.lower(), *self.path.speed_limits.upper());
            uses.extend(worst(LimitKind::JointSpeed, motion.lambda, &speed, &JointRange { lower, upper }));
        }
        let torque = self.dynamics.as_ref().map(|d| d.inverse(&q, &speed, &acceleration).iter().copied().collect());
        let limit = uses.into_iter().max_by(|a, b| a.share.total_cmp(&b.share)).map(|found| self.named(found));
        MotionInstant { torque, limit }
    }

    fn instant(&self, before: &Sample, here: &Sample, period: f64) -> Instant<N> {
        let vector = |values: &[f64]| JointVector::<N>::from_fn(|i, _| values[i]);
        let tool =
            |s: &Sample| (self.path.arm.jacobian(&vector(&s.q)) * vector(&s.commanded)).fixed_rows::<3>(0).into_owned();
        let (q, speed) = (vector(&here.q), vector(&here.commanded));
        Instant {
            lambda: here.lambda,
            q,
            speed,
            acceleration: (speed - vector(&before.commanded)) / period,
            tool_speed: tool(here).norm(),
            tool_acceleration: (tool(here) - tool(before)).norm() / period,
        }
    }

    fn uses(&self, instant: &Instant<N>) -> Vec<Use> {
        let mut uses = Vec::new();
        if let Some(bounds) = &self.path.speed_along {
            uses.extend(worst(LimitKind::JointSpeed, instant.lambda, &instant.speed, &bounds.at(instant.lambda)));
        }
        if let Some(bounds) = &self.path.acceleration_limits {
            let range = bounds.at(instant.lambda);
            uses.extend(worst(LimitKind::JointAcceleration, instant.lambda, &instant.acceleration, &range));
        }
        if let Some(limits) = &self.path.torque_limits {
            let torque = limits.dynamics.inverse(&instant.q, &instant.speed, &instant.acceleration);
            uses.extend(worst(LimitKind::JointTorque, instant.lambda, &torque, &limits.bounds.at(instant.lambda)));
        }
        let tool =
            |kind, value: f64, limit: f64| Use { kind, joint: None, lambda: instant.lambda, share: value / limit };
        uses.extend(self.path.tool_limits.speed.map(|limit| tool(LimitKind::ToolSpeed, instant.tool_speed, limit)));
        let acceleration = self.path.tool_limits.acceleration;
        uses.extend(acceleration.map(|limit| tool(LimitKind::ToolAcceleration, instant.tool_acceleration, limit)));
        uses
    }
}

/// The joint that uses most of its limit.
fn worst<const N: usize>(kind: LimitKind, lambda: f64, values: &JointVector<N>, range: &JointRange<N>) -> Option<Use> {
    (0..N)
        .map(|joint| Use {
            kind,
            joint: Some(joint),
            lambda,
            share: share(values[joint], range.lower[joint], range.upper[joint]),
        })
        .max_by(|a, b| a.share.total_cmp(&b.share))
}

/// Share of the bound on the value's side of zero; where zero is outside the bounds, 1 plus the excess over half their range.
fn share(value: f64, lower: f64, upper: f64) -> f64 {
    if lower < 0.0 && upper > 0.0 {
        return (value / upper).max(value / lower);
    }
    1.0 + (value - upper).max(lower - value) / (0.5 * (upper - lower))
}
