use crate::{BodyFault, DriveFault, RobotError};
use std::ops::Range;
use std::path::PathBuf;
use thiserror::Error;

/// Why a URDF gives no arm.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum UrdfError {
    /// The file cannot be read.
    #[error("cannot read {}: {message}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system says.
        message: String,
    },
    /// The text is not XML, or not a URDF.
    #[error("this is not a URDF: {message}")]
    Malformed {
        /// What the parser says, with line and column where it knows them.
        message: String,
    },
    /// Elements nested beyond anything a robot needs.
    #[error("elements are nested more than {most} deep")]
    TooDeep {
        /// Deepest nesting accepted.
        most: usize,
    },
    /// There is no link at all.
    #[error("the robot has no link")]
    NoLinks,
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
        /// Its kind.
        kind: &'static str,
    },
    /// A joint of the arm that follows another.
    #[error("joint `{joint}` between base and tip mimics joint `{leader}`: the arm's joints must move on their own")]
    Mimic {
        /// The follower.
        joint: String,
        /// The one it follows.
        leader: String,
    },
    /// An axis without a direction.
    #[error("joint `{joint}`: its axis is zero or not finite")]
    Axis {
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
        part: &'static str,
    },
    /// Masses that no rigid body has.
    #[error("link `{link}`: {fault}")]
    Body {
        /// The link.
        link: String,
        /// What is wrong.
        fault: BodyFault,
    },
    /// Damping or friction that no machine has.
    #[error("joint `{joint}`: {fault}")]
    Drive {
        /// The joint.
        joint: String,
        /// What is wrong.
        fault: DriveFault,
    },
    /// Limits that are inverted or not positive.
    #[error(transparent)]
    Limits(RobotError),
}

impl UrdfError {
    /// What to do about it, in one sentence.
    #[must_use]
    pub fn remedy(&self) -> String {
        match self {
            Self::Read { .. } => "give the path of a URDF file; expand xacro files to URDF first".into(),
            Self::Malformed { .. } => {
                "check the XML near the place named; xacro files must be expanded to URDF first".into()
            }
            Self::TooDeep { .. } => "check that every element is closed".into(),
            Self::NoLinks => "add `<link>` and `<joint>` elements".into(),
            Self::NamedTwice { what, .. } => format!("give each {what} a name of its own"),
            Self::UnknownLink { link, .. } => format!("add `<link name=\"{link}\"/>`, or correct the joint"),
            Self::TwoParents { .. } => "a URDF is a tree: remove one of the joints".into(),
            Self::Loop { .. } => "a URDF is a tree: let one link have no parent".into(),
            Self::SeveralRoots { .. } => "choose the base link, or connect the others with fixed joints".into(),
            Self::NoSuchLink { known, .. } => format!("the links are {}", list(known)),
            Self::NotReachable { .. } => "choose a base on the way from the root to the tip, or another tip".into(),
            Self::SeveralArms { .. } => "choose the tip link of one of the arms".into(),
            Self::NoJoints { .. } => "choose a tip beyond a moving joint".into(),
            Self::UnsupportedJoint { .. } => "choose base and tip so that this joint is not between them".into(),
            Self::Mimic { .. } => "choose a tip before this joint, or remove its `<mimic>` element".into(),
            Self::Axis { .. } => "give the axis a direction, for example `<axis xyz=\"0 0 1\"/>`".into(),
            Self::NotFinite { .. } => "write finite numbers".into(),
            Self::Body { .. } => "correct the link's `<inertial>` element".into(),
            Self::Drive { .. } => "correct the joint's `<dynamics>` element".into(),
            Self::Limits(error) => error.remedy(),
        }
    }

    /// Where the element that the error is about lies in the text, as a range of bytes: its name.
    #[must_use]
    pub fn locate(&self, text: &str) -> Option<Range<usize>> {
        let name = match self {
            Self::NamedTwice { name, .. } | Self::NotFinite { name, .. } => name,
            Self::UnknownLink { joint, .. }
            | Self::TwoParents { second: joint, .. }
            | Self::UnsupportedJoint { joint, .. }
            | Self::Mimic { joint, .. }
            | Self::Axis { joint }
            | Self::Drive { joint, .. } => joint,
            Self::Limits(RobotError::InvertedLimits { joint, .. } | RobotError::LimitNotPositive { joint, .. }) => {
                joint
            }
            Self::Loop { link } | Self::SeveralArms { link, .. } | Self::Body { link, .. } => link,
            _ => return None,
        };
        // The second of two equal names is the one to change; any other name occurs as a name once.
        let at = text.rfind(&format!("name=\"{name}\"")).or_else(|| text.rfind(&format!("name='{name}'")))?;
        let begin = at + "name=\"".len();
        Some(begin..begin + name.len())
    }
}

/// At most this many names are listed.
const LISTED: usize = 24;

fn list(names: &[String]) -> String {
    let mut text = names.iter().take(LISTED).map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    if names.len() > LISTED {
        text.push_str(", ...");
    }
    text
}
