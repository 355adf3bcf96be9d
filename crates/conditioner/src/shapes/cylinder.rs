use super::ball::length;
use super::parameter::{ShapeParameter, above_zero, each, unit};
use super::{Local, Shape, Side};
use crate::error::ParameterError;
use crate::path::vector::{add_scaled, difference, dot};

/// An endless cylinder: the signed distance `σ = ‖(I - a aᵀ)(p - c)‖ - r` to stay inside, its negative to stay outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder<const N: usize> {
    point: [f64; N],
    axis: [f64; N],
    radius: f64,
    side: Side,
}

impl<const N: usize> Cylinder<N> {
    /// From a point on the axis, the direction of the axis, the radius and the allowed side.
    ///
    /// # Errors
    ///
    /// A component that is not finite, an axis of length zero, a radius that is not positive.
    pub fn new(point: [f64; N], axis: &[f64; N], radius: f64, side: Side) -> Result<Self, ParameterError> {
        each(&point, ShapeParameter::Coordinate, f64::is_finite)?;
        Ok(Self { point, axis: unit(axis)?, radius: above_zero(ShapeParameter::Radius, radius)?, side })
    }

    fn across(&self, x: &[f64; N]) -> [f64; N] {
        add_scaled(x, -dot(&self.axis, x), &self.axis)
    }
}

impl<const N: usize> Shape<N> for Cylinder<N> {
    #[inline]
    fn local(&self, position: &[f64; N], direction: &[f64; N]) -> Local<N> {
        let distance = length(&self.across(&difference(position, &self.point)), &self.across(direction));
        self.side.orient(Local { value: distance.value - self.radius, ..distance })
    }
}
