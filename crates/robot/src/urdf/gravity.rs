use super::UrdfError;
use super::mimic::{held, mimicry};
use super::tree::Tree;
use crate::{GRAVITY, Note, Pose};
use nalgebra::Vector3;

/// Tilt below which a base counts as upright, rad: right angles are typed with four digits at the least, and a smaller
/// tilt is no one's intention. It is only left unsaid; gravity is turned by it all the same.
const UPRIGHT: f64 = 1e-6;

/// Gravitational acceleration in the frame of the base, m/s²: along -z of the root that the base hangs on. Joints that move
/// the base are held at zero.
pub(super) fn in_base(
    tree: &Tree<'_>,
    base: &str,
    quaternions: bool,
    notes: &mut Vec<Note>,
) -> Result<Vector3<f64>, UrdfError> {
    let way = tree.way_to(base);
    let mut pose = Pose::identity();
    let mut movers = Vec::new();
    for joint in &way {
        pose *= joint.owner().origin(&joint.element, quaternions)?;
        if joint.moves() {
            let position = mimicry(tree, joint)?.map_or(0.0, |mimicry| mimicry.offset);
            pose *= held(joint, position)?;
            movers.push(joint.name.clone());
        }
    }
    let gravity = pose.rotation.inverse() * GRAVITY;
    if !movers.is_empty() {
        notes.push(Note::BaseMoves { base: base.to_owned(), joints: movers });
    }
    if (gravity - GRAVITY).norm() > UPRIGHT * GRAVITY.norm() {
        let root = way.first().map_or_else(|| base.to_owned(), |joint| joint.parent.clone());
        notes.push(Note::TiltedBase { base: base.to_owned(), root, gravity: gravity.into() });
    }
    Ok(gravity)
}
