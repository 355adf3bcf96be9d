#![doc = include_str!("../README.md")]

mod arm;
mod assembly;
pub mod augmented;
mod coupled;
mod description;
mod dh;
mod dynamics;
mod error;
pub mod euler;
mod inverse;
mod jacobi_svd;
mod jacobian;
mod joint;
mod joint_limits;
mod limit_kind;
mod lock;
mod manipulability;
pub mod models;
mod note;
mod numeric_ik;
mod position_range;
mod restarts;
mod rotation;
mod spherical_wrist;
pub mod srdf;
mod summary;
mod urdf;
mod xml;

pub use arm::{LinkFrames, SerialArm};
pub use coupled::Follower;
pub use description::{FollowerDescription, JointDescription, RobotDescription};
pub use dh::DhRow;
pub use dynamics::{
    BodyFault, Drive, DriveEffects, DriveFault, Dynamics, DynamicsError, Friction, GRAVITY, LinkInertia, MassMatrix,
};
pub use error::RobotError;
pub use euler::EulerAngles;
pub use inverse::{InverseMethod, Task, adjugate, solve_rates};
pub use jacobi_svd::JacobiSvd;
pub use joint::{Joint, JointKind};
pub use joint_limits::JointLimits;
pub use limit_kind::LimitKind;
pub use manipulability::manipulability;
pub use note::Note;
pub use numeric_ik::{NumericIk, NumericIkSettings};
pub use position_range::PositionRange;
pub use restarts::PositionRanges;
pub use rotation::rotation_vector;
pub use spherical_wrist::{Branch, Elbow, Shoulder, SphericalWristIk, Wrist};
pub use summary::{FollowerSummary, JointSummary, RobotSummary};
pub use urdf::{ChainEnds, ForeignFormat, UrdfError, UrdfFault, UrdfPlace};

/// Position and orientation of a frame, stored as a rotation matrix and a vector.
pub type Pose = nalgebra::IsometryMatrix3<f64>;
/// Joint positions, speeds or torques of an arm with `N` joints.
pub type JointVector<const N: usize> = nalgebra::SVector<f64, N>;
/// Geometric Jacobian, `6×N`: linear rows first.
pub type Jacobian<const N: usize> = nalgebra::SMatrix<f64, 6, N>;
/// Linear and angular velocity (or acceleration) of a frame, linear part first.
pub type Twist = nalgebra::Vector6<f64>;
