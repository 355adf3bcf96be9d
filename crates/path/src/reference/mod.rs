//! Paths that a robot is to follow: of its tool or of its joints.

pub(crate) mod cartesian;
pub(crate) mod joint_curve;
pub(crate) mod orientation;
pub(crate) mod point;
pub(crate) mod position;
#[allow(clippy::module_inception)]
pub(crate) mod reference;
