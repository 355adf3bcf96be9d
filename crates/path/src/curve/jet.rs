//! Quaternions with two derivatives: product, logarithm and exponential.
//!
//! A jet `[q, q', q'']` is a function of one variable at a point. Logarithms and exponentials are of half rotation vectors,
//! `q = exp(x) = (cos ‖x‖, sin ‖x‖ x / ‖x‖)`, without taking the nearer of `±q`.

use nalgebra::{Quaternion, Vector3};

pub(super) type QuaternionJet = [Quaternion<f64>; 3];
pub(super) type VectorJet = [Vector3<f64>; 3];

/// The rule of Leibniz.
pub(super) fn product(a: &QuaternionJet, b: &QuaternionJet) -> QuaternionJet {
    [a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + a[1] * b[1] * 2.0 + a[0] * b[2]]
}

pub(super) fn conjugate(q: &QuaternionJet) -> QuaternionJet {
    q.map(|q| q.conjugate())
}

/// A vector times a scalar function.
pub(super) fn scale(k: [f64; 3], x: &VectorJet) -> VectorJet {
    [x[0] * k[0], x[0] * k[1] + x[1] * k[0], x[0] * k[2] + x[1] * (2.0 * k[1]) + x[2] * k[0]]
}

/// A function of a scalar jet, from its own derivatives.
fn chain(f: [f64; 3], x: [f64; 3]) -> [f64; 3] {
    [f[0], f[1] * x[1], f[2] * x[1] * x[1] + f[1] * x[2]]
}

/// `x` with `exp(x) = q`, of length below π; `q` a unit quaternion other than -1.
pub(super) fn logarithm(q: &QuaternionJet) -> VectorJet {
    let vector = q.map(|q| q.imag());
    let factor = angle_over_sine(q[0].scalar(), vector[0].norm());
    scale(chain(factor, q.map(|q| q.scalar())), &vector)
}

/// The unit quaternion of a half rotation vector.
pub(super) fn exponential(x: &VectorJet) -> QuaternionJet {
    let square = [x[0].norm_squared(), 2.0 * x[0].dot(&x[1]), 2.0 * (x[1].norm_squared() + x[0].dot(&x[2]))];
    let (cosine, sine_over_angle) = cosine_and_sine_over_angle(square[0]);
    let vector = scale(chain(sine_over_angle, square), x);
    let scalar = chain(cosine, square);
    [0, 1, 2].map(|k| Quaternion::from_parts(scalar[k], vector[k]))
}

/// `g(w) = acos(w) / sqrt(1 - w²)` with two derivatives, `s = sqrt(1 - w²)` given besides for precision.
///
/// From `(1 - w²) g' = w g - 1`; where that cancels, by the series in `x = 1 - w`,
/// `g = Σ c_k x^k` with `c_k = c_{k-1} k / (2k + 1)`.
fn angle_over_sine(w: f64, s: f64) -> [f64; 3] {
    let x = 1.0 - w;
    if x < 0.5 {
        // Terms fall by at least 1/4 each, the second derivative's by k² / 4^k: 40 terms are below 1e-20.
        let (mut g, mut c) = ([1.0, 0.0, 0.0], 1.0);
        let mut powers = [1.0, 0.0, 0.0];
        for k in 1..=40 {
            let k = f64::from(k);
            c *= k / (2.0 * k + 1.0);
            powers = [powers[0] * x, k * powers[0], k * powers[1]];
            // Derivatives by w: x falls as w grows.
            g = [g[0] + c * powers[0], g[1] - c * powers[1], g[2] + c * powers[2]];
        }
        return g;
    }
    let g = s.atan2(w) / s;
    let first = (w * g - 1.0) / (s * s);
    [g, first, (g + 3.0 * w * first) / (s * s)]
}

/// `cos sqrt(s)` and `sin sqrt(s) / sqrt(s)` as functions of `s`, each with two derivatives.
///
/// With `C' = -S / 2` and `S' = (C - S) / (2 s)`; where the latter cancels, by the series of `S`.
fn cosine_and_sine_over_angle(s: f64) -> ([f64; 3], [f64; 3]) {
    let root = s.sqrt();
    let cosine = root.cos();
    let sine = if s < 1.0 {
        // (-s)^k / (2k + 1)!: 12 terms are below 1e-25.
        let (mut sum, mut c) = ([1.0, 0.0, 0.0], 1.0);
        let mut powers = [1.0, 0.0, 0.0];
        for k in 1..=12 {
            let k = f64::from(k);
            c /= -(2.0 * k) * (2.0 * k + 1.0);
            powers = [powers[0] * s, k * powers[0], k * powers[1]];
            for (sum, power) in sum.iter_mut().zip(powers) {
                *sum += c * power;
            }
        }
        sum
    } else {
        let value = root.sin() / root;
        let first = (cosine - value) / (2.0 * s);
        [value, first, -(0.5 * value + 3.0 * first) / (2.0 * s)]
    };
    ([cosine, -0.5 * sine[0], -0.5 * sine[1]], sine)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Derivatives of order 10, rounding of series and closed form where they meet (divisions by 0.75 and 1, twice).
    const ROUNDING: f64 = 1e-13;

    #[test]
    fn series_and_closed_forms_agree_where_they_meet() {
        let w = 0.5_f64;
        let s = (1.0 - w * w).sqrt();
        let (series, closed) = (angle_over_sine(w.next_up(), s), angle_over_sine(w, s));
        let (below, above) = (cosine_and_sine_over_angle(1.0_f64.next_down()), cosine_and_sine_over_angle(1.0));
        for k in 0..3 {
            assert!((series[k] - closed[k]).abs() < ROUNDING, "{series:?} {closed:?}");
            assert!((below.0[k] - above.0[k]).abs() < ROUNDING);
            assert!((below.1[k] - above.1[k]).abs() < ROUNDING);
        }
    }

    proptest! {
        #[test]
        fn logarithm_and_exponential_undo_each_other_with_their_derivatives(
            direction in prop::array::uniform3(-1.0..1.0_f64), length in 0.0..3.0_f64,
            first in prop::array::uniform3(-1.0..1.0_f64), second in prop::array::uniform3(-1.0..1.0_f64),
        ) {
            let direction = Vector3::from(direction);
            prop_assume!(direction.norm() > 0.1);
            let x = [direction.normalize() * length, Vector3::from(first), Vector3::from(second)];
            let back = logarithm(&exponential(&x));
            // Near ‖x‖ = 3 the sine is 0.14: the second derivative divides by its fifth power, 5e-5, and loses as much.
            for (found, expected) in back.iter().zip(x) {
                prop_assert!((found - expected).norm() < 1e-10, "{found} {expected}");
            }
        }
    }

    #[test]
    fn the_exponential_has_the_derivatives_of_its_differences() {
        let curve = |t: f64| Vector3::new(t.sin(), 0.3 * t * t, 1.0 - t);
        let jet = |t: f64| [curve(t), Vector3::new(t.cos(), 0.6 * t, -1.0), Vector3::new(-t.sin(), 0.6, 0.0)];
        let h = 1e-5;
        for t in [-1.0, 0.0, 0.4, 1.0, 1.7] {
            let (before, q, after) = (exponential(&jet(t - h)), exponential(&jet(t)), exponential(&jet(t + h)));
            for k in 0..2 {
                // Truncation h² times derivatives of order 10, rounding 1e-16 / h.
                assert!(((after[k] - before[k]) / (2.0 * h) - q[k + 1]).norm() < 1e-8);
            }
        }
    }
}
