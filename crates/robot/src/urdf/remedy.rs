use super::names::list;
use super::{ForeignFormat, UrdfFault};

impl UrdfFault {
    /// A sentence on what to do about it.
    #[must_use]
    pub fn remedy(&self) -> String {
        match self {
            Self::Read { .. } => "give the path of a URDF file".into(),
            Self::Encoding { .. } => {
                "save the file as UTF-8, or declare its encoding as `ISO-8859-1` if it is that".into()
            }
            Self::Malformed { .. } => "check the XML near the place named".into(),
            Self::Xacro { .. } => XACRO.into(),
            Self::OtherFormat { format } => format.remedy().into(),
            Self::NotARobot { .. } => "give a file whose root element is `<robot>`".into(),
            Self::NoLinks { .. } => "add `<link>` and `<joint>` elements".into(),
            Self::NoName { what } => format!("write `<{what} name=\"...\">`"),
            Self::Missing { part, .. } => format!("give the joint its {part}"),
            Self::Number { .. } => "write numbers with a decimal point, without units".into(),
            Self::NamedTwice { what, .. } => format!("give each {what} a name of its own"),
            Self::UnknownLink { link, .. } => format!("add `<link name=\"{link}\"/>`, or correct the joint"),
            Self::TwoParents { .. } => "a URDF is a tree: remove one of the joints".into(),
            Self::Loop { .. } => "a URDF is a tree: let one link have no parent".into(),
            Self::SeveralRoots { .. } => "choose the base link, or connect the others with fixed joints".into(),
            Self::NoSuchLink { known, .. } => format!("the links are {}", list(known)),
            Self::NotReachable { .. } => "choose a base on the way from the root to the tip, or another tip".into(),
            Self::SeveralArms { tips, .. } => format!("choose the tip link of one of the arms: {}", list(tips)),
            Self::NoJoints { .. } => "choose a tip beyond a moving joint".into(),
            Self::UnsupportedJoint { .. } => "choose base and tip so that this joint is not between them".into(),
            Self::UnknownLeader { .. } => "correct the joint's `<mimic>` element".into(),
            Self::MimicLoop { .. } => "let one of the joints move on its own: remove its `<mimic>` element".into(),
            Self::Axis { .. } => "give the axis a direction, for example `<axis xyz=\"0 0 1\"/>`".into(),
            Self::Quaternion { .. } => "write a unit quaternion, for example `quat_xyzw=\"0 0 0 1\"`".into(),
            Self::NotFinite { .. } => "write finite numbers".into(),
            Self::Body { .. } => "correct the link's `<inertial>` element".into(),
            Self::Drive { .. } => "correct the joint's `<dynamics>` element".into(),
            Self::Limits(error) => error.remedy(),
        }
    }
}

impl ForeignFormat {
    /// A sentence on what to do with such a file.
    #[must_use]
    pub fn remedy(self) -> &'static str {
        match self {
            Self::Sdf => "give the URDF that the SDF was made from: Gazebo turns URDF into SDF, not back",
            Self::Mjcf => "give the robot's URDF; MuJoCo reads URDF too, so most models have one beside them",
            Self::Srdf => "give the URDF that belongs to it; the SRDF names base and tip of its groups",
        }
    }
}

const XACRO: &str = "expand it first: `pip install xacrodoc`, then `xacrodoc in.xacro -o out.urdf`; \
                     with ROS, `xacro in.xacro > out.urdf`";
