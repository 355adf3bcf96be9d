use super::parameter::{ShapeParameter, above_zero, each};
use super::{Local, Shape, Side};
use crate::error::ParameterError;
use crate::path::vector::{add_scaled, difference, dot, norm, scaled};

/// A ball: `σ = ‖p - c‖ - r` to stay inside, its negative to stay outside. `σ` is the signed distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball<const N: usize> {
    centre: [f64; N],
    radius: f64,
    side: Side,
}

impl<const N: usize> Ball<N> {
    /// From centre, radius and allowed side.
    ///
    /// # Errors
    ///
    /// A coordinate that is not finite, a radius that is not positive.
    pub fn new(centre: [f64; N], radius: f64, side: Side) -> Result<Self, ParameterError> {
        each(&centre, ShapeParameter::Coordinate, f64::is_finite)?;
        Ok(Self { centre, radius: above_zero(ShapeParameter::Radius, radius)?, side })
    }
}

/// `‖x‖` with gradient and curvature along `v`; both are zero at the origin, where the norm has neither.
#[inline(always)]
pub(super) fn length<const N: usize>(x: &[f64; N], v: &[f64; N]) -> Local<N> {
    let value = norm(x);
    if value <= 0.0 {
        return Local { value, gradient: [0.0; N], curvature: [0.0; N] };
    }
    let gradient = scaled(1.0 / value, x);
    let tangential = add_scaled(v, -dot(&gradient, v), &gradient);
    Local { value, gradient, curvature: scaled(1.0 / value, &tangential) }
}

impl<const N: usize> Shape<N> for Ball<N> {
    #[inline(always)]
    fn local(&self, position: &[f64; N], direction: &[f64; N]) -> Local<N> {
        let distance = length(&difference(position, &self.centre), direction);
        self.side.orient(Local { value: distance.value - self.radius, ..distance })
    }
}
