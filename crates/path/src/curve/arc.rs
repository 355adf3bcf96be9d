use super::error::CurveError;
use nalgebra::Vector3;
use std::ops::Range;

/// A circular arc at even speed: from one point through another to a third.
///
/// ```text
/// p(λ) = c + r (cos φ e1 + sin φ e2),   φ = φ_end (λ - λ_start) / (λ_end - λ_start)
/// ```
///
/// `e1` points from the centre `c` to the first point, `e2` along the motion there. The arc turns by less than a full
/// circle and passes through the second point on its way. Positions in m.
#[derive(Clone, Debug, PartialEq)]
pub struct Arc {
    centre: Vector3<f64>,
    /// `r e1` and `r e2`.
    axes: [Vector3<f64>; 2],
    begin: f64,
    /// `dφ / dλ`.
    rate: f64,
    angle: f64,
}

/// Sine of the triangle's angle at the first point below which the three points count as collinear: coordinates rounded to
/// 1e-16 leave the plane of the circle known to 1e-7 rad.
const FLATTEST: f64 = 1e-9;

impl Arc {
    /// The arc over a range of the path parameter.
    ///
    /// # Errors
    ///
    /// Three points on a line, two of them in one place, numbers that are not finite, an empty range.
    pub fn through(points: [Vector3<f64>; 3], range: Range<f64>) -> Result<Self, CurveError> {
        let length = range.end - range.start;
        if !(length > 0.0 && length.is_finite()) {
            return Err(CurveError::Range { start: range.start, end: range.end });
        }
        let [from, via, to] = points;
        let (a, b) = (via - from, to - from);
        let normal = a.cross(&b);
        // Flat at the corner of `from`, or at that of `via`: covers two equal points as well.
        let flat = |u: &Vector3<f64>, v: &Vector3<f64>| !(normal.norm() > FLATTEST * u.norm() * v.norm());
        if !normal.norm().is_finite() || flat(&a, &b) || flat(&a, &(b - a)) {
            return Err(CurveError::Collinear);
        }
        // The circumcentre relative to `from`.
        let centre =
            (normal.cross(&a) * b.norm_squared() + b.cross(&normal) * a.norm_squared()) / (2.0 * normal.norm_squared());
        let first = -centre;
        let second = normal.normalize().cross(&first);
        let last = b - centre;
        let angle = last.dot(&second).atan2(last.dot(&first)).rem_euclid(std::f64::consts::TAU);
        Ok(Self { centre: from + centre, axes: [first, second], begin: range.start, rate: angle / length, angle })
    }

    /// `p(λ)`, `p'(λ)` and `p''(λ)`; beyond the ends the circle goes on.
    #[must_use]
    pub fn at(&self, lambda: f64) -> [Vector3<f64>; 3] {
        let (s, c) = (self.rate * (lambda - self.begin)).sin_cos();
        let [e1, e2] = self.axes;
        let radial = e1 * c + e2 * s;
        [self.centre + radial, (e2 * c - e1 * s) * self.rate, radial * (-self.rate * self.rate)]
    }

    /// The circle's centre.
    #[must_use]
    pub fn centre(&self) -> Vector3<f64> {
        self.centre
    }

    /// The circle's radius.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.axes[0].norm()
    }

    /// The angle turned, rad, in `(0, 2π)`.
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.angle
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn an_arc_passes_through_its_three_points_in_their_order(
            angles in (0.1..6.1_f64, 0.05..0.95_f64), radius in 0.01..10.0_f64,
            turn in prop::array::uniform3(-3.0..3.0_f64), shift in prop::array::uniform3(-1.0..1.0_f64),
        ) {
            let rotation = nalgebra::Rotation3::new(Vector3::from(turn));
            let point = |phi: f64| Vector3::from(shift) + rotation * Vector3::new(phi.cos(), phi.sin(), 0.0) * radius;
            let points = [point(0.0), point(angles.0 * angles.1), point(angles.0)];
            let arc = Arc::through(points, 2.0..5.0).expect("valid");
            // Rounding of order 1e-15 (1 + radius), magnified by the flatness of the triangle: at least 0.1 * 0.05 rad
            // between neighbours, squared.
            let tolerance = 1e-15 * (1.0 + radius) / (0.005_f64 * 0.005);
            prop_assert!((arc.radius() - radius).abs() < 1e2 * tolerance);
            prop_assert!((arc.angle() - angles.0).abs() < 1e2 * tolerance / radius);
            for (lambda, expected) in [2.0, 2.0 + 3.0 * angles.1, 5.0].into_iter().zip(points) {
                prop_assert!((arc.at(lambda)[0] - expected).norm() < 1e2 * tolerance);
            }
        }
    }

    #[test]
    fn the_derivatives_are_those_of_the_curve() {
        let points = [Vector3::new(0.5, 0.0, 0.1), Vector3::new(0.4, 0.2, 0.3), Vector3::new(0.1, 0.3, 0.0)];
        let arc = Arc::through(points, 0.0..2.0).expect("valid");
        let h = 1e-5;
        for i in 0..=20 {
            let x = 0.1 * f64::from(i);
            let [_, first, second] = arc.at(x);
            // Truncation h² / 6 of derivatives of order 1, rounding 1e-16 / h.
            let (before, after) = (arc.at(x - h), arc.at(x + h));
            assert!(((after[0] - before[0]) / (2.0 * h) - first).norm() < 1e-9);
            assert!(((after[1] - before[1]) / (2.0 * h) - second).norm() < 1e-9);
        }
    }

    #[test]
    fn points_without_a_circle_are_refused() {
        let (a, b) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.5, 0.1, -0.3));
        for points in [[a, a + b, a + b * 2.0], [a, a, b], [a, b, b], [a, b, a], [a, b, b * f64::NAN]] {
            assert_eq!(Arc::through(points, 0.0..1.0).err(), Some(CurveError::Collinear), "{points:?}");
        }
        assert!(matches!(Arc::through([a, b, a * 2.0], 1.0..1.0), Err(CurveError::Range { .. })));
    }
}
