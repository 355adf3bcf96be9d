//! Arms from URDF files: exact in what kinematics and dynamics need, blind to everything else.

mod chain;
mod error;
mod fault;
mod file;
mod gravity;
mod inertia;
mod limits;
mod mimic;
mod names;
mod remedy;
mod share;
mod tip;
mod tree;
mod values;

pub use error::{UrdfError, UrdfPlace};
pub use fault::{ForeignFormat, UrdfFault};
pub(crate) use file::UrdfFile;
pub(crate) use tree::Tree;

use crate::xml::{self, TextFault};
use crate::{Note, RobotDescription};
use std::path::Path;

/// Which part of a robot is the arm; both ends have defaults.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ChainEnds {
    /// Name of the base link; the root by default.
    pub base: Option<String>,
    /// Name of the tip link. By default the way outward is followed as long as a single branch moves (not into the fingers
    /// of a gripper) or a single one leads to a link called `tool0`, `flange`, `ee_link` or `tcp`; the tip is then the link
    /// of such a name that fixed joints lead to, or else the farthest one.
    pub tip: Option<String>,
}

impl RobotDescription {
    /// Reads an arm from a URDF file.
    ///
    /// # Errors
    ///
    /// The file cannot be read, or the reasons of [`RobotDescription::parse_urdf`].
    pub fn read_urdf(path: &Path, ends: &ChainEnds) -> Result<Self, UrdfError> {
        Self::parse_urdf(&Self::read_urdf_text(path)?, ends)
    }

    /// The text of a URDF file, for showing errors in it: UTF-8, or Latin-1 if its declaration says so.
    ///
    /// # Errors
    ///
    /// The file cannot be read, or is of another encoding.
    pub fn read_urdf_text(path: &Path) -> Result<String, UrdfError> {
        xml::read_text(path).map_err(|fault| {
            let path = path.to_owned();
            match fault {
                TextFault::Read(message) => UrdfFault::Read { path, message }.into(),
                TextFault::Encoding { declared, line } => UrdfFault::Encoding { path, declared, line }.into(),
            }
        })
    }

    /// Reads an arm from the text of a URDF.
    ///
    /// The joints between base and tip make the arm: revolute and continuous ones turn, prismatic ones slide, fixed ones
    /// are merged, and those that mimic a joint of the arm move with it. A link's mass includes all that fixed joints attach
    /// to it, and all that hangs on it by joints outside the arm, held at zero; links that no joint of the arm moves have
    /// none. Gravity is along -z of the root link. Limits of 0 or infinity count as none. Guesses and what is left aside
    /// are listed in [`RobotDescription::notes`].
    ///
    /// Meshes, collision bodies, materials, transmissions and the like are not looked at, and may be malformed.
    ///
    /// # Errors
    ///
    /// The first element that cannot be used, by name and line.
    pub fn parse_urdf(text: &str, ends: &ChainEnds) -> Result<Self, UrdfError> {
        parse(text, ends).map_err(|mut error| {
            if let Some(place) = &mut error.place {
                place.line = xml::line(text, place.bytes.start);
            }
            error
        })
    }
}

fn parse(text: &str, ends: &ChainEnds) -> Result<RobotDescription, UrdfError> {
    let file = UrdfFile::parse(text)?;
    let tree = Tree::new(&file)?;
    let base = match &ends.base {
        Some(base) => tree.link(base)?.name.as_str(),
        None => tree.root()?,
    };
    if let Some(tip) = &ends.tip {
        return chain::describe(&file, &tree, base, &tree.link(tip)?.name);
    }
    let guess = tip::guess(&tree, base)?;
    let mut robot = chain::describe(&file, &tree, base, guess.tip)?;
    robot.tip_alternatives = guess.alternatives.into_iter().map(str::to_owned).collect();
    if !robot.tip_alternatives.is_empty() {
        let alternatives = robot.tip_alternatives.clone();
        robot.notes.insert(0, Note::TipChosen { tip: robot.tip.clone(), alternatives });
    }
    Ok(robot)
}
