use libm::{exp, log};

use super::parameter::{ShapeParameter, above_zero, accept, plane};
use super::{Local, Shape, Side};
use crate::error::ParameterError;
use crate::path::vector::{add_scaled, dot};

/// A convex polytope of `k <= F` faces as one smooth constraint: the maximum of the faces' distances, rounded off.
///
/// ```text
/// m(p) = (1/s) ln Σ exp(s (n_iᵀ p - d_i) / ‖n_i‖),   max <= m <= max + ln k / s
/// σ    = m to stay inside,  ln k / s - m to stay outside
/// ```
///
/// Both are on the safe side of the sharp polytope, by at most `ln k / s`, whatever the order of the faces. A face given
/// twice counts twice. To stay inside, `k` separate [`crate::shapes::HalfSpace`] constraints are exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polytope<const N: usize, const F: usize> {
    normals: [[f64; N]; F],
    offsets: [f64; F],
    /// Faces in use, from 1 to `F`: the first ones.
    count: usize,
    sharpness: f64,
    side: Side,
}

impl<const N: usize, const F: usize> Polytope<N, F> {
    /// From `F` faces `n_iᵀ p = d_i` with outward normals of any length, sharpness `s` (1 / length) and allowed side.
    ///
    /// # Errors
    ///
    /// As [`Polytope::with_faces`].
    pub fn new(normals: &[[f64; N]; F], offsets: [f64; F], sharpness: f64, side: Side) -> Result<Self, ParameterError> {
        Self::with_faces(normals, &offsets, sharpness, side)
    }

    /// From between 1 and `F` faces, where their number is not known to the compiler.
    ///
    /// # Errors
    ///
    /// No face, more than `F`, or not as many offsets as normals ([`ShapeParameter::FaceCount`], with that number);
    /// a component that is not finite, a normal of length zero, or one so short that the face's distance from the origin is
    /// not finite; a sharpness that is not positive.
    pub fn with_faces(
        normals: &[[f64; N]],
        offsets: &[f64],
        sharpness: f64,
        side: Side,
    ) -> Result<Self, ParameterError> {
        let count = normals.len();
        accept(ShapeParameter::FaceCount, count as f64, (1..=F).contains(&count))?;
        accept(ShapeParameter::FaceCount, offsets.len() as f64, offsets.len() == count)?;
        let sharpness = above_zero(ShapeParameter::Sharpness, sharpness)?;
        let mut polytope = Self { normals: [[0.0; N]; F], offsets: [0.0; F], count, sharpness, side };
        let slots = polytope.normals.iter_mut().zip(&mut polytope.offsets);
        for (((unit, distance), normal), offset) in slots.zip(normals).zip(offsets) {
            (*unit, *distance) = plane(normal, *offset)?;
        }
        Ok(polytope)
    }

    /// Number `k` of its faces.
    #[must_use]
    pub fn face_count(&self) -> usize {
        self.count
    }
}

impl<const N: usize, const F: usize> Shape<N> for Polytope<N, F> {
    fn local(&self, position: &[f64; N], direction: &[f64; N]) -> Local<N> {
        let mut weights = self.offsets;
        for (w, n) in weights.iter_mut().zip(&self.normals).take(self.count) {
            *w = dot(n, position) - *w;
        }
        let top = weights.iter().take(self.count).fold(f64::NEG_INFINITY, |a, &b| a.max(b));
        // Exponents at most 0, and one of them 0: no overflow, a sum between 1 and the number of faces.
        let total: f64 = weights.iter().take(self.count).map(|w| exp(self.sharpness * (w - top))).sum();
        let mut gradient = [0.0; N];
        let mut curvature = [0.0; N];
        for (w, n) in weights.iter_mut().zip(&self.normals).take(self.count) {
            *w = exp(self.sharpness * (*w - top)) / total;
            gradient = add_scaled(&gradient, *w, n);
            curvature = add_scaled(&curvature, self.sharpness * *w * dot(n, direction), n);
        }
        curvature = add_scaled(&curvature, -self.sharpness * dot(&gradient, direction), &gradient);
        let rounding = match self.side {
            Side::Inside => 0.0,
            Side::Outside => log(self.count as f64) / self.sharpness,
        };
        self.side.orient(Local { value: top + log(total) / self.sharpness - rounding, gradient, curvature })
    }
}
