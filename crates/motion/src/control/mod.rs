//! Feedback: from set-points to joint torques.

mod pid;
mod torque;

pub use pid::{Derivative, Pid, PidSettings, PidState};
pub use torque::{TorqueController, TorqueLaw, TorqueOutput};
