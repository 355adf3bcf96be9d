use crate::{DynamicsError, PositionRange};
use thiserror::Error;

/// Error in a robot description, or in solving for a pose.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum RobotError {
    /// A number in a robot description is NaN or infinite.
    #[error("joint {}: `{field}` is {value}; it must be finite", joint + 1)]
    NotFinite {
        /// Joint, counted from 0.
        joint: usize,
        /// Name of the parameter.
        field: &'static str,
        /// Value given.
        value: f64,
    },
    /// The arm does not have the geometry that the closed-form inverse kinematics needs.
    #[error("closed-form inverse kinematics needs a spherical wrist: {reason}")]
    NotSphericalWrist {
        /// The first condition that fails.
        reason: &'static str,
    },
    /// Gravity that is not finite.
    #[error("gravity has the coordinate {value}; it must be finite")]
    Gravity {
        /// The coordinate, m/s².
        value: f64,
    },
    /// A pose out of reach.
    #[error("pose out of reach: {reason}, short by {shortfall:.6} m")]
    OutOfReach {
        /// Which part of the arm cannot do it.
        reason: &'static str,
        /// Distance of the wrist centre from the reachable shell, m.
        shortfall: f64,
    },
    /// The numeric inverse kinematics came to rest away from the pose.
    #[error(
        "inverse kinematics did not converge: {position_error:.3e} m and {orientation_error:.3e} rad left after {iterations} iterations"
    )]
    NotConverged {
        /// Position error left, m.
        position_error: f64,
        /// Orientation error left, rad.
        orientation_error: f64,
        /// Iterations spent.
        iterations: usize,
    },
    /// The numeric inverse kinematics found the pose only outside the joints' ranges.
    #[error("every position found lies outside the joint limits, for instance joint {} at {value:.4} ({trials} seeds tried)", joint + 1)]
    OutsideLimits {
        /// Joint, counted from 0.
        joint: usize,
        /// Its position, rad or m.
        value: f64,
        /// Seeds tried.
        trials: usize,
    },
    /// The determinant-based inverse needs as many joints as task coordinates.
    #[error(
        "the adjugate inverse needs a square Jacobian: the task has {rows} coordinates and the arm {joints} joints"
    )]
    NotSquare {
        /// Task coordinates.
        rows: usize,
        /// Joints.
        joints: usize,
    },
    /// A parameter of an inverse that must be positive.
    #[error("{name} is {value}; it must be positive and finite")]
    NotPositive {
        /// Name of the parameter.
        name: &'static str,
        /// Value given.
        value: f64,
    },
    /// A description with another number of joints than wanted.
    #[error("the robot has {found} joints, not {expected}")]
    JointCount {
        /// Joints of the description.
        found: usize,
        /// Joints wanted.
        expected: usize,
    },
    /// A joint that is not there.
    #[error("there is no joint called `{name}`")]
    UnknownJoint {
        /// The name asked for.
        name: String,
        /// The joints there are.
        known: Vec<String>,
    },
    /// A joint to be locked where it cannot go.
    #[error("joint `{joint}` cannot be locked at {position}: its range is [{}, {}]", range.lower, range.upper)]
    LockedOutsideLimits {
        /// The joint.
        joint: String,
        /// Where it was to be locked, rad or m.
        position: f64,
        /// Where it can be locked, rad or m.
        range: PositionRange,
    },
    /// A range of positions whose lower end lies above its upper end.
    #[error("joint `{joint}`: the lower limit {lower} lies above the upper limit {upper}")]
    InvertedLimits {
        /// The joint.
        joint: String,
        /// Lower limit.
        lower: f64,
        /// Upper limit.
        upper: f64,
    },
    /// A limit that must be positive.
    #[error("joint `{joint}`: the {what} limit is {value}; it must be positive")]
    LimitNotPositive {
        /// The joint.
        joint: String,
        /// `velocity`, `effort`, `acceleration` or `jerk`.
        what: &'static str,
        /// Value given.
        value: f64,
    },
    /// Masses or drives that no machine has.
    #[error(transparent)]
    Dynamics(#[from] DynamicsError),
}

impl RobotError {
    /// Remedy, in one sentence.
    #[must_use]
    pub fn remedy(&self) -> String {
        match self {
            Self::OutOfReach { .. } => "move the pose into the arm's reach".into(),
            Self::Gravity { .. } => "give three finite numbers in m/s²".into(),
            Self::JointCount { .. } => "use an arm with as many joints as asked for".into(),
            Self::UnknownJoint { known, .. } => format!("the joints are {}", known.join(", ")),
            Self::LockedOutsideLimits { range, .. } => format!("give a number from {} to {}", range.lower, range.upper),
            Self::NotFinite { .. } => "give a finite number".into(),
            Self::NotPositive { .. } => "give a number greater than zero".into(),
            Self::NotSphericalWrist { .. } => {
                "use the numeric inverse kinematics: give a position to start from".into()
            }
            Self::NotConverged { .. } => {
                "move the pose into the arm's reach, or start closer to the wanted configuration".into()
            }
            Self::OutsideLimits { .. } => "move the pose, or widen the range of the joint named".into(),
            Self::NotSquare { .. } => "use damped least squares or the truncated decomposition, or another task".into(),
            Self::InvertedLimits { .. } => "exchange `lower` and `upper`".into(),
            Self::LimitNotPositive { .. } => "give a number greater than zero, or leave it out for no limit".into(),
            Self::Dynamics(DynamicsError::SingularMass) => "give every link a mass, or include rotor inertia".into(),
            Self::Dynamics(_) => "correct the link's or the joint's parameters".into(),
        }
    }
}
