use super::parameter::{ShapeParameter, accept, unit};
use super::{Local, Shape};
use crate::error::ParameterError;
use crate::path::vector::dot;

/// One side of a plane: `σ = nᵀ p - d <= 0` with a unit normal `n` pointing out of the allowed side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfSpace<const N: usize> {
    normal: [f64; N],
    offset: f64,
}

impl<const N: usize> HalfSpace<N> {
    /// `normal` is brought to unit length; `offset` is the distance of the plane from the origin along it.
    ///
    /// # Errors
    ///
    /// A component that is not finite, or a normal of length zero.
    pub fn new(normal: &[f64; N], offset: f64) -> Result<Self, ParameterError> {
        let offset = accept(ShapeParameter::Offset, offset, true)?;
        Ok(Self { normal: unit(normal)?, offset })
    }
}

impl<const N: usize> Shape<N> for HalfSpace<N> {
    #[inline]
    fn local(&self, position: &[f64; N], _direction: &[f64; N]) -> Local<N> {
        Local { value: dot(&self.normal, position) - self.offset, gradient: self.normal, curvature: [0.0; N] }
    }
}
