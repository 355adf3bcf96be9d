use libm::{fabs, pow};

use super::parameter::{ShapeParameter, above_zero, accept, each};
use super::{Local, Shape, Side};
use crate::error::ParameterError;
use crate::path::vector::dot;

/// A box along the axes with smoothed edges: `σ = k (h - 1)`, `h = (Σ |(p_i - c_i) / a_i|^m)^(1/m)`.
///
/// The surface `h = 1` lies inside the box of half edges `a` and touches its faces; the larger `m`, the sharper the
/// edges. Staying inside is therefore safe for the sharp box. To stay outside a sharp box, give half edges larger by
/// `n^(1/m)` in `n` dimensions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SmoothBox<const N: usize> {
    centre: [f64; N],
    half_edges: [f64; N],
    exponent: f64,
    scale: f64,
    side: Side,
}

impl<const N: usize> SmoothBox<N> {
    /// From centre, half edges, exponent `m >= 2`, scale `k` and allowed side.
    ///
    /// # Errors
    ///
    /// A coordinate that is not finite, a half edge or scale that is not positive, an exponent below 2 or above 64.
    pub fn new(
        centre: [f64; N],
        half_edges: [f64; N],
        exponent: f64,
        scale: f64,
        side: Side,
    ) -> Result<Self, ParameterError> {
        each(&centre, ShapeParameter::Coordinate, f64::is_finite)?;
        each(&half_edges, ShapeParameter::SemiAxis, |a| a > 0.0)?;
        let exponent = accept(ShapeParameter::Exponent, exponent, (2.0..=64.0).contains(&exponent))?;
        Ok(Self { centre, half_edges, exponent, scale: above_zero(ShapeParameter::Scale, scale)?, side })
    }

    fn offsets(&self, position: &[f64; N]) -> [f64; N] {
        let mut y = *position;
        for ((y, c), a) in y.iter_mut().zip(&self.centre).zip(&self.half_edges) {
            *y = (*y - c) / a;
        }
        y
    }
}

impl<const N: usize> Shape<N> for SmoothBox<N> {
    fn local(&self, position: &[f64; N], direction: &[f64; N]) -> Local<N> {
        let m = self.exponent;
        let y = self.offsets(position);
        if y.iter().all(|&x| x == 0.0) {
            let nothing = Local { value: -self.scale, gradient: [0.0; N], curvature: [0.0; N] };
            return self.side.orient(nothing);
        }
        // Powers of ratios at most 1: no overflow, however far away. A NaN, which the maximum drops, stays in the sum.
        let longest = y.iter().fold(0.0_f64, |a, &b| a.max(fabs(b)));
        let h = longest * pow(y.iter().map(|&x| pow(fabs(x) / longest, m)).sum(), 1.0 / m);
        let mut gradient = [0.0; N];
        let mut diagonal = [0.0; N];
        for (((g, d), &y), &a) in gradient.iter_mut().zip(&mut diagonal).zip(&y).zip(&self.half_edges) {
            let ratio = fabs(y) / h;
            *d = pow(ratio, m - 2.0) / (a * a);
            *g = libm::copysign(pow(ratio, m - 1.0), y) / a;
        }
        let along = dot(&gradient, direction);
        let bend = self.scale * (m - 1.0) / h;
        let mut curvature = diagonal;
        for ((c, v), g) in curvature.iter_mut().zip(direction).zip(&gradient) {
            *c = bend * (*c * v - g * along);
        }
        let value = self.scale * (h - 1.0);
        self.side.orient(Local { value, gradient: gradient.map(|g| self.scale * g), curvature })
    }
}
