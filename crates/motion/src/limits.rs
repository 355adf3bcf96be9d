use crate::{MotionError, Range};
use slideway_robot::{JointVector, PositionRanges};

/// Largest speed, acceleration and jerk of one axis, the same in both directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisLimits {
    velocity: f64,
    acceleration: f64,
    jerk: f64,
}

impl AxisLimits {
    /// Accepts positive finite limits: per s, per s², per s³.
    ///
    /// # Errors
    ///
    /// [`MotionError::LimitNotPositive`] with the first limit refused.
    pub fn new(velocity: f64, acceleration: f64, jerk: f64) -> Result<Self, MotionError> {
        for (quantity, value) in
            [(LimitKind::Velocity, velocity), (LimitKind::Acceleration, acceleration), (LimitKind::Jerk, jerk)]
        {
            if !(value > 0.0 && value.is_finite()) {
                return Err(MotionError::LimitNotPositive { quantity, value });
            }
        }
        Ok(Self { velocity, acceleration, jerk })
    }

    /// Largest speed, per s.
    #[must_use]
    pub fn velocity(&self) -> f64 {
        self.velocity
    }

    /// Largest acceleration, per s².
    #[must_use]
    pub fn acceleration(&self) -> f64 {
        self.acceleration
    }

    /// Largest jerk, per s³.
    #[must_use]
    pub fn jerk(&self) -> f64 {
        self.jerk
    }
}

/// The quantity that a limit bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitKind {
    /// Speed.
    Velocity,
    /// Acceleration.
    Acceleration,
    /// Jerk.
    Jerk,
}

/// Limits of `N` joints: speed, acceleration, jerk, and the margin kept from their stops.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionLimits<const N: usize> {
    axes: [AxisLimits; N],
    stops: PositionRanges<N>,
    margin: f64,
}

impl<const N: usize> MotionLimits<N> {
    /// Limits of each joint, its stops (`None` where it has none), and the margin kept from them, rad or m.
    ///
    /// The margin is for the tracking error of whatever follows the reference: choose it as large as that error.
    ///
    /// # Errors
    ///
    /// [`MotionError::Margin`] if the margin is negative or NaN, or leaves a joint no room.
    pub fn new(axes: [AxisLimits; N], stops: PositionRanges<N>, margin: f64) -> Result<Self, MotionError> {
        let roomy = |joint: usize| stops[joint].is_none_or(|s| s.upper - s.lower > 2.0 * margin);
        if !(margin >= 0.0 && margin.is_finite() && (0..N).all(roomy)) {
            return Err(MotionError::Margin { margin });
        }
        Ok(Self { axes, stops, margin })
    }

    /// Limits without stops.
    #[must_use]
    pub fn without_stops(axes: [AxisLimits; N]) -> Self {
        Self { axes, stops: [None; N], margin: 0.0 }
    }

    /// Limits of each joint.
    #[must_use]
    pub fn axes(&self) -> &[AxisLimits; N] {
        &self.axes
    }

    /// Checks that joint `joint` stays away from its stops by the margin while its position covers `positions`.
    ///
    /// # Errors
    ///
    /// [`MotionError::JointStop`] with the position that comes too close; NaN is refused.
    pub fn check_stops(&self, joint: usize, positions: Range) -> Result<(), MotionError> {
        let Some(stops) = self.stops[joint] else { return Ok(()) };
        let (lower, upper) = (stops.lower + self.margin, stops.upper - self.margin);
        if !(positions.lower >= lower) {
            return Err(MotionError::JointStop { joint, position: positions.lower, limit: lower });
        }
        if !(positions.upper <= upper) {
            return Err(MotionError::JointStop { joint, position: positions.upper, limit: upper });
        }
        Ok(())
    }

    /// [`MotionLimits::check_stops`] of one position of all joints.
    ///
    /// # Errors
    ///
    /// As there.
    pub fn check_position(&self, q: &JointVector<N>) -> Result<(), MotionError> {
        q.iter().enumerate().try_for_each(|(joint, &q)| self.check_stops(joint, Range::point(q)))
    }
}
