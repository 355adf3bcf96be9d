use super::curve::CurvePoint;
use super::turn::ToolTurn;
use crate::MotionError;
use crate::error::CurveFault;
use nalgebra::{Rotation3, Translation3, Unit, Vector3};
use slideway_robot::{Pose, Twist};

/// A circular arc or a helix of the tool's origin, traversed at a constant rate of its angle.
///
/// ```text
/// p(u) = c + exp(u α [a]) (p0 - c) + u h a
/// ```
///
/// with centre `c`, unit axis `a`, angle `α` (rad, positive anticlockwise about the axis) and climb `h` (m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolHelix {
    centre: Vector3<f64>,
    axis: Unit<Vector3<f64>>,
    /// From the centre to the start.
    arm: Vector3<f64>,
    angle: f64,
    climb: f64,
    turn: ToolTurn,
}

impl ToolHelix {
    /// From a pose, about an axis through `centre`. The tool turns by the rotation vector `turn`, rad, on the way: zero keeps its
    /// orientation, `axis * angle` carries it round with the arc.
    ///
    /// # Errors
    ///
    /// [`MotionError::Curve`]: a number that is not finite, an axis without length, a start on the axis, no angle.
    pub fn new(
        start: &Pose,
        centre: Vector3<f64>,
        axis: Vector3<f64>,
        angle: f64,
        climb: f64,
        turn: Vector3<f64>,
    ) -> Result<Self, MotionError> {
        let arm = start.translation.vector - centre;
        let numbers = arm.iter().chain(axis.iter()).chain(turn.iter()).chain([&angle, &climb]);
        if !numbers.into_iter().all(|x| x.is_finite()) {
            return Err(MotionError::Curve(CurveFault::NotFinite));
        }
        let unit = Unit::try_new(axis, 0.0).ok_or(MotionError::Curve(CurveFault::NoAxis))?;
        // Below a thousandth of a micrometre the direction of the arm is rounding.
        let radius = arm.cross(&unit).norm();
        if !(radius > 1e-9 && angle != 0.0) {
            return Err(MotionError::Curve(CurveFault::NoAxis));
        }
        Ok(Self { centre, axis: unit, arm, angle, climb, turn: ToolTurn::new(start.rotation, turn) })
    }

    /// The place at `u`.
    #[must_use]
    pub fn at(&self, u: f64) -> CurvePoint {
        let arm = Rotation3::from_axis_angle(&self.axis, self.angle * u) * self.arm;
        let along = self.axis.into_inner();
        let velocity = along.cross(&arm) * self.angle + along * self.climb;
        let bend = along.cross(&along.cross(&arm)) * (self.angle * self.angle);
        let position = self.centre + arm + along * (u * self.climb);
        let turn = self.turn.velocity();
        CurvePoint {
            pose: Pose::from_parts(Translation3::from(position), self.turn.at(u)),
            twist: Twist::new(velocity.x, velocity.y, velocity.z, turn.x, turn.y, turn.z),
            slope: Twist::new(bend.x, bend.y, bend.z, 0.0, 0.0, 0.0),
        }
    }

    /// Its length, m.
    #[must_use]
    pub fn length(&self) -> f64 {
        (self.angle * self.arm.cross(&self.axis).norm()).hypot(self.climb)
    }

    /// The tool's turn.
    #[must_use]
    pub fn turn(&self) -> &ToolTurn {
        &self.turn
    }
}
