use super::file::{Joint, JointType};
use super::tree::Tree;
use super::values::SHORTEST;
use super::{UrdfError, UrdfFault};
use crate::{JointKind, Pose};
use nalgebra::{Unit, Vector3};

/// A joint's motion as a multiple of that of a joint that moves on its own: `q = ratio q_leader + offset`.
pub(super) struct Mimicry<'a> {
    /// The joint that leads at the end of the line.
    pub(super) leader: &'a Joint,
    pub(super) ratio: f64,
    pub(super) offset: f64,
}

/// The leader that a joint mimics, by way of other followers too, with ratio and offset; `None` if it moves on its own. Any
/// element will do as a mimicked joint, a fixed one stands at zero.
pub(super) fn mimicry<'a>(tree: &Tree<'a>, joint: &'a Joint) -> Result<Option<Mimicry<'a>>, UrdfError> {
    let mut found = Mimicry { leader: joint, ratio: 1.0, offset: 0.0 };
    let mut steps = 0;
    while let Some((next, multiplier, offset)) = mimicked(tree, found.leader)? {
        found.offset += found.ratio * offset;
        found.ratio *= multiplier;
        found.leader = next;
        steps += 1;
        if steps > tree.joints.len() {
            return Err(UrdfFault::MimicLoop { joint: joint.name.clone() }.at(joint.owner().place));
        }
    }
    if !(found.ratio.is_finite() && found.offset.is_finite()) {
        let part = "mimic".to_owned();
        let fault = UrdfFault::NotFinite { what: "joint", name: joint.name.clone(), part };
        return Err(fault.at(joint.owner().place));
    }
    Ok((steps > 0).then_some(found))
}

/// The joint that `<mimic>` names, the multiplier and the offset.
fn mimicked<'a>(tree: &Tree<'a>, joint: &Joint) -> Result<Option<(&'a Joint, f64, f64)>, UrdfError> {
    let Some(element) = joint.element.child("mimic").filter(|_| joint.moves()) else { return Ok(None) };
    let missing = || UrdfFault::Missing { joint: joint.name.clone(), part: "joint to mimic" }.at(&element.tag);
    let name = element.value("joint").ok_or_else(missing)?;
    let owner = joint.owner();
    let multiplier = owner.finite::<1>(element, "multiplier")?.map_or(1.0, |[x]| x);
    let offset = owner.finite::<1>(element, "offset")?.map_or(0.0, |[x]| x);
    let unknown = || UrdfFault::UnknownLeader { joint: joint.name.clone(), leader: name.to_owned() }.at(&element.tag);
    let leader = tree.joints.get(name).copied().ok_or_else(unknown)?;
    Ok(Some((leader, multiplier, offset)))
}

/// The kind and axis of a joint that turns or slides.
pub(super) fn motion(joint: &Joint) -> Result<(JointKind, Unit<Vector3<f64>>), UrdfError> {
    let kind = match &joint.kind {
        JointType::Revolute | JointType::Continuous => JointKind::Revolute,
        JointType::Prismatic => JointKind::Prismatic,
        JointType::Fixed => return Err(unsupported(joint, "fixed")),
        JointType::Other(kind) => return Err(unsupported(joint, kind)),
    };
    let axis = joint.element.child("axis");
    let given = axis.map_or(Ok(None), |element| joint.owner().numbers::<3>(element, "xyz"))?;
    let direction = Vector3::from(given.unwrap_or([1.0, 0.0, 0.0]));
    let unit = Unit::try_new(direction, SHORTEST).filter(|a| a.iter().all(|x| x.is_finite()));
    let place = axis.map_or(&joint.element.tag, |element| &element.tag);
    Ok((kind, unit.ok_or_else(|| UrdfFault::Axis { joint: joint.name.clone() }.at(place))?))
}

fn unsupported(joint: &Joint, kind: &str) -> UrdfError {
    UrdfFault::UnsupportedJoint { joint: joint.name.clone(), kind: kind.to_owned() }.at(joint.owner().place)
}

/// The motion of a joint that is held at a position.
pub(super) fn held(joint: &Joint, position: f64) -> Result<Pose, UrdfError> {
    if position == 0.0 {
        return Ok(Pose::identity());
    }
    let (kind, axis) = motion(joint)?;
    Ok(crate::Joint { origin: Pose::identity(), axis, kind, offset: 0.0 }.motion(position))
}
