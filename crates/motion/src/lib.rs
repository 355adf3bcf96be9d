//! Motion generation for arms: profiles, a motion queue, interruption and supervision.
//!
//! Units are SI (rad or m, s).
//!
//! # Sources
//!
//! `[R16]` is the chapter "Control of Articulated Robots" of Hauser, "Robotic Systems" (draft).

pub mod control;
mod controller;
mod error;
mod interpolation;
mod joint_motion;
mod limits;
mod planner;
pub mod profile;
pub mod queue;
mod range;
mod state;
pub mod supervisor;
pub mod tool;
mod way_points;

pub use controller::{ArmController, ControllerSettings, Output};
pub use error::{Continuity, MotionError};
pub use interpolation::Interpolation;
pub use joint_motion::JointMotion;
pub use limits::{AxisLimits, LimitKind, MotionLimits};
pub use planner::MotionPlanner;
pub use queue::{MotionQueue, Progress, Repeat};
pub use range::Range;
pub use state::{AxisState, JointState};
pub use way_points::{WayPointRule, path_through};
