//! Motion control of arms: profiles, a motion queue, interruption, supervision, feedback, and an arm to try them on.
//!
//! | layer | what it does |
//! |---|---|
//! | [`profile`], [`Interpolation`], [`WayPointRule`] | motions of one axis, of all joints at once, through way-points |
//! | [`MotionQueue`], [`tool`] | a bounded queue of joint and Cartesian segments, its interruptions, the pace of the path |
//! | [`supervisor`], [`ArmController`] | modes, faults, recovery |
//! | [`control`] | from set-points to torques, in joint space and in the space of the tool; forces |
//! | [`motor`] | between command and arm: current and speed loops, encoder, delay, heat |
//! | [`plant`] | the arm in simulation: rigid bodies, friction, a compliant wall, noisy sensors |
//! | [`characterise`] | bandwidth and tracking error of a controller by experiment |
//!
//! Units are SI (rad or m, s); poses are in the base frame. Nothing is allocated once a queue has been made, except by
//! [`path_through`], which plans outside the control loop, and by the error of a Cartesian segment.
//!
//! ```
//! use slideway_motion::{AxisLimits, Interpolation, MotionLimits, MotionQueue, Progress};
//!
//! let axis = AxisLimits::new(1.5, 4.0, 60.0)?; // rad/s, rad/s², rad/s³
//! let mut queue = MotionQueue::<2, 16>::new(MotionLimits::without_stops([axis; 2]), [0.0, 0.0].into())?;
//! queue.go_to(&[1.0, 0.5].into(), Interpolation::BoundedJerk)?;
//! queue.go_to(&[0.0, 0.0].into(), Interpolation::Trapezoid)?;
//! for _ in 0..300 {
//!     queue.advance(1e-3)?;
//! }
//! // In the middle of the first motion: elsewhere, now, without a jump of the acceleration.
//! queue.interrupt_to(&[0.2, -0.3].into(), Interpolation::BoundedJerk)?;
//! while queue.progress() != Progress::Resting {
//!     let set_point = queue.advance(1e-3)?;
//!     assert!(set_point.qdd.amax() <= 4.0 + 1e-9);
//! }
//! assert!((queue.set_point().q - nalgebra::Vector2::new(0.2, -0.3)).norm() < 2e-8);
//! # Ok::<(), slideway_motion::MotionError>(())
//! ```
//!
//! # Continuity
//!
//! | interpolation | continuous | limits kept |
//! |---|---|---|
//! | linear | position | speed |
//! | trapezoid, cubic, cosine | and velocity | and acceleration |
//! | bounded jerk | and acceleration | and jerk |
//!
//! under any sequence of commands, interruptions and changes of pace; see [`MotionQueue`].
//!
//! # Sources
//!
//! `[R16]` is chapter 16, "Control of Articulated Robots", of Hauser, "Robotic Systems".

pub mod characterise;
pub mod control;
mod controller;
mod error;
mod interpolation;
mod joint_motion;
mod limits;
pub mod motor;
mod planner;
pub mod plant;
pub mod profile;
pub mod queue;
mod range;
mod state;
pub mod supervisor;
pub mod tool;
mod way_points;

pub use controller::{ArmController, ControllerSettings, Output};
pub use error::{Continuity, CurveFault, MotionError};
pub use interpolation::Interpolation;
pub use joint_motion::JointMotion;
pub use limits::{AxisLimits, LimitKind, MotionLimits};
pub use planner::MotionPlanner;
pub use queue::{MotionQueue, Progress, Repeat};
pub use range::Range;
pub use state::{AxisState, JointState};
pub use way_points::{WayPointRule, path_through};
