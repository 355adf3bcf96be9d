//! Cartesian segments: the tool on a straight line, the joints by inverse kinematics.

mod kinematics;
mod law;
mod line;
mod motion;

pub use kinematics::{ToolFault, ToolKinematics};
pub use law::{SpeedLaw, ToolLimits};
pub use line::ToolLine;
pub use motion::ToolMotion;
