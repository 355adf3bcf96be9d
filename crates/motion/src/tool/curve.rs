use super::{ToolFault, ToolHelix, ToolLine, ToolPolyline};
use crate::MotionError;
use slideway_robot::{Pose, Twist};

/// A path of the tool over a parameter `u` in [0, 1], twice differentiable in it, in the base frame.
#[derive(Clone, Copy, Debug, PartialEq)]
// Boxing the larger variant would allocate in the control loop.
#[allow(clippy::large_enum_variant)]
pub enum ToolCurve {
    /// A straight line.
    Line(ToolLine),
    /// Straight lines with rounded corners.
    Polyline(ToolPolyline),
    /// An arc of a circle, or a helix.
    Helix(ToolHelix),
}

/// One place of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// Pose of the tool.
    pub pose: Pose,
    /// Its twist at unit `u̇`, m and rad.
    pub twist: Twist,
    /// Derivative of the twist by `u`.
    pub slope: Twist,
}

impl CurvePoint {
    /// Twist and its rate of change while `u` moves: `t u̇` and `t' u̇² + t ü`.
    #[must_use]
    pub fn motion(&self, rate: f64, acceleration: f64) -> (Twist, Twist) {
        (self.twist * rate, self.slope * (rate * rate) + self.twist * acceleration)
    }
}

impl ToolCurve {
    /// The place at `u`.
    #[must_use]
    pub fn at(&self, u: f64) -> CurvePoint {
        match self {
            Self::Line(line) => CurvePoint { pose: line.at(u), twist: line.direction(), slope: Twist::zeros() },
            Self::Polyline(polyline) => polyline.at(u),
            Self::Helix(helix) => helix.at(u),
        }
    }

    /// The error of a fault at `u`.
    pub(crate) fn fault(&self, u: f64, cause: ToolFault) -> MotionError {
        let place = self.at(u).pose.translation.vector;
        MotionError::Tool { share: u, place: [place.x, place.y, place.z], cause: Box::new(cause) }
    }

    /// Largest length of the twist's linear part, m: the curve's length, but for the corners that are cut.
    #[must_use]
    pub fn length(&self) -> f64 {
        match self {
            Self::Line(line) => line.length(),
            Self::Polyline(polyline) => polyline.length(),
            Self::Helix(helix) => helix.length(),
        }
    }

    /// Angle of the tool's turn, rad.
    #[must_use]
    pub fn angle(&self) -> f64 {
        match self {
            Self::Line(line) => line.angle(),
            Self::Polyline(polyline) => polyline.turn().angle(),
            Self::Helix(helix) => helix.turn().angle(),
        }
    }
}
