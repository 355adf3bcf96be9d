use crate::curve::CurveError;
use crate::formula::FormulaError;
use slideway_conditioner::ParameterError;
use slideway_robot::RobotError;
use thiserror::Error;

/// Reason why a problem cannot be posed, or its path not followed.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ProblemError {
    /// A value with the right shape and the wrong content.
    #[error("`{key}`: {fault}")]
    Value {
        /// Name of the value; where it comes from a scenario its key, dotted, list elements counted from 0: `limits.speed.2`.
        key: String,
        /// Fault of the value.
        fault: Fault,
    },
    /// The robot cannot follow the path continuously.
    #[error(
        "the joint path breaks at path parameter {at:.6}: the next configuration is {jump:.3} rad away and no self-motion leads there"
    )]
    BrokenPath {
        /// Path parameter where the joint path ends.
        at: f64,
        /// Largest joint change of the best continuation found, rad.
        jump: f64,
    },
    /// No finite joint speed follows the path as asked.
    #[error("no finite joint speed follows the path as asked at path parameter {at:.6}")]
    NoFiniteSpeed {
        /// Path parameter where it ends.
        at: f64,
    },
    /// The path leaves the robot's reach.
    #[error("the path leaves the robot's reach at path parameter {at:.6}: {source}")]
    LeavesReach {
        /// Path parameter of the last configuration found.
        at: f64,
        /// Error of the inverse kinematics.
        source: RobotError,
    },
}

/// Fault of a value.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum Fault {
    /// Must be greater than zero.
    #[error("{0} is not positive")]
    NotPositive(f64),
    /// Must be less than zero.
    #[error("{0} is not negative")]
    NotNegative(f64),
    /// A limit along the path with the wrong sign somewhere.
    #[error("{value} at path parameter {lambda:.6}: upper limits must be positive and lower ones negative")]
    SignAt {
        /// The limit there.
        value: f64,
        /// Where.
        lambda: f64,
    },
    /// A list of the wrong length.
    #[error("{found} {} given, {expected} needed ({})", list.entries(), list.one_per())]
    WrongLength {
        /// Entries found.
        found: usize,
        /// Entries needed.
        expected: usize,
        /// Kind of the list's entries.
        list: ListOf,
    },
    /// Two numbers that must increase do not.
    #[error("{after} does not lie after {before}")]
    NotIncreasing {
        /// The earlier number.
        before: f64,
        /// The later one.
        after: f64,
    },
    /// A required key is missing.
    #[error("missing; {0}")]
    Missing(&'static str),
    /// Keys that exclude each other.
    #[error("{0}")]
    Conflict(&'static str),
    /// A choice that the rest of the scenario does not allow, with the change that would allow it.
    #[error("{need}")]
    Unmet {
        /// Requirement of the choice.
        need: &'static str,
        /// Remedy: the way to meet the requirement.
        remedy: &'static str,
    },
    /// A task that prescribes more coordinates than the arm has joints.
    #[error("the task has {rows} coordinates and the arm {joints} joints")]
    TaskRows {
        /// Coordinates of the task.
        rows: usize,
        /// Joints of the arm.
        joints: usize,
    },
    /// A reference that begins faster than the regulator would ever let it run.
    #[error("{rate} is above `control.target_rate`, {target}")]
    AboveTarget {
        /// The rate at the start, 1/s.
        rate: f64,
        /// The target rate, 1/s.
        target: f64,
    },
    /// A number of joints outside the supported range.
    #[error("{0} joints; between 1 and 7 are supported")]
    JointCount(usize),
    /// A number too large or too small to be meant.
    #[error("{value} is {}", outside(*value, *least, *most))]
    OutOfRange {
        /// Value that was given.
        value: f64,
        /// Smallest accepted.
        least: f64,
        /// Largest accepted.
        most: f64,
    },
    /// A number outside a range whose ends do not belong to it.
    #[error("{value} is outside ({least}, {most}), whose ends do not count")]
    OutOfOpenRange {
        /// Value that was given.
        value: f64,
        /// All larger ones are accepted, up to the next.
        least: f64,
        /// All smaller ones are accepted.
        most: f64,
    },
    /// Natural motion without the part of a spherical wrist, on an arm or a task that has none.
    #[error("the factor `arm` leaves out the part of a spherical wrist: {reason}")]
    NoWristFactor {
        /// Part or property that is missing.
        reason: &'static str,
    },
    /// A path that has no finite value or derivative somewhere.
    #[error("no finite value or derivative at path parameter {0:.6}")]
    UndefinedAt(f64),
    /// A name that no column of a table can bear.
    #[error("the name \"{name}\" {reason}")]
    Name {
        /// The name.
        name: String,
        /// Fault of the name.
        reason: NameFault,
    },
    /// A constraint whose gradient is zero on its own boundary.
    #[error(
        "the gradient vanishes on the boundary near ({:.4}, {:.4}, {:.4}) m: there is no direction to push",
        near[0], near[1], near[2]
    )]
    VanishingGradient {
        /// A point of the reference near that place, m.
        near: [f64; 3],
    },
    /// A way-point, or a derivative at one, with too few or too many numbers.
    #[error("{found} numbers given, {} needed", widths(expected))]
    WaypointLength {
        /// Numbers found.
        found: usize,
        /// Numbers that would do.
        expected: Vec<usize>,
    },
    /// Listed path parameters that leave a part of the path without way-points.
    #[error("the list runs from {} to {}, the path from {} to {}", listed[0], listed[1], path[0], path[1])]
    NotCovered {
        /// First and last of the list.
        listed: [f64; 2],
        /// Start and end of the path.
        path: [f64; 2],
    },
    /// Way-points or rotations that no curve joins.
    #[error(transparent)]
    Curve(#[from] CurveError),
    /// A formula that cannot be used.
    #[error(transparent)]
    Formula(#[from] FormulaError),
    /// A conditioner's parameter.
    #[error(transparent)]
    Conditioner(#[from] ParameterError),
    /// A robot's parameter or an unreachable pose.
    #[error(transparent)]
    Robot(#[from] RobotError),
}

/// Fault of a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum NameFault {
    /// Nothing in it.
    #[error("is empty")]
    Empty,
    /// Another thing of the kind has it.
    #[error("stands twice")]
    Repeated,
    /// A comma, a quote or a line feed in it.
    #[error("has a character that a column's name cannot have")]
    Character,
}

/// Kind of a list's entries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ListOf {
    /// A number for each joint; a single number would do for all of them.
    JointsOrAll,
    /// A number for each joint.
    Joints,
    /// A range for each joint.
    JointRanges,
    /// A number for each face of a polytope.
    Faces,
    /// A number for each constraint.
    Constraints,
}

impl ListOf {
    fn entries(self) -> &'static str {
        match self {
            Self::JointRanges => "ranges",
            Self::JointsOrAll | Self::Joints | Self::Faces | Self::Constraints => "numbers",
        }
    }

    fn one_per(self) -> &'static str {
        match self {
            Self::JointsOrAll | Self::Joints | Self::JointRanges => "one per joint",
            Self::Faces => "one per face",
            Self::Constraints => "one per constraint",
        }
    }

    fn remedy(self, expected: usize) -> String {
        match self {
            Self::JointsOrAll => format!("give {expected} numbers, or a single one for all joints"),
            Self::Joints => format!("give {expected} numbers, one per joint"),
            Self::JointRanges => format!("give {expected} ranges `[lower, upper]`, one per joint"),
            Self::Faces => format!("give {expected} numbers, one for each of the normals"),
            Self::Constraints => format!("give {expected} numbers, one per constraint"),
        }
    }
}

/// Words for a number outside a range; an end that no number passes is left out.
fn outside(value: f64, least: f64, most: f64) -> String {
    match (least > f64::MIN, most < f64::MAX) {
        (true, true) => format!("outside [{least}, {most}]"),
        (true, false) if value < least => format!("below {least}"),
        (false, true) if value > most => format!("above {most}"),
        _ => "no finite number".into(),
    }
}

fn widths(numbers: &[usize]) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(" or ")
}

impl Fault {
    /// Remedy, in one sentence.
    #[must_use]
    pub fn remedy(&self) -> String {
        match self {
            Self::NotPositive(_) => "give a number greater than zero".into(),
            Self::NotNegative(_) => "give a number less than zero".into(),
            Self::SignAt { .. } => "change the formula so that it keeps its sign along the whole path".into(),
            Self::WrongLength { expected, list, .. } => list.remedy(*expected),
            Self::NotIncreasing { .. } => "order the numbers from small to large, each at most once".into(),
            Self::Missing(_) => "add the key; `slideway init FILE` writes a template with every key explained".into(),
            Self::Conflict(_) => "keep one of the keys".into(),
            Self::Unmet { remedy, .. } => (*remedy).into(),
            Self::TaskRows { joints, .. } => match joints {
                0 | 1 => "prescribe the joints themselves: a path under `[path.joints]`".into(),
                2 => "choose `planar-position`, which has 2 coordinates".into(),
                3..=5 => "choose `position` or `planar-pose`, which have 3 coordinates, or `planar-position`, which has 2".into(),
                _ => "choose another `robot.task`".into(),
            },
            Self::AboveTarget { target, .. } => {
                format!("give a number from 0 to {target}, or raise `control.target_rate`")
            }
            Self::JointCount(_) => {
                "use an arm with 1 to 7 joints; of a URDF, choose a part with `base` and `tip`".into()
            }
            Self::OutOfRange { least, most, .. } => match (*least > f64::MIN, *most < f64::MAX) {
                (true, true) => format!("give a number from {least} to {most}"),
                (true, false) => format!("give a number of at least {least}"),
                (false, true) => format!("give a number of at most {most}"),
                (false, false) => "give a finite number".into(),
            },
            Self::OutOfOpenRange { least, most, .. } => {
                format!("give a number greater than {least} and less than {most}")
            }
            Self::NoWristFactor { .. } => "leave `natural.factor` out, or give \"determinant\"".into(),
            Self::UndefinedAt(_) => "change the formula, or the range of the path parameter".into(),
            Self::VanishingGradient { .. } => {
                "write the constraint so that it crosses zero with a slope, for example `r - 1` instead of `(r - 1)^2`"
                    .into()
            }
            Self::WaypointLength { .. } => {
                "give x, y, z for a position, x, y, z and alpha, beta, gamma or the quaternion w, x, y, z for a pose, one number per joint for a configuration".into()
            }
            Self::NotCovered { .. } => "extend the list, or choose `start` and `end` of the path inside it".into(),
            Self::Curve(error) => error.remedy().into(),
            Self::Formula(error) => error.remedy(),
            Self::Conditioner(ParameterError::FilterStep { .. }) => {
                "lower `control.bandwidth` or `control.sampling_period` until their product is at most 1".into()
            }
            Self::Conditioner(error) => format!("give what the message asks for: {error}"),
            Self::Name { .. } => {
                "give each a name of its own, of letters, digits, blanks and marks other than commas and quotes".into()
            }
            Self::Robot(RobotError::OutOfReach { .. }) => "move the pose into the arm's reach".into(),
            Self::Robot(RobotError::NotConverged { .. }) => {
                "move the pose into the arm's reach, or give `start.near` closer to the wanted configuration".into()
            }
            Self::Robot(RobotError::NotSphericalWrist { .. }) => {
                "remove `start.branch` and give `start.near = [...]`, joint positions close to the wanted ones".into()
            }
            Self::Robot(RobotError::NotSquare { .. }) => {
                "use `[robot.inverse.damped-least-squares]` or `[robot.inverse.truncated-svd]`, or another `robot.task`"
                    .into()
            }
            Self::Robot(error) => error.remedy(),
        }
    }
}

impl ProblemError {
    /// A value that cannot be used, at its key.
    #[must_use]
    pub fn value(key: impl Into<String>, fault: impl Into<Fault>) -> Self {
        Self::Value { key: key.into(), fault: fault.into() }
    }

    /// Remedy, in one sentence.
    #[must_use]
    pub fn remedy(&self) -> String {
        match self {
            Self::Value { fault, .. } => fault.remedy(),
            Self::BrokenPath { .. } => {
                "start from another branch of the inverse kinematics (`start.branch`), or change the path there".into()
            }
            Self::NoFiniteSpeed { .. } => {
                "run singularities by natural motion, which stands still there, or start where the path is regular"
                    .into()
            }
            Self::LeavesReach { .. } => "shorten the path, or move it closer to the robot".into(),
        }
    }
}
