use crate::Pose;
use nalgebra::{Rotation3, Translation3, Unit, Vector3};
use serde::Serialize;

/// Kind of motion of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum JointKind {
    /// Turns about its axis; position in rad.
    Revolute,
    /// Slides along its axis; position in m.
    Prismatic,
}

/// One joint: where it sits in the frame of the link before it, and how it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Joint frame in the frame of the link before it (of the base for the first joint).
    pub origin: Pose,
    /// Axis of motion in the joint frame.
    pub axis: Unit<Vector3<f64>>,
    /// Revolute or prismatic.
    pub kind: JointKind,
    /// Added to the joint position before it is applied, rad or m.
    pub offset: f64,
}

impl Joint {
    /// The transform that the joint's motion adds.
    pub(crate) fn motion(&self, q: f64) -> Pose {
        let q = q + self.offset;
        match self.kind {
            JointKind::Revolute => {
                Pose::from_parts(Translation3::identity(), Rotation3::from_axis_angle(&self.axis, q))
            }
            JointKind::Prismatic => {
                Pose::from_parts(Translation3::from(self.axis.into_inner() * q), Rotation3::identity())
            }
        }
    }
}
