//! Groups and named configurations of a robot, as its SRDF file gives them for the links and joints of a URDF.
//!
//! ```
//! use slideway_robot::srdf::Srdf;
//!
//! let text = r#"<robot name="r">
//!   <group name="arm"><chain base_link="base" tip_link="tool0"/></group>
//!   <group_state name="home" group="arm"><joint name="j1" value="0.5"/></group_state>
//! </robot>"#;
//! let srdf = Srdf::parse(text)?;
//! assert_eq!(srdf.groups[0].chains[0].tip, "tool0");
//! assert_eq!(srdf.states[0].joints[0].values, [0.5]);
//! # Ok::<(), slideway_robot::srdf::SrdfError>(())
//! ```

mod configuration;
mod ends;
mod error;
mod read;

pub use error::{SrdfError, SrdfFault};

/// An SRDF file, as far as it tells arms and configurations.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Srdf {
    /// Name of the robot.
    pub name: String,
    /// Its groups, in the order of the file.
    pub groups: Vec<Group>,
    /// Its named configurations, in the order of the file.
    pub states: Vec<GroupState>,
}

/// A set of links and joints, for instance an arm or a gripper.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Group {
    /// Its name.
    pub name: String,
    /// Chains from a base link to a tip link; an arm has one.
    pub chains: Vec<Chain>,
    /// Joints named one by one.
    pub joints: Vec<String>,
    /// Links named one by one, each standing for the joint that carries it.
    pub links: Vec<String>,
    /// Other groups that are part of it.
    pub groups: Vec<String>,
}

/// A way from one link outward to another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chain {
    /// The link it starts from.
    pub base: String,
    /// The link it ends at.
    pub tip: String,
}

/// A configuration with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct GroupState {
    /// Its name.
    pub name: String,
    /// The group it belongs to.
    pub group: String,
    /// The joints with their positions, in the order of the file.
    pub joints: Vec<JointState>,
}

/// The position of a joint in a named configuration.
#[derive(Clone, Debug, PartialEq)]
pub struct JointState {
    /// The joint.
    pub name: String,
    /// Its position, rad or m; several numbers for joints of more than one freedom.
    pub values: Vec<f64>,
}
