#![doc = include_str!("../README.md")]

pub mod curve;
mod error;
pub mod formula;
mod joint_path;
mod jumps;
mod limits;
mod path_problem;
mod reference;

pub use error::{Fault, ListOf, NameFault, ProblemError};
pub use joint_path::polynomials::{JointPathPoint, JointPolynomials, Likeness, SplineDeviation};
pub use joint_path::sampled::{PathSample, SampledPath, SampledPiece};
pub use joint_path::whole::{NotWhole, WholePath};
pub use joint_path::{JointPath, JointPoint, Piece, PieceKind};
pub use limits::drive_and_tool::{ToolLimits, TorqueLimits};
pub use limits::joint_bounds::{Bound, BoundError, BoundSide, BoundSigns, JointBounds, JointRange};
pub use limits::position_limits::{PositionExcess, PositionLimits, PositionSource};
pub use limits::rows::{EndRate, LimitKind, LinearLimit, SpeedLimit};
pub use path_problem::PathProblem;
pub use reference::cartesian::CartesianPath;
pub use reference::joint_curve::JointCurve;
pub use reference::orientation::{EulerKnot, OrientationCurve, OrientationPoint};
pub use reference::point::{EulerPoint, PathPoint};
pub use reference::position::{Curve3, PositionCurve};
pub use reference::reference::{Reference, ToolReference};
