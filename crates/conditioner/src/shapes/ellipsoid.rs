use super::ball::length;
use super::parameter::{ShapeParameter, above_zero, each};
use super::{Local, Shape, Side};
use crate::error::ParameterError;
use crate::path::vector::difference;

/// An ellipsoid along the axes: `σ = k (‖D⁻¹ (p - c)‖ - 1)` to stay inside, its negative to stay outside, where `D` holds
/// the semi-axes (`[G12] eq 36` has `k = 0.1`).
///
/// `σ` is not a distance; with `k` the smallest semi-axis its gradient is at most 1 long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipsoid<const N: usize> {
    centre: [f64; N],
    inverse: [f64; N],
    scale: f64,
    side: Side,
}

impl<const N: usize> Ellipsoid<N> {
    /// From centre, semi-axes, scale `k` and allowed side.
    ///
    /// # Errors
    ///
    /// A coordinate that is not finite, a semi-axis or a scale that is not positive.
    pub fn new(centre: [f64; N], semi_axes: &[f64; N], scale: f64, side: Side) -> Result<Self, ParameterError> {
        each(&centre, ShapeParameter::Coordinate, f64::is_finite)?;
        each(semi_axes, ShapeParameter::SemiAxis, |a| a > 0.0)?;
        let inverse = semi_axes.map(|a| 1.0 / a);
        Ok(Self { centre, inverse, scale: above_zero(ShapeParameter::Scale, scale)?, side })
    }

    fn stretched(&self, x: &[f64; N], factor: f64) -> [f64; N] {
        let mut y = *x;
        for (y, d) in y.iter_mut().zip(&self.inverse) {
            *y *= factor * d;
        }
        y
    }
}

impl<const N: usize> Shape<N> for Ellipsoid<N> {
    #[inline]
    fn local(&self, position: &[f64; N], direction: &[f64; N]) -> Local<N> {
        let x = self.stretched(&difference(position, &self.centre), 1.0);
        let distance = length(&x, &self.stretched(direction, 1.0));
        self.side.orient(Local {
            value: self.scale * (distance.value - 1.0),
            gradient: self.stretched(&distance.gradient, self.scale),
            curvature: self.stretched(&distance.curvature, self.scale),
        })
    }
}
