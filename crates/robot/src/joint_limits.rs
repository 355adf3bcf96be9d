use crate::{LimitKind, PositionRange, RobotError};

/// Limits of a joint; `None` where there is none, or none is known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct JointLimits {
    /// Positions, rad or m.
    pub position: Option<PositionRange>,
    /// Largest speed, rad/s or m/s.
    pub velocity: Option<f64>,
    /// Largest torque or force, N·m or N.
    pub effort: Option<f64>,
    /// Largest acceleration either way, rad/s² or m/s².
    pub acceleration: Option<f64>,
    /// Largest jerk either way, rad/s³ or m/s³.
    pub jerk: Option<f64>,
}

impl JointLimits {
    /// The limit of a kind other than position.
    #[must_use]
    pub fn bound(&self, limit: LimitKind) -> Option<f64> {
        match limit {
            LimitKind::Position => None,
            LimitKind::Velocity => self.velocity,
            LimitKind::Effort => self.effort,
            LimitKind::Acceleration => self.acceleration,
            LimitKind::Jerk => self.jerk,
        }
    }

    /// Checks that the range is not inverted and that the others are positive.
    ///
    /// # Errors
    ///
    /// The first one that is wrong, with the joint's name.
    pub fn validate(&self, joint: &str) -> Result<(), RobotError> {
        if let Some(PositionRange { lower, upper }) = self.position.filter(|range| !(range.lower <= range.upper)) {
            return Err(RobotError::InvertedLimits { joint: joint.to_owned(), lower, upper });
        }
        let others = [
            ("velocity", self.velocity),
            ("effort", self.effort),
            ("acceleration", self.acceleration),
            ("jerk", self.jerk),
        ];
        for (what, limit) in others {
            if let Some(value) = limit.filter(|limit| !(*limit > 0.0)) {
                return Err(RobotError::LimitNotPositive { joint: joint.to_owned(), what, value });
            }
        }
        Ok(())
    }
}
