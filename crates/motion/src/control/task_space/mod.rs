//! Control in the space of the tool, `[R16]` "Operational space control", "Force and impedance control".
//!
//! Errors, twists, accelerations and wrenches are in the base frame at the tool's origin, linear part first. A wrench is always
//! what the environment exerts **on the tool**; `[R16]` takes the opposite sign for force control and this one for impedance
//! control, under one name.

mod acceleration;
mod force;
mod gains;
mod impedance;
mod joint_guard;
mod operational;
mod rates;
mod tool_state;

pub use acceleration::ToolFeedback;
pub use force::{ForceControl, ForceState};
pub use gains::ToolGains;
pub use impedance::{Impedance, VirtualMass};
pub use joint_guard::{GuardedJoint, JointGuard};
pub use operational::{OperationalOutput, OperationalSettings, OperationalSpace};
pub use rates::{RateController, RateLaw, RateOutput};
pub use tool_state::{ToolReference, ToolState, pose_error};
