use super::parameter::plane;
use super::{Local, Shape};
use crate::error::ParameterError;
use crate::path::vector::dot;

/// One side of a plane, `nᵀ p <= d`, as a distance: `σ = (nᵀ p - d) / ‖n‖ <= 0`, `n` pointing out of the allowed side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfSpace<const N: usize> {
    normal: [f64; N],
    offset: f64,
}

impl<const N: usize> HalfSpace<N> {
    /// From `n` of any length and `d`: both are divided by `‖n‖`, so the plane stays where `nᵀ p = d` and `σ` is a length.
    ///
    /// # Errors
    ///
    /// A component that is not finite, a normal of length zero, or one so short that the distance is not finite.
    pub fn new(normal: &[f64; N], offset: f64) -> Result<Self, ParameterError> {
        let (normal, offset) = plane(normal, offset)?;
        Ok(Self { normal, offset })
    }

    /// `n / ‖n‖`.
    #[must_use]
    pub fn normal(&self) -> [f64; N] {
        self.normal
    }

    /// `d / ‖n‖`: distance of the plane from the origin along the normal.
    #[must_use]
    pub fn offset(&self) -> f64 {
        self.offset
    }
}

impl<const N: usize> Shape<N> for HalfSpace<N> {
    #[inline]
    fn local(&self, position: &[f64; N], _direction: &[f64; N]) -> Local<N> {
        Local { value: dot(&self.normal, position) - self.offset, gradient: self.normal, curvature: [0.0; N] }
    }
}
