use super::ToolCurve;
use crate::profile::Ramp;
use crate::{AxisLimits, MotionError};

/// Law of the speed at which a Cartesian segment is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpeedLaw {
    /// A profile from rest to rest, laid down before the motion; see [`super::ToolMotion`].
    Profile(ToolLimits),
    /// As fast as the joints' limits allow, decided sample by sample; see [`super::RegulatedMotion`].
    SlidingMode(Regulation),
    /// Natural motion where the limits allow it, decided sample by sample; see [`super::RegulatedMotion`].
    Natural(Regulation),
}

/// Largest speed, acceleration and jerk of the tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolLimits {
    /// Speed (m/s), acceleration and jerk of the tool's origin along its path.
    pub linear: AxisLimits,
    /// Speed (rad/s), acceleration and jerk of the turn.
    pub angular: AxisLimits,
    /// Bound on changes of speed: the jerk limits count with [`Ramp::JerkLimited`] only.
    pub ramp: Ramp,
}

impl ToolLimits {
    /// The limits of the parameter of a curve: those of the slower of shift and turn. `None` for a curve without extent.
    pub(super) fn along(&self, curve: &ToolCurve) -> Option<Result<AxisLimits, MotionError>> {
        let slower =
            |of: fn(&AxisLimits) -> f64| (of(&self.linear) / curve.length()).min(of(&self.angular) / curve.angle());
        let (v, a, j) = (slower(AxisLimits::velocity), slower(AxisLimits::acceleration), slower(AxisLimits::jerk));
        if v == f64::INFINITY { None } else { Some(AxisLimits::new(v, a, j)) }
    }
}

/// Settings of a law that decides sample by sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Regulation {
    /// Its sampling period, s: that of the control loop, as a rule.
    pub sampling_period: f64,
    /// Bandwidth of the sliding mode's filter, rad/s; times the sampling period at most 1.
    pub bandwidth: f64,
    /// Share of the acceleration limits in [0, 1) that the plan ahead leaves to the discretisation.
    pub margin: f64,
}

impl Regulation {
    /// A millisecond, 100 rad/s and 2 %.
    pub const DEFAULT: Self = Self { sampling_period: 1e-3, bandwidth: 100.0, margin: 0.02 };
}
