//! Paths of a robot's tool and joints, their limits, and the sampled path that an optimum is found on.
//!
//! From arrays to a sampled path:
//!
//! ```
//! use slideway_conditioner::SpeedLimits;
//! use slideway_path::curve::{CubicSpline, Spacing, SplineEnds, Waypoints};
//! use slideway_path::{JointBounds, JointCurve, JointPath, PathProblem, Reference, SampledPath};
//! use slideway_robot::models::Model;
//!
//! let points = [[0.0, 0.5], [0.4, 0.9], [1.0, 0.6]].map(Into::into).to_vec();
//! let spline = CubicSpline::new(Waypoints::new(points, &Spacing::Chord, 0.0..1.0)?, SplineEnds::NotAKnot)?;
//! let curve = JointCurve::spline(spline, 0.0..1.0);
//! let start = curve.at(0.0)[0];
//! let arm = Model::Planar2R.describe()?.arm()?;
//! let mut problem =
//!     PathProblem::new(arm, Reference::Joint(curve), start, SpeedLimits::new([-1.0, -1.0], [1.0, 1.0])?);
//! problem.acceleration_limits = Some(JointBounds::symmetric([3.0, 4.0])?);
//! let path = SampledPath::new(&problem, &JointPath::trace(&problem)?, 500, 3)?;
//! assert!(path.speed_limited_time() > 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! `slideway_baselines::time_optimal::time_optimum` takes the sampled path from there.

pub mod curve;
mod error;
pub mod formula;
mod joint_path;
mod jumps;
mod limits;
mod path_problem;
mod reference;

pub use error::{Fault, ListOf, ProblemError};
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
