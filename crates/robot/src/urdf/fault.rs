use super::names::list;
use crate::{BodyFault, DriveFault, RobotError};
use std::path::PathBuf;
use thiserror::Error;

/// The reason for which a URDF gives no arm.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum UrdfFault {
    /// The file cannot be read.
    #[error("cannot read {}: {message}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// The system's message.
        message: String,
    },
    /// Bytes that are not of the file's encoding.
    #[error("{}, line {line}: not readable as {}", path.display(), declared.as_deref().unwrap_or("UTF-8"))]
    Encoding {
        /// The file.
        path: PathBuf,
        /// The encoding that the file declares, if it does.
        declared: Option<String>,
        /// Line of the first such byte, counted from 1.
        line: usize,
    },
    /// The text is not XML.
    #[error("this is not a URDF: {message}")]
    Malformed {
        /// The parser's message.
        message: String,
    },
    /// A xacro file, from which a URDF is yet to be made.
    #[error("this is a xacro file, not yet a URDF: {found}")]
    Xacro {
        /// The element or expression that shows it.
        found: String,
    },
    /// A robot or a scene in another format.
    #[error("this is {format}, not a URDF")]
    OtherFormat {
        /// The format.
        format: ForeignFormat,
    },
    /// XML with a root that is no robot.
    #[error("this is not a URDF: its root element is `<{root}>`, not `<robot>`")]
    NotARobot {
        /// Name of the root element.
        root: String,
    },
    /// There is no link at all.
    #[error("robot `{robot}` has no link")]
    NoLinks {
        /// The robot's name.
        robot: String,
    },
    /// A link or joint without a name.
    #[error("a {what} has no name")]
    NoName {
        /// `link` or `joint`.
        what: &'static str,
    },
    /// An element or attribute without which a joint cannot be understood.
    #[error("joint `{joint}` has no {part}")]
    Missing {
        /// The joint.
        joint: String,
        /// The element or attribute.
        part: &'static str,
    },
    /// A value that is not the number or numbers it must be.
    #[error("{what} `{name}`: `{key}=\"{value}\"` of its `<{element}>` is not {}", amount(*expected))]
    Number {
        /// `link` or `joint`.
        what: &'static str,
        /// Its name.
        name: String,
        /// The element.
        element: String,
        /// The attribute.
        key: &'static str,
        /// Its value.
        value: String,
        /// Count of numbers that the value must hold.
        expected: usize,
    },
    /// A link or joint name used twice.
    #[error("two {what}s are called `{name}`")]
    NamedTwice {
        /// `link` or `joint`.
        what: &'static str,
        /// The name.
        name: String,
    },
    /// A joint that connects a link that is not there.
    #[error("joint `{joint}`: its {end} link `{link}` does not exist")]
    UnknownLink {
        /// The joint.
        joint: String,
        /// `parent` or `child`.
        end: &'static str,
        /// The link it names.
        link: String,
    },
    /// A link that two joints carry.
    #[error("link `{link}` is the child of both joint `{first}` and joint `{second}`")]
    TwoParents {
        /// The link.
        link: String,
        /// One joint.
        first: String,
        /// The other.
        second: String,
    },
    /// Every link has a parent, or some hang in a ring.
    #[error("the joints form a loop through link `{link}`")]
    Loop {
        /// A link of the loop.
        link: String,
    },
    /// More than one link without a parent.
    #[error("there is more than one root link: {}", list(links))]
    SeveralRoots {
        /// The links without a parent.
        links: Vec<String>,
    },
    /// The base or tip asked for is not a link.
    #[error("there is no link called `{name}`")]
    NoSuchLink {
        /// The name asked for.
        name: String,
        /// The links there are.
        known: Vec<String>,
    },
    /// The tip does not hang on the base.
    #[error("link `{tip}` is not reachable from `{base}`: going up from it, one arrives at `{root}`")]
    NotReachable {
        /// Where the arm was to start.
        base: String,
        /// Where it was to end.
        tip: String,
        /// The root that the tip hangs on.
        root: String,
    },
    /// The tree branches into several moving parts before any joint.
    #[error("the robot branches at link `{link}` into several moving arms: {}", list(branches))]
    SeveralArms {
        /// Where.
        link: String,
        /// The links that the branches begin with.
        branches: Vec<String>,
        /// Links that end the branches.
        tips: Vec<String>,
    },
    /// No joint between base and tip moves.
    #[error("no joint between `{base}` and `{tip}` moves")]
    NoJoints {
        /// The base.
        base: String,
        /// The tip.
        tip: String,
    },
    /// A joint that neither turns about nor slides along an axis.
    #[error("joint `{joint}` is {kind}; an arm has revolute, continuous, prismatic and fixed joints")]
    UnsupportedJoint {
        /// The joint.
        joint: String,
        /// Its type.
        kind: String,
    },
    /// A joint that mimics a joint that is not there.
    #[error("joint `{joint}` mimics joint `{leader}`, which does not exist")]
    UnknownLeader {
        /// The follower.
        joint: String,
        /// The joint it names.
        leader: String,
    },
    /// Joints that mimic one another in a ring.
    #[error("joint `{joint}` mimics itself by way of others")]
    MimicLoop {
        /// A joint of the ring, or one that follows it.
        joint: String,
    },
    /// An axis without a direction.
    #[error("joint `{joint}`: its axis is zero or not finite")]
    Axis {
        /// The joint.
        joint: String,
    },
    /// A quaternion without a direction.
    #[error("joint `{joint}`: its `quat_xyzw` is zero")]
    Quaternion {
        /// The joint.
        joint: String,
    },
    /// A number that is not finite.
    #[error("{what} `{name}`: a number in its {part} is not finite")]
    NotFinite {
        /// `link` or `joint`.
        what: &'static str,
        /// Its name.
        name: String,
        /// The element.
        part: String,
    },
    /// Masses that no rigid body has.
    #[error("link `{link}`: {fault}")]
    Body {
        /// The link.
        link: String,
        /// The condition that fails.
        fault: BodyFault,
    },
    /// Damping or friction that no machine has.
    #[error("joint `{joint}`: {fault}")]
    Drive {
        /// The joint.
        joint: String,
        /// The parameter.
        fault: DriveFault,
    },
    /// Limits that are inverted or not positive.
    #[error(transparent)]
    Limits(RobotError),
}

/// A format that is taken for URDF at times.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum ForeignFormat {
    /// Gazebo's scene description.
    #[error("an SDF file")]
    Sdf,
    /// MuJoCo's model description.
    #[error("a MuJoCo model (MJCF)")]
    Mjcf,
    /// Groups and configurations of a robot whose links are in a URDF.
    #[error("an SRDF file")]
    Srdf,
}

fn amount(numbers: usize) -> String {
    if numbers == 1 { "a number".into() } else { format!("{numbers} numbers separated by blanks") }
}
