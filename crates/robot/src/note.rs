use crate::{LimitKind, PositionRange};
use std::fmt;

/// A remark on how a robot was read, its `Display` a full sentence that names the joint or link.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Note {
    /// The tip was chosen here; other links could have been meant.
    TipChosen {
        /// The link taken.
        tip: String,
        /// The other candidates.
        alternatives: Vec<String>,
    },
    /// The base is turned against the root link, whose -z is the direction of gravity.
    TiltedBase {
        /// The base link.
        base: String,
        /// The root link.
        root: String,
        /// Gravitational acceleration in the base frame, m/s².
        gravity: [f64; 3],
    },
    /// Joints between the root and the base move the base; they are held at zero.
    BaseMoves {
        /// The base link.
        base: String,
        /// The joints.
        joints: Vec<String>,
    },
    /// A joint outside the arm, whose load is held.
    Aside {
        /// The joint.
        joint: String,
        /// The joint it mimics, if it does.
        leader: Option<String>,
        /// Where it is held, rad or m.
        position: f64,
    },
    /// A joint outside the arm that mimics a joint of the arm; its load is held as if that joint stood at zero.
    FollowsOutside {
        /// The joint.
        joint: String,
        /// The arm's joint it mimics.
        leader: String,
        /// Where it is held, rad or m.
        position: f64,
    },
    /// A joint of the arm that moves with another one.
    Follows {
        /// The joint.
        joint: String,
        /// The arm's joint that leads it.
        leader: String,
        /// Its motion per motion of the leader.
        ratio: f64,
        /// Its position where the leader is at zero, rad or m.
        offset: f64,
    },
    /// A follower's own limits bind the joint that leads it.
    FollowerLimits {
        /// The follower.
        joint: String,
        /// The joint that leads it.
        leader: String,
    },
    /// A joint between base and tip that mimics a joint outside the arm.
    HeldMimic {
        /// The joint.
        joint: String,
        /// The joint it mimics.
        leader: String,
        /// Where it is held, rad or m.
        position: f64,
    },
    /// A joint held at a position on request.
    Locked {
        /// The joint.
        joint: String,
        /// Where, rad or m.
        position: f64,
    },
    /// A joint that turns or slides between 0 and 0: taken as a joint without a range, not as a frozen one.
    NoRange {
        /// The joint.
        joint: String,
    },
    /// Limits of zero, which are no limits.
    ZeroLimit {
        /// The joints.
        joints: Vec<String>,
        /// The limit.
        limit: LimitKind,
    },
    /// Limits that the file ought to give and does not.
    MissingLimit {
        /// The joints.
        joints: Vec<String>,
        /// The limit.
        limit: LimitKind,
    },
    /// Soft limits that narrow the range.
    SoftLimits {
        /// The joint.
        joint: String,
        /// The range that remains.
        range: PositionRange,
    },
    /// An attribute that counts only in newer files.
    NeedsVersion {
        /// The joint.
        joint: String,
        /// The attribute.
        attribute: &'static str,
    },
    /// A version of the format that is not known.
    UnknownVersion {
        /// The name of the robot.
        robot: String,
        /// The version it gives.
        version: String,
        /// The version it is read as.
        read_as: &'static str,
    },
    /// An `<inertial>` element without some of its parts.
    IncompleteInertial {
        /// The link.
        link: String,
        /// The part that counts as zero.
        missing: &'static str,
    },
    /// A moment of inertia below zero by no more than rounding, or of a speck of dust.
    NegativeMoment {
        /// The link.
        link: String,
        /// The principal moment, kg m².
        moment: f64,
    },
    /// Principal moments of which one exceeds the sum of the others: no rigid body has them.
    Triangle {
        /// The link.
        link: String,
        /// The principal moments in ascending order, kg m².
        moments: [f64; 3],
    },
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TipChosen { tip, alternatives } => {
                let others = alternatives.iter().map(|link| format!("`{link}`")).collect::<Vec<_>>().join(", ");
                write!(f, "link `{tip}` was taken as the tip; the others that could be meant are {others}")
            }
            Self::TiltedBase { base, root, gravity: [x, y, z] } => write!(
                f,
                "link `{base}` is tilted against the root `{root}`: gravity in its frame is ({x:.4}, {y:.4}, {z:.4}) m/s²"
            ),
            Self::BaseMoves { base, joints } => {
                write!(f, "link `{base}` is moved by {}, held at zero: gravity is that of this posture", named(joints))
            }
            Self::Locked { joint, position } => write!(f, "joint `{joint}` is locked at {position}"),
            Self::Aside { .. } | Self::FollowsOutside { .. } => self.outside(f),
            Self::Follows { .. } | Self::FollowerLimits { .. } | Self::HeldMimic { .. } => self.mimics(f),
            Self::UnknownVersion { robot, version, read_as } => {
                write!(f, "robot `{robot}` is of version `{version}`, which is not known: it was read as {read_as}")
            }
            Self::IncompleteInertial { .. } | Self::NegativeMoment { .. } | Self::Triangle { .. } => self.inertia(f),
            _ => self.limits(f),
        }
    }
}

impl Note {
    fn outside(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Aside { joint, leader, position } => {
                let mimics = leader.as_ref().map(|leader| format!(" (it mimics `{leader}`)")).unwrap_or_default();
                let at = if *position == 0.0 { "its zero position".to_owned() } else { format!("{position}") };
                write!(f, "joint `{joint}`{mimics} is not part of the arm: what it carries is held at {at}")
            }
            Self::FollowsOutside { joint, leader, position } => write!(
                f,
                "joint `{joint}` mimics `{leader}` of the arm but lies beside the arm: what it carries is held at {position} \
                 and does not move with `{leader}`, which makes the dynamics approximate"
            ),
            _ => Ok(()),
        }
    }

    fn mimics(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Follows { joint, leader, ratio, offset } => {
                write!(f, "joint `{joint}` moves with joint `{leader}`: its position is {ratio} times that")?;
                if *offset == 0.0 { Ok(()) } else { write!(f, " plus {offset}") }
            }
            Self::FollowerLimits { joint, leader } => {
                write!(f, "joint `{joint}` follows joint `{leader}`, and its limits narrow those of `{leader}`")
            }
            Self::HeldMimic { joint, leader, position } => write!(
                f,
                "joint `{joint}` mimics joint `{leader}`, which is not part of the arm: it is held at {position}"
            ),
            _ => Ok(()),
        }
    }

    fn inertia(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::IncompleteInertial { link, missing } => {
                write!(f, "link `{link}`: its `<inertial>` has no {missing}, which counts as zero")
            }
            Self::NegativeMoment { link, moment } => {
                write!(f, "link `{link}` has the negative principal moment {moment:.3e} kg m², as small as rounding")
            }
            Self::Triangle { link, moments: [a, b, c] } => write!(
                f,
                "link `{link}`: no rigid body has its principal moments {a:.3e}, {b:.3e} and {c:.3e} kg m², \
                 the largest exceeding the sum of the others"
            ),
            _ => Ok(()),
        }
    }

    fn limits(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoRange { joint } => write!(
                f,
                "joint `{joint}`: its range from 0 to 0 is read as no range; a joint that cannot move is of type `fixed`"
            ),
            Self::ZeroLimit { joints, limit } => {
                write!(f, "{}: the {1} limit of 0 is read as no {1} limit", named(joints), limit.name())
            }
            Self::MissingLimit { joints, limit } => {
                write!(f, "{}: the file gives no {} limit", named(joints), limit.name())
            }
            Self::SoftLimits { joint, range } => write!(
                f,
                "joint `{joint}`: its safety controller narrows the range to {} ... {}",
                range.lower, range.upper
            ),
            Self::NeedsVersion { joint, attribute } => write!(
                f,
                "joint `{joint}`: `{attribute}` was not read, for it counts from `<robot version=\"1.2\">` on"
            ),
            _ => Ok(()),
        }
    }
}

/// Joints by their names.
fn named(joints: &[String]) -> String {
    let names = joints.iter().map(|joint| format!("`{joint}`")).collect::<Vec<_>>().join(", ");
    format!("joint{} {names}", if joints.len() == 1 { "" } else { "s" })
}
