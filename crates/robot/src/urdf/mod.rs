//! Arms from URDF files.

mod chain;
mod depth;
mod error;
mod tree;

pub use error::UrdfError;

use crate::RobotDescription;
use std::path::Path;
use tree::Tree;

/// Which part of a robot is the arm; both ends have defaults.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ChainEnds {
    /// Name of the base link; the root by default.
    pub base: Option<String>,
    /// Name of the tip link. By default the way outward is followed as long as a single branch moves (not into the fingers
    /// of a gripper), then through fixed joints as far as they lead.
    pub tip: Option<String>,
}

impl RobotDescription {
    /// Reads an arm from a URDF file.
    ///
    /// # Errors
    ///
    /// The file cannot be read, or what [`RobotDescription::parse_urdf`] refuses.
    pub fn read_urdf(path: &Path, ends: &ChainEnds) -> Result<Self, UrdfError> {
        Self::parse_urdf(&Self::read_urdf_text(path)?, ends)
    }

    /// The text of a URDF file, for showing errors in it.
    ///
    /// # Errors
    ///
    /// The file cannot be read.
    pub fn read_urdf_text(path: &Path) -> Result<String, UrdfError> {
        std::fs::read_to_string(path)
            .map_err(|error| UrdfError::Read { path: path.to_owned(), message: error.to_string() })
    }

    /// Reads an arm from the text of a URDF.
    ///
    /// The joints between base and tip make the arm: revolute and continuous ones turn, prismatic ones slide, fixed ones
    /// are merged. A link's mass includes all that fixed joints attach to it, and all that hangs on it by joints outside
    /// the arm, at their zero position. Limits of 0 or infinity count as none. What is left aside is listed in
    /// [`RobotDescription::notes`]. Meshes, transmissions and materials are not looked at.
    ///
    /// # Errors
    ///
    /// The first element that cannot be used, by name.
    pub fn parse_urdf(text: &str, ends: &ChainEnds) -> Result<Self, UrdfError> {
        depth::check(text)?;
        let robot =
            urdf_rs::read_from_string(text).map_err(|error| UrdfError::Malformed { message: error.to_string() })?;
        let tree = Tree::new(&robot)?;
        let base = match &ends.base {
            Some(base) => tree.link(base)?.name.as_str(),
            None => tree.root()?,
        };
        let tip = match &ends.tip {
            Some(tip) => tree.link(tip)?.name.as_str(),
            None => tree.default_tip(base)?,
        };
        chain::describe(&robot.name, &tree, base, tip)
    }
}
