use super::values::{Owner, is_expression};
use super::{ForeignFormat, UrdfError, UrdfFault};
use crate::Note;
use crate::xml::{self, Element};

/// The links and joints of a URDF, their numbers not yet read.
pub(crate) struct UrdfFile {
    pub(crate) name: String,
    pub(crate) links: Vec<Link>,
    pub(crate) joints: Vec<Joint>,
    pub(crate) version: Version,
    pub(crate) notes: Vec<Note>,
}

/// The rules by which a file is read.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Version {
    /// Missing limits are zero, acceleration, jerk and quaternions are read by nobody.
    V1,
    /// From 1.2 on: missing limits are open, acceleration, jerk and quaternions count.
    V1_2,
}

/// A link of the file.
pub(crate) struct Link {
    pub(crate) name: String,
    pub(crate) element: Element,
}

/// A joint of the file.
pub(crate) struct Joint {
    pub(crate) name: String,
    pub(crate) kind: JointType,
    pub(crate) parent: String,
    pub(crate) child: String,
    pub(crate) element: Element,
}

/// The type of a joint.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum JointType {
    Revolute,
    Continuous,
    Prismatic,
    Fixed,
    /// Of no use in an arm: floating, planar, or unknown.
    Other(String),
}

/// The elements that kinematics and dynamics need, and those that tell other formats.
fn wanted(depth: usize, name: &str) -> bool {
    let known: &[&str] = match depth {
        1 => &["link", "joint", "group", "group_state", "disable_collisions", "virtual_joint"],
        2 => &["inertial", "origin", "axis", "parent", "child", "limit", "mimic", "safety_controller", "dynamics"],
        3 => &["origin", "mass", "inertia"],
        _ => &[],
    };
    known.contains(&name) || depth < 3 && name.starts_with(XACRO)
}

const XACRO: &str = "xacro:";

impl UrdfFile {
    /// Reads the structure of a text: names, types, parents and children.
    pub(crate) fn parse(text: &str) -> Result<Self, UrdfError> {
        let root = xml::read(text, wanted)
            .map_err(|fault| UrdfFault::Malformed { message: fault.message }.at(&fault.bytes))?;
        check_format(&root)?;
        let name = root.value("name").unwrap_or_default().to_owned();
        let (version, note) = version(&root, &name);
        let mut file = Self { name, links: Vec::new(), joints: Vec::new(), version, notes: Vec::from_iter(note) };
        for element in root.children {
            match element.name.as_str() {
                "link" => file.links.push(Link { name: name_of(&element, "link")?, element }),
                "joint" => file.joints.push(joint(element)?),
                _ => {}
            }
        }
        if file.links.is_empty() {
            return Err(UrdfFault::NoLinks { robot: file.name }.at(&root.tag));
        }
        Ok(file)
    }
}

/// Recognises by root and children what is no URDF.
fn check_format(root: &Element) -> Result<(), UrdfError> {
    let other = |format| Err(UrdfFault::OtherFormat { format }.at(&root.tag));
    match root.name.as_str() {
        "robot" => {}
        "sdf" | "gazebo" => return other(ForeignFormat::Sdf),
        "mujoco" | "mujocoinclude" => return other(ForeignFormat::Mjcf),
        name => return Err(UrdfFault::NotARobot { root: name.to_owned() }.at(&root.tag)),
    }
    let inner = root.children.iter().flat_map(|child| std::iter::once(child).chain(&child.children));
    if let Some(element) = inner.into_iter().find(|element| element.name.starts_with(XACRO)) {
        return Err(UrdfFault::Xacro { found: format!("it has the element `<{}>`", element.name) }.at(&element.tag));
    }
    // Expanded files often keep the declaration: it tells a xacro file only where nothing else is.
    if root.child("link").is_none() && root.attribute("xmlns:xacro").is_some() {
        return Err(
            UrdfFault::Xacro { found: "its root declares `xmlns:xacro` and there is no link".into() }.at(&root.tag)
        );
    }
    if root.child("link").is_none() && root.children.iter().any(|child| child.name != "joint") {
        return other(ForeignFormat::Srdf);
    }
    Ok(())
}

/// The rules of the root's `version`, with a note if it is unheard of.
fn version(root: &Element, robot: &str) -> (Version, Option<Note>) {
    let Some(text) = root.value("version") else { return (Version::V1, None) };
    let (major, minor) = text.split_once('.').unwrap_or((text, "0"));
    let numbers = (major.parse::<u32>(), minor.parse::<u32>());
    let note = |read_as| Some(Note::UnknownVersion { robot: robot.to_owned(), version: text.to_owned(), read_as });
    match numbers {
        (Ok(1), Ok(0 | 1)) => (Version::V1, None),
        (Ok(1), Ok(2)) => (Version::V1_2, None),
        (Ok(major), Ok(_)) if major >= 1 => (Version::V1_2, note("version 1.2")),
        _ => (Version::V1, note("version 1.0")),
    }
}

fn name_of(element: &Element, what: &'static str) -> Result<String, UrdfError> {
    let name = element.attribute("name").filter(|name| !name.value.is_empty());
    let Some(name) = name else { return Err(UrdfFault::NoName { what }.at(&element.tag)) };
    if is_expression(&name.value) {
        return Err(UrdfFault::Xacro { found: format!("a {what} called `{}`", name.value) }.at(&name.bytes));
    }
    Ok(name.value.clone())
}

fn joint(element: Element) -> Result<Joint, UrdfError> {
    let name = name_of(&element, "joint")?;
    let missing = |part| UrdfFault::Missing { joint: name.clone(), part }.at(&element.tag);
    let link = |end: &str, part| {
        let link = element.child(end).and_then(|end| end.attribute("link"));
        link.map(|link| link.value.clone()).ok_or_else(|| missing(part))
    };
    let kind = match element.value("type").ok_or_else(|| missing("type"))? {
        "revolute" => JointType::Revolute,
        "continuous" => JointType::Continuous,
        "prismatic" => JointType::Prismatic,
        "fixed" => JointType::Fixed,
        other => JointType::Other(other.to_owned()),
    };
    let (parent, child) = (link("parent", "parent link")?, link("child", "child link")?);
    Ok(Joint { name, kind, parent, child, element })
}

impl Link {
    pub(super) fn owner(&self) -> Owner<'_> {
        owner("link", &self.name, &self.element)
    }
}

impl Joint {
    pub(super) fn owner(&self) -> Owner<'_> {
        owner("joint", &self.name, &self.element)
    }

    /// True if the joint moves.
    pub(crate) fn moves(&self) -> bool {
        self.kind != JointType::Fixed
    }
}

fn owner<'a>(what: &'static str, name: &'a str, element: &'a Element) -> Owner<'a> {
    Owner { what, name, place: element.attribute("name").map_or(&element.tag, |name| &name.bytes) }
}
