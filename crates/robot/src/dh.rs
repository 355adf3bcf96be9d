use crate::Pose;
use nalgebra::{Rotation3, Translation3, Vector3};

/// One row of a standard Denavit-Hartenberg table.
///
/// The link transform is `Rz(q + offset) Tz(d) Tx(a) Rx(alpha)`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DhRow {
    /// Link length, m.
    pub a: f64,
    /// Link twist, rad.
    pub alpha: f64,
    /// Link offset along the joint axis, m.
    pub d: f64,
    /// Added to the joint position, rad.
    pub offset: f64,
}

impl DhRow {
    /// The part of the link transform after the joint's motion: `Tz(d) Tx(a) Rx(alpha)`.
    pub(crate) fn after_joint(&self) -> Pose {
        Pose::from_parts(
            Translation3::new(self.a, 0.0, self.d),
            Rotation3::from_axis_angle(&Vector3::x_axis(), self.alpha),
        )
    }

    /// The first parameter that is not finite, by name.
    pub(crate) fn not_finite(&self) -> Option<(&'static str, f64)> {
        [("a", self.a), ("alpha", self.alpha), ("d", self.d), ("offset", self.offset)]
            .into_iter()
            .find(|(_, value)| !value.is_finite())
    }
}
