use libm::{exp, log};

use super::parameter::{ShapeParameter, above_zero, plane};
use super::{Local, Shape, Side};
use crate::error::ParameterError;
use crate::path::vector::{add_scaled, dot};

/// A convex polytope of `F` faces as one smooth constraint: the maximum of the faces' distances, rounded off.
///
/// ```text
/// m(p) = (1/s) ln Σ exp(s (n_iᵀ p - d_i) / ‖n_i‖),   max <= m <= max + ln F / s
/// σ    = m to stay inside,  ln F / s - m to stay outside
/// ```
///
/// Both are on the safe side of the sharp polytope, by at most `ln F / s`. To stay inside, `F` separate
/// [`crate::shapes::HalfSpace`] constraints are exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polytope<const N: usize, const F: usize> {
    normals: [[f64; N]; F],
    offsets: [f64; F],
    sharpness: f64,
    side: Side,
}

impl<const N: usize, const F: usize> Polytope<N, F> {
    /// From the faces `n_iᵀ p = d_i` with outward normals of any length, sharpness `s` (1 / length) and allowed side.
    ///
    /// # Errors
    ///
    /// A component that is not finite, a normal of length zero, or one so short that the face's distance from the origin is
    /// not finite; a sharpness that is not positive.
    pub fn new(normals: &[[f64; N]; F], offsets: [f64; F], sharpness: f64, side: Side) -> Result<Self, ParameterError> {
        let sharpness = above_zero(ShapeParameter::Sharpness, sharpness)?;
        let (mut units, mut distances) = (*normals, offsets);
        for (normal, offset) in units.iter_mut().zip(&mut distances) {
            (*normal, *offset) = plane(normal, *offset)?;
        }
        Ok(Self { normals: units, offsets: distances, sharpness, side })
    }
}

impl<const N: usize, const F: usize> Shape<N> for Polytope<N, F> {
    fn local(&self, position: &[f64; N], direction: &[f64; N]) -> Local<N> {
        let mut weights = self.offsets;
        for (w, n) in weights.iter_mut().zip(&self.normals) {
            *w = dot(n, position) - *w;
        }
        let top = weights.iter().fold(f64::NEG_INFINITY, |a, &b| a.max(b));
        // Exponents at most 0, and one of them 0: no overflow, a sum between 1 and F.
        let total: f64 = weights.iter().map(|w| exp(self.sharpness * (w - top))).sum();
        let mut gradient = [0.0; N];
        let mut curvature = [0.0; N];
        for (w, n) in weights.iter_mut().zip(&self.normals) {
            *w = exp(self.sharpness * (*w - top)) / total;
            gradient = add_scaled(&gradient, *w, n);
            curvature = add_scaled(&curvature, self.sharpness * *w * dot(n, direction), n);
        }
        curvature = add_scaled(&curvature, -self.sharpness * dot(&gradient, direction), &gradient);
        let rounding = match self.side {
            Side::Inside => 0.0,
            Side::Outside => log(F as f64) / self.sharpness,
        };
        self.side.orient(Local { value: top + log(total) / self.sharpness - rounding, gradient, curvature })
    }
}
