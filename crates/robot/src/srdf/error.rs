use thiserror::Error;

/// Why an SRDF cannot be used, and on which line where it has one.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{}{fault}", line.map(|line| format!("line {line}: ")).unwrap_or_default())]
pub struct SrdfError {
    /// The reason.
    pub fault: SrdfFault,
    /// Line in the file, counted from 1.
    pub line: Option<usize>,
}

/// The reason for which an SRDF cannot be used.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SrdfFault {
    /// The file cannot be read, or is of another encoding than UTF-8 and Latin-1.
    #[error("the file cannot be read: {message}")]
    Read {
        /// The reason.
        message: String,
    },
    /// The text is not XML.
    #[error("this is not an SRDF: {message}")]
    Malformed {
        /// The parser's message.
        message: String,
    },
    /// The root is no robot, or the robot has links: a URDF.
    #[error("this is not an SRDF but {found}")]
    NotSrdf {
        /// Description of the root.
        found: String,
    },
    /// An element without an attribute that it needs.
    #[error("a `<{element}>` has no `{attribute}`")]
    Missing {
        /// The element.
        element: String,
        /// The attribute.
        attribute: &'static str,
    },
    /// A position that is no list of finite numbers.
    #[error("joint `{joint}` of the configuration `{state}`: `{value}` is not a finite number")]
    Number {
        /// The configuration.
        state: String,
        /// The joint.
        joint: String,
        /// The value.
        value: String,
    },
    /// A group that is not there.
    #[error("there is no group called `{name}`")]
    NoSuchGroup {
        /// The name asked for.
        name: String,
        /// The groups there are.
        known: Vec<String>,
    },
    /// Groups that contain one another.
    #[error("group `{name}` contains itself")]
    GroupLoop {
        /// A group of the ring.
        name: String,
    },
    /// A group without joints.
    #[error("group `{name}` has no joint")]
    EmptyGroup {
        /// The group.
        name: String,
    },
    /// A group whose joints do not lie on one way outward.
    #[error("group `{name}` is not a chain: joint `{joint}` lies beside the way to joint `{other}`")]
    NotAChain {
        /// The group.
        name: String,
        /// A joint beside the way.
        joint: String,
        /// The joint farthest out.
        other: String,
    },
    /// A link or joint that the URDF does not have.
    #[error("group `{group}`: the URDF has no {what} called `{name}`")]
    UnknownPart {
        /// The group.
        group: String,
        /// `link` or `joint`.
        what: &'static str,
        /// Its name.
        name: String,
    },
    /// A configuration that is not there.
    #[error("there is no configuration called `{name}`{}", group.as_ref().map(|g| format!(" of group `{g}`")).unwrap_or_default())]
    NoSuchState {
        /// The name asked for.
        name: String,
        /// The group asked for.
        group: Option<String>,
        /// The configurations there are.
        known: Vec<String>,
    },
    /// A configuration of several groups.
    #[error("configuration `{name}` exists in several groups: {}", groups.join(", "))]
    SeveralStates {
        /// The name.
        name: String,
        /// The groups.
        groups: Vec<String>,
    },
    /// A configuration that lacks a joint of the arm.
    #[error("configuration `{state}` has no position of joint `{joint}`")]
    NoPosition {
        /// The configuration.
        state: String,
        /// The joint.
        joint: String,
    },
    /// The URDF that the SRDF belongs to cannot be read.
    #[error("the URDF: {message}")]
    Urdf {
        /// The reason.
        message: String,
        /// The remedy.
        remedy: String,
    },
}

impl From<SrdfFault> for SrdfError {
    fn from(fault: SrdfFault) -> Self {
        Self { fault, line: None }
    }
}

impl SrdfError {
    /// A sentence on what to do about it.
    #[must_use]
    pub fn remedy(&self) -> String {
        match &self.fault {
            SrdfFault::Read { .. } => "give the path of an SRDF file in UTF-8 or, if it says so, ISO-8859-1".into(),
            SrdfFault::Malformed { .. } => "check the XML near the line named".into(),
            SrdfFault::NotSrdf { .. } => "give a file whose root is `<robot>` with `<group>` elements".into(),
            SrdfFault::Missing { attribute, .. } => format!("write `{attribute}=\"...\"`"),
            SrdfFault::Number { .. } => "write finite numbers in rad or m, separated by blanks".into(),
            SrdfFault::NoSuchGroup { known, .. } => format!("the groups are {}", known.join(", ")),
            SrdfFault::GroupLoop { .. } => "remove one of the groups from the other".into(),
            SrdfFault::EmptyGroup { .. } => "choose a group with a `<chain>` or with joints".into(),
            SrdfFault::NotAChain { .. } => "choose the group of a single arm, or give base and tip".into(),
            SrdfFault::UnknownPart { .. } => "use the URDF and the SRDF of the same robot".into(),
            SrdfFault::NoSuchState { known, .. } => format!("the configurations are {}", known.join(", ")),
            SrdfFault::SeveralStates { .. } => "name the group too".into(),
            SrdfFault::NoPosition { .. } => {
                "choose a configuration of the arm's own group, or give the positions".into()
            }
            SrdfFault::Urdf { remedy, .. } => remedy.clone(),
        }
    }
}
