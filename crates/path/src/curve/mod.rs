//! Curves through way-points: splines, blended lines, arcs, and rotations on the unit quaternions.
//!
//! Every curve is a function of the path parameter `λ` with its first and second derivative, all in one frame. None of
//! them knows a robot; positions and joint positions are vectors of `D` numbers, orientations are unit quaternions.

mod arc;
mod blends;
mod error;
mod jet;
mod polynomial_piece;
mod rotation;
mod spline;
mod squad;
mod waypoints;

pub use arc::Arc;
pub use blends::BlendedLines;
pub use error::CurveError;
pub use polynomial_piece::PolynomialPiece;
pub use rotation::{RotationPoint, RotationWaypoints, Slerp, unit_quaternion};
pub use spline::{CubicSpline, SplineEnds};
pub use squad::Squad;
pub use waypoints::{Spacing, Waypoints};
