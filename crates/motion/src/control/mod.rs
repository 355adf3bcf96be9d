//! Feedback: from set-points to joint torques.
//!
//! | law | commands | module |
//! |---|---|---|
//! | PID, gravity compensation, feed-forward, computed torque | torques | [`TorqueController`] |
//! | first order in the space of the tool | joint speeds | [`task_space::RateController`] |
//! | second order, with the effective inertia | torques | [`task_space::OperationalSpace`] |
//! | impedance, zero gravity, force | torques | [`task_space`] |

mod limit;
mod pid;
pub mod task_space;
mod torque;
mod wrist_sensor;

pub use limit::TorqueOutput;
pub use pid::{Derivative, Pid, PidSettings, PidState};
pub use torque::{TorqueController, TorqueLaw};
pub use wrist_sensor::{SensorMotion, WristSensor};
