use super::ToolLine;
use crate::profile::{Cubics, Ramp, TrapezoidEnds, bounded_jerk, trapezoid};
use crate::{AxisLimits, AxisState, MotionError};

/// What the tool may do at most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolLimits {
    /// Speed (m/s), acceleration and jerk of the tool's origin.
    pub linear: AxisLimits,
    /// Speed (rad/s), acceleration and jerk of the turn.
    pub angular: AxisLimits,
    /// Whether the jerk limit counts.
    pub ramp: Ramp,
}

impl ToolLimits {
    /// The limits of the parameter of a line: those of the slower of shift and turn. `None` for a line without extent.
    pub(super) fn along(&self, line: &ToolLine) -> Option<Result<AxisLimits, MotionError>> {
        let slower =
            |of: fn(&AxisLimits) -> f64| (of(&self.linear) / line.length()).min(of(&self.angular) / line.angle());
        let (v, a, j) = (slower(AxisLimits::velocity), slower(AxisLimits::acceleration), slower(AxisLimits::jerk));
        if v == f64::INFINITY { None } else { Some(AxisLimits::new(v, a, j)) }
    }
}

/// How fast a Cartesian segment is followed: the parameter `u` of its line in time.
#[derive(Clone, Copy, Debug, PartialEq)]
// Boxing the larger variant would allocate in the control loop.
#[allow(clippy::large_enum_variant)]
pub enum SpeedLaw {
    /// A profile from 0 to 1, laid down before the motion.
    Profile(Cubics),
}

impl SpeedLaw {
    /// The fastest profile from rest to rest.
    pub(super) fn profile(limits: &AxisLimits, ramp: Ramp) -> Self {
        Self::Profile(match ramp {
            Ramp::JerkLimited => bounded_jerk(0.0, 1.0, limits),
            Ramp::AccelerationLimited => {
                let ends = TrapezoidEnds { start: 0.0, start_velocity: 0.0, goal: 1.0, goal_velocity: 0.0 };
                trapezoid(&ends, limits)
            }
        })
    }

    /// Duration, s.
    #[must_use]
    pub fn duration(&self) -> f64 {
        match self {
            Self::Profile(p) => p.duration(),
        }
    }

    /// `u` and its derivatives at time `t`.
    #[must_use]
    pub fn at(&self, t: f64) -> AxisState {
        match self {
            Self::Profile(p) => p.at(t),
        }
    }

    /// The same law, `factor` times as slow.
    #[must_use]
    pub fn stretched(&self, factor: f64) -> Self {
        match self {
            Self::Profile(p) => Self::Profile(p.stretched(factor)),
        }
    }
}
