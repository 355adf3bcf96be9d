use super::UrdfError;
use super::tree::{Tree, moves};
use crate::{
    Drive, Friction, Joint, JointDescription, JointKind, JointLimits, LinkInertia, Pose, PositionRange,
    RobotDescription, RobotError,
};
use nalgebra::{Matrix3, Rotation3, Translation3, Unit, Vector3};
use urdf_rs::{JointType, Link};

/// Shortest axis that has a direction: a unit vector typed with a few digits is far from it.
const SHORTEST_AXIS: f64 = 1e-6;

/// The arm between two links of a checked tree.
pub(super) fn describe(name: &str, tree: &Tree<'_>, base: &str, tip: &str) -> Result<RobotDescription, UrdfError> {
    let chain = tree.chain(base, tip)?;
    let mut description = RobotDescription {
        name: name.to_owned(),
        base: base.to_owned(),
        tip: tip.to_owned(),
        joints: Vec::new(),
        tool: Pose::identity(),
        notes: Vec::new(),
        dh: None,
    };
    // Pose of the present link in the frame of the last joint that moves.
    let mut pose = Pose::identity();
    for (i, joint) in chain.iter().enumerate() {
        pose *= origin(joint)?;
        if moves(joint) {
            description.joints.push(moving_joint(joint, pose)?);
            pose = Pose::identity();
        }
        let next = chain.get(i + 1).map(|j| j.name.as_str());
        let carried = carried(tree, &joint.child.link, next, &mut description.notes)?;
        if let Some(last) = description.joints.last_mut() {
            last.link = last.link.joined(&carried.seen_from(&pose));
        }
    }
    description.tool = pose;
    if description.joints.is_empty() {
        return Err(UrdfError::NoJoints { base: base.to_owned(), tip: tip.to_owned() });
    }
    Ok(description)
}

fn finite(numbers: &[f64], what: &'static str, name: &str, part: &'static str) -> Result<(), UrdfError> {
    if numbers.iter().all(|x| x.is_finite()) {
        Ok(())
    } else {
        Err(UrdfError::NotFinite { what, name: name.to_owned(), part })
    }
}

/// `rpy` turns about the fixed x, y and z axes in this order.
fn pose(pose: &urdf_rs::Pose) -> Pose {
    let ([x, y, z], [roll, pitch, yaw]) = (pose.xyz.0, pose.rpy.0);
    Pose::from_parts(Translation3::new(x, y, z), Rotation3::from_euler_angles(roll, pitch, yaw))
}

fn origin(joint: &urdf_rs::Joint) -> Result<Pose, UrdfError> {
    finite(&joint.origin.xyz.0, "joint", &joint.name, "origin")?;
    finite(&joint.origin.rpy.0, "joint", &joint.name, "origin")?;
    Ok(pose(&joint.origin))
}

fn moving_joint(joint: &urdf_rs::Joint, origin: Pose) -> Result<JointDescription, UrdfError> {
    let unsupported = |kind| Err(UrdfError::UnsupportedJoint { joint: joint.name.clone(), kind });
    let kind = match joint.joint_type {
        JointType::Revolute | JointType::Continuous => JointKind::Revolute,
        JointType::Prismatic => JointKind::Prismatic,
        JointType::Floating => return unsupported("floating"),
        JointType::Planar => return unsupported("planar"),
        JointType::Spherical => return unsupported("spherical"),
        JointType::Fixed => return unsupported("fixed"),
    };
    if let Some(mimic) = &joint.mimic {
        return Err(UrdfError::Mimic { joint: joint.name.clone(), leader: mimic.joint.clone() });
    }
    let axis = Vector3::from(joint.axis.xyz.0);
    let axis = Unit::try_new(axis, SHORTEST_AXIS).filter(|a| a.iter().all(|x| x.is_finite()));
    let Some(axis) = axis else { return Err(UrdfError::Axis { joint: joint.name.clone() }) };
    let friction = joint.dynamics.as_ref().map_or_else(Friction::default, |d| Friction {
        viscous: d.damping,
        forward: d.friction,
        backward: d.friction,
    });
    let drive = Drive { reflected_inertia: 0.0, friction };
    drive.validate().map_err(|fault| UrdfError::Drive { joint: joint.name.clone(), fault })?;
    let limits = limits(joint).map_err(UrdfError::Limits)?;
    Ok(JointDescription {
        name: joint.name.clone(),
        joint: Joint { origin, axis, kind, offset: 0.0 },
        limits,
        link: LinkInertia::default(),
        drive,
    })
}

/// Zero and infinity mean no limit: zero is what a missing element reads as.
fn limits(joint: &urdf_rs::Joint) -> Result<JointLimits, RobotError> {
    let limit = &joint.limit;
    let some = |value: f64| if value == 0.0 || value == f64::INFINITY { None } else { Some(value) };
    let range = PositionRange { lower: limit.lower, upper: limit.upper };
    let bounded = joint.joint_type != JointType::Continuous
        && (limit.lower, limit.upper) != (0.0, 0.0)
        && (limit.lower, limit.upper) != (f64::NEG_INFINITY, f64::INFINITY);
    let limits =
        JointLimits { position: bounded.then_some(range), velocity: some(limit.velocity), effort: some(limit.effort) };
    limits.validate(&joint.name)?;
    Ok(limits)
}

fn inertia(link: &Link) -> Result<LinkInertia, UrdfError> {
    let inertial = &link.inertial;
    let i = &inertial.inertia;
    finite(&inertial.origin.xyz.0, "link", &link.name, "inertial")?;
    finite(&inertial.origin.rpy.0, "link", &link.name, "inertial")?;
    let matrix = Matrix3::new(i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz);
    let body = LinkInertia { mass: inertial.mass.value, com: Vector3::zeros(), inertia: matrix };
    body.validate().map_err(|fault| UrdfError::Body { link: link.name.clone(), fault })?;
    Ok(body.seen_from(&pose(&inertial.origin)))
}

/// A link with everything that hangs on it outside the arm, in its own frame; `next` is the joint through which the arm
/// goes on.
fn carried(tree: &Tree<'_>, link: &str, next: Option<&str>, notes: &mut Vec<String>) -> Result<LinkInertia, UrdfError> {
    let mut body = inertia(tree.link(link)?)?;
    let mut waiting = vec![(link.to_owned(), Pose::identity())];
    while let Some((at, pose)) = waiting.pop() {
        for joint in tree.children(&at).iter().filter(|j| Some(j.name.as_str()) != next) {
            let pose = pose * origin(joint)?;
            if moves(joint) {
                notes.push(aside(joint));
            }
            body = body.joined(&inertia(tree.link(&joint.child.link)?)?.seen_from(&pose));
            waiting.push((joint.child.link.clone(), pose));
        }
    }
    Ok(body)
}

/// A note on a joint outside the arm.
fn aside(joint: &urdf_rs::Joint) -> String {
    let mimics = joint.mimic.as_ref().map(|m| format!(" (it mimics `{}`)", m.joint)).unwrap_or_default();
    format!("joint `{}`{mimics} is not part of the arm: what it carries is held at its zero position", joint.name)
}
