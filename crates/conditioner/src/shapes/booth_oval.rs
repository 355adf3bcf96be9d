use super::parameter::{ShapeParameter, above_zero, each};
use super::{Local, Shape, Side};
use crate::error::ParameterError;
use crate::path::vector::{dot, norm};

/// The oval of Booth in any dimension: `σ = ‖p‖² / ‖W p‖ - r` to stay inside, its negative to stay outside, with `W` a
/// diagonal of weights (`[G12] eq 40` has weights 1, 1, 0.3 and `r = 0.5`, outside).
///
/// Where a weight is small the surface is drawn in towards the origin, which makes the holes that trap a reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoothOval<const N: usize> {
    weights: [f64; N],
    radius: f64,
    side: Side,
}

impl<const N: usize> BoothOval<N> {
    /// From weights, radius and allowed side.
    ///
    /// # Errors
    ///
    /// A weight or a radius that is not positive.
    pub fn new(weights: [f64; N], radius: f64, side: Side) -> Result<Self, ParameterError> {
        each(&weights, ShapeParameter::Weight, |w| w > 0.0)?;
        Ok(Self { weights, radius: above_zero(ShapeParameter::Radius, radius)?, side })
    }

    fn weighted(&self, x: &[f64; N]) -> [f64; N] {
        let mut y = *x;
        for (y, w) in y.iter_mut().zip(&self.weights) {
            *y *= w;
        }
        y
    }
}

impl<const N: usize> Shape<N> for BoothOval<N> {
    #[inline]
    fn local(&self, position: &[f64; N], direction: &[f64; N]) -> Local<N> {
        let once = self.weighted(position);
        let (square, n) = (dot(position, position), norm(&once));
        if n <= 0.0 {
            let nothing = Local { value: n - self.radius, gradient: [0.0; N], curvature: [0.0; N] };
            return self.side.orient(nothing);
        }
        // With q = W² p:  ∇ = 2 p / n - ‖p‖² q / n³.
        let q = self.weighted(&once);
        let (inverse, cubed) = (1.0 / n, 1.0 / (n * n * n));
        let (pv, qv) = (dot(position, direction), dot(&q, direction));
        let turned = self.weighted(&self.weighted(direction));
        let mut gradient = q;
        let mut curvature = turned;
        for ((((g, c), &p), &q), &v) in gradient.iter_mut().zip(&mut curvature).zip(position).zip(&q).zip(direction) {
            *g = 2.0 * p * inverse - square * q * cubed;
            let bend = 2.0 * (p * qv + q * pv) + square * *c - 3.0 * square * q * qv * inverse * inverse;
            *c = 2.0 * v * inverse - bend * cubed;
        }
        self.side.orient(Local { value: square * inverse - self.radius, gradient, curvature })
    }
}
