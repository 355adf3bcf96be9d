//! Cartesian segments: the tool on a curve, the joints by inverse kinematics.

mod curve;
mod helix;
mod kinematics;
mod law;
mod line;
mod motion;
mod natural;
mod polyline;
mod regulated;
mod regulator;
mod turn;
mod walk;

pub use curve::{CurvePoint, ToolCurve};
pub use helix::ToolHelix;
pub use kinematics::{ToolFault, ToolKinematics};
pub use law::{Regulation, SpeedLaw, ToolLimits};
pub use line::ToolLine;
pub use motion::ToolMotion;
pub use polyline::{MAX_POINTS, ToolPolyline};
pub(crate) use regulated::Advanced;
pub use regulated::RegulatedMotion;
pub use turn::ToolTurn;
