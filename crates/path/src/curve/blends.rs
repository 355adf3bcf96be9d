use super::error::CurveError;
use super::polynomial_piece::PolynomialPiece;
use super::waypoints::{Waypoints, segment};
use nalgebra::SVector;
use std::ops::Range;

/// Straight lines between way-points, rounded by parabolas: once continuously differentiable.
///
/// About each inner way-point, within a half-width `w_i` of the path parameter, the second derivative is the constant that
/// turns the slope before into the slope after:
///
/// ```text
/// p'' = (v_i - v_{i-1}) / (2 w_i),   |λ - λ_i| <= w_i,   v_i = (p_{i+1} - p_i) / (λ_{i+1} - λ_i)
/// ```
///
/// `w_i` is a share in `[0, 0.5]` of the shorter neighbouring interval, so that blends never overlap. The curve passes
/// through the first and the last way-point and cuts the corners of the others by `‖v_i - v_{i-1}‖ w_i / 4`
/// ([`BlendedLines::deviation`]), its largest distance from the polygon at equal path parameter. The second derivative jumps
/// at the ends of the blends. A share of 0 leaves the corners.
#[derive(Clone, Debug, PartialEq)]
pub struct BlendedLines<const D: usize> {
    waypoints: Waypoints<D>,
    slopes: Vec<SVector<f64, D>>,
    /// Half-widths about the way-points, 0 at the ends.
    widths: Vec<f64>,
}

impl<const D: usize> BlendedLines<D> {
    /// Lines with blends of a given half-width, as a share of the shorter neighbouring interval.
    ///
    /// # Errors
    ///
    /// A share outside `[0, 0.5]`; way-points so far apart that slopes overflow.
    pub fn new(waypoints: Waypoints<D>, share: f64) -> Result<Self, CurveError> {
        if !(0.0..=0.5).contains(&share) {
            return Err(CurveError::Blend { share });
        }
        let (at, points) = (waypoints.at(), waypoints.points());
        let slopes: Vec<SVector<f64, D>> =
            at.windows(2).zip(points.windows(2)).map(|(l, p)| (p[1] - p[0]) / (l[1] - l[0])).collect();
        if let Some(index) = slopes.iter().position(|v| !v.iter().all(|x| x.is_finite())) {
            return Err(CurveError::TooSteep { index });
        }
        let inner = at.windows(3).map(|l| share * (l[1] - l[0]).min(l[2] - l[1]));
        let widths = std::iter::once(0.0).chain(inner).chain(std::iter::once(0.0)).collect();
        Ok(Self { waypoints, slopes, widths })
    }

    /// `p(λ)`, `p'(λ)` and `p''(λ)`, at a corner or at the end of a blend those of the piece that begins there; beyond the
    /// ends the outermost lines go on.
    #[must_use]
    pub fn at(&self, lambda: f64) -> [SVector<f64, D>; 3] {
        let at = self.waypoints.at();
        let i = segment(at, lambda);
        // The blend at the segment's start ends where the line begins, the one at its end begins where the line ends.
        if i > 0 && lambda - at[i] < self.widths[i] {
            return self.blend(i, lambda);
        }
        if i + 2 < at.len() && at[i + 1] - lambda <= self.widths[i + 1] {
            return self.blend(i + 1, lambda);
        }
        let slope = self.slopes[i];
        [self.waypoints.points()[i] + slope * (lambda - at[i]), slope, SVector::zeros()]
    }

    /// The parabola about an inner way-point.
    fn blend(&self, i: usize, lambda: f64) -> [SVector<f64, D>; 3] {
        let (from, to) = (self.slopes[i - 1], self.slopes[i]);
        let t = lambda - self.waypoints.at()[i];
        let since = t + self.widths[i];
        let second = (to - from) / (2.0 * self.widths[i]);
        [self.waypoints.points()[i] + from * t + second * (0.5 * since * since), from + second * since, second]
    }

    /// The lines and the parabolas between them, within a range of the path parameter.
    #[must_use]
    pub fn polynomials(&self, range: &Range<f64>) -> Vec<PolynomialPiece<D>> {
        let (at, points) = (self.waypoints.at(), self.waypoints.points());
        let mut pieces = Vec::new();
        for (i, slope) in self.slopes.iter().enumerate() {
            let (start, end) = (at[i] + self.widths[i], at[i + 1] - self.widths[i + 1]);
            if end > start {
                pieces.push(PolynomialPiece { start, end, powers: vec![points[i] + slope * self.widths[i], *slope] });
            }
            if self.widths[i + 1] > 0.0 {
                let (start, end) = (at[i + 1] - self.widths[i + 1], at[i + 1] + self.widths[i + 1]);
                let [point, slope, second] = self.blend(i + 1, start);
                pieces.push(PolynomialPiece { start, end, powers: vec![point, slope, second * 0.5] });
            }
        }
        PolynomialPiece::within(pieces, range)
    }

    /// Path parameters of the corners, where the first derivative jumps: none with blends, none where the line goes on
    /// straight.
    #[must_use]
    pub fn kinks(&self) -> Vec<f64> {
        // Far above the rounding of coordinates, far below any corner that could be meant.
        let is_corner = |v: &[SVector<f64, D>]| (v[1] - v[0]).norm() > 1e-12 * v[0].norm().max(v[1].norm());
        let inner = self.slopes.windows(2).zip(self.widths.iter().zip(self.waypoints.at()).skip(1));
        inner.filter(|(v, (width, _))| **width == 0.0 && is_corner(v)).map(|(_, (_, at))| *at).collect()
    }

    /// By how much the curve misses a way-point at its path parameter: `‖v_i - v_{i-1}‖ w_i / 4`, 0 at the ends.
    #[must_use]
    pub fn deviation(&self, waypoint: usize) -> f64 {
        match (waypoint.checked_sub(1).and_then(|i| self.slopes.get(i)), self.slopes.get(waypoint)) {
            (Some(before), Some(after)) => 0.25 * self.widths[waypoint] * (after - before).norm(),
            _ => 0.0,
        }
    }

    /// The way-points.
    #[must_use]
    pub fn waypoints(&self) -> &Waypoints<D> {
        &self.waypoints
    }
}

#[cfg(test)]
mod tests {
    use super::super::waypoints::Spacing;
    use super::*;
    use nalgebra::Vector2;

    fn zigzag(share: f64) -> BlendedLines<2> {
        let points = [(0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (-1.0, 2.5)].map(|(x, y)| Vector2::new(x, y)).to_vec();
        let waypoints = Waypoints::new(points, &Spacing::At(vec![0.0, 1.0, 3.0, 3.5]), 0.0..1.0).expect("valid");
        BlendedLines::new(waypoints, share).expect("valid")
    }

    /// Numbers of order 1, a handful of operations.
    const ROUNDING: f64 = 1e-14;

    #[test]
    fn value_and_slope_are_continuous_at_the_ends_of_every_blend() {
        for share in [0.1, 0.3, 0.5] {
            let lines = zigzag(share);
            for (at, width) in [(1.0, share), (3.0, 0.5 * share)] {
                for end in [at - width, at + width] {
                    let (left, right) = (lines.at(end - 1e-15), lines.at(end + 1e-15));
                    // Slopes of 4 over 2e-15; second derivatives up to 80 over the same.
                    assert!((left[0] - right[0]).norm() < 1e-13);
                    assert!((left[1] - right[1]).norm() < 1e-12, "{share} {end}: {} {}", left[1], right[1]);
                }
            }
            assert!(lines.kinks().is_empty());
        }
    }

    #[test]
    fn inner_way_points_are_missed_by_the_stated_deviation_and_no_point_by_more() {
        let lines = zigzag(0.4);
        let corners = zigzag(0.0);
        for (i, at) in [(1, 1.0), (2, 3.0)] {
            let missed = (lines.at(at)[0] - lines.waypoints().points()[i]).norm();
            assert!(missed > 0.01 && (missed - lines.deviation(i)).abs() < ROUNDING);
        }
        let most = lines.deviation(1).max(lines.deviation(2));
        for i in 0..=350 {
            let x = 0.01 * f64::from(i);
            assert!((lines.at(x)[0] - corners.at(x)[0]).norm() <= most + ROUNDING);
        }
        assert_eq!((lines.deviation(0), lines.deviation(3), lines.deviation(9)), (0.0, 0.0, 0.0));
    }

    #[test]
    fn the_ends_are_met_and_the_lines_are_straight_between_the_blends() {
        let lines = zigzag(0.25);
        assert!((lines.at(0.0)[0]).norm() < ROUNDING);
        assert!((lines.at(3.5)[0] - Vector2::new(-1.0, 2.5)).norm() < ROUNDING);
        assert_eq!(lines.at(2.0), [Vector2::new(1.0, 1.0), Vector2::new(0.0, 1.0), Vector2::zeros()]);
    }

    #[test]
    fn the_polynomials_are_the_curve_and_follow_one_another_without_a_gap() {
        for (share, range, count) in [(0.25, 0.0..3.5, 5), (0.25, 0.9..3.1, 3), (0.0, 0.5..3.5, 3)] {
            let lines = zigzag(share);
            let pieces = lines.polynomials(&range);
            assert_eq!(pieces.len(), count);
            assert_eq!((pieces[0].start, pieces[count - 1].end), (range.start, range.end));
            assert!(pieces.windows(2).all(|w| w[0].end == w[1].start));
            for piece in &pieces {
                let t = 0.3 * (piece.end - piece.start);
                let value = piece.powers.iter().rev().fold(Vector2::zeros(), |sum, c| sum * t + c);
                assert!((value - lines.at(piece.start + t)[0]).norm() < ROUNDING);
            }
        }
    }

    #[test]
    fn without_blends_there_is_a_corner_at_every_inner_way_point() {
        let lines = zigzag(0.0);
        assert_eq!(lines.kinks(), [1.0, 3.0]);
        assert_eq!(lines.at(1.0)[1], Vector2::new(0.0, 1.0));
        assert_eq!(lines.at(1.0)[0], Vector2::new(1.0, 0.0));
    }

    #[test]
    fn a_way_point_on_a_straight_line_is_no_corner() {
        let points = [0.0, 0.1, 0.3, 0.7].map(|x| Vector2::new(x, 2.0 * x)).to_vec();
        let waypoints = Waypoints::new(points, &Spacing::Chord, 0.0..1.0).expect("valid");
        assert!(BlendedLines::new(waypoints, 0.0).expect("valid").kinks().is_empty());
    }

    #[test]
    fn blends_that_would_overlap_are_refused() {
        for share in [-0.1, 0.51, f64::NAN] {
            let waypoints = zigzag(0.0).waypoints;
            assert!(matches!(BlendedLines::new(waypoints, share), Err(CurveError::Blend { .. })));
        }
    }
}
