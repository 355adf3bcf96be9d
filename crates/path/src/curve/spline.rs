use super::error::CurveError;
use super::polynomial_piece::PolynomialPiece;
use super::waypoints::{Waypoints, segment};
use nalgebra::SVector;
use std::ops::Range;

/// End conditions of a spline, besides passing through its first and last way-point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum SplineEnds<const D: usize> {
    /// No second derivative.
    Natural,
    /// First derivatives given, by the path parameter.
    Clamped {
        /// At the first way-point.
        start: SVector<f64, D>,
        /// At the last one.
        end: SVector<f64, D>,
    },
    /// The first two pieces are one cubic, and so are the last two: the ends need no data of their own, and a cubic is
    /// met exactly. Three way-points give the parabola through them, two the line.
    #[default]
    NotAKnot,
}

/// The cubic spline through way-points: passes through all of them, twice continuously differentiable.
///
/// On each segment, with `h` its length, `u = (λ - λ_i) / h` and `d = (p_{i+1} - p_i) / h`, the cubic of Hermite:
///
/// ```text
/// p(λ) = p_i + h u (s_i + u (3 d - 2 s_i - s_{i+1} + u (s_i + s_{i+1} - 2 d)))
/// ```
///
/// The slopes `s_i` solve the tridiagonal system that makes the second derivative continuous,
/// `h_i s_{i-1} + 2 (h_{i-1} + h_i) s_i + h_{i-1} s_{i+1} = 3 (h_i d_{i-1} + h_{i-1} d_i)`, with one row more at either
/// end.
#[derive(Clone, Debug, PartialEq)]
pub struct CubicSpline<const D: usize> {
    waypoints: Waypoints<D>,
    slopes: Vec<SVector<f64, D>>,
}

/// One row of the system: factors of the slopes before, at and after a way-point, and the right-hand side.
#[derive(Clone, Copy)]
struct Row<const D: usize> {
    before: f64,
    own: f64,
    after: f64,
    right: SVector<f64, D>,
}

impl<const D: usize> CubicSpline<D> {
    /// The spline with given ends.
    ///
    /// # Errors
    ///
    /// A clamped end whose derivative is not finite; way-points so far apart that slopes overflow.
    pub fn new(waypoints: Waypoints<D>, ends: SplineEnds<D>) -> Result<Self, CurveError> {
        if let SplineEnds::Clamped { start, end } = ends
            && !start.iter().chain(end.iter()).all(|x| x.is_finite())
        {
            return Err(CurveError::EndDerivative);
        }
        let steps: Vec<f64> = waypoints.at().windows(2).map(|w| w[1] - w[0]).collect();
        let chords: Vec<SVector<f64, D>> =
            waypoints.points().windows(2).zip(&steps).map(|(w, h)| (w[1] - w[0]) / *h).collect();
        let ends = settle(ends, &steps, &chords);
        let slopes = solve(rows(ends, &steps, &chords));
        match slopes.iter().position(|s| !s.iter().all(|x| x.is_finite())) {
            Some(index) => Err(CurveError::TooSteep { index }),
            None => Ok(Self { waypoints, slopes }),
        }
    }

    /// `p(λ)`, `p'(λ)` and `p''(λ)`; beyond the ends the outermost cubics go on.
    #[must_use]
    pub fn at(&self, lambda: f64) -> [SVector<f64, D>; 3] {
        let (at, points) = (self.waypoints.at(), self.waypoints.points());
        let i = segment(at, lambda);
        let h = at[i + 1] - at[i];
        let u = (lambda - at[i]) / h;
        let (s0, s1) = (self.slopes[i], self.slopes[i + 1]);
        let d = (points[i + 1] - points[i]) / h;
        let square = d * 3.0 - s0 * 2.0 - s1;
        let cube = s0 + s1 - d * 2.0;
        [
            points[i] + (s0 + (square + cube * u) * u) * (h * u),
            s0 + (square * 2.0 + cube * (3.0 * u)) * u,
            (square * 2.0 + cube * (6.0 * u)) / h,
        ]
    }

    /// The cubics between neighbouring way-points, within a range of the path parameter.
    #[must_use]
    pub fn polynomials(&self, range: &Range<f64>) -> Vec<PolynomialPiece<D>> {
        let (at, points) = (self.waypoints.at(), self.waypoints.points());
        let cubic = |i: usize| {
            let (start, end) = (at[i], at[i + 1]);
            let h = end - start;
            let (s0, s1, d) = (self.slopes[i], self.slopes[i + 1], (points[i + 1] - points[i]) / h);
            let powers = vec![points[i], s0, (d * 3.0 - s0 * 2.0 - s1) / h, (s0 + s1 - d * 2.0) / (h * h)];
            PolynomialPiece { start, end, powers }
        };
        PolynomialPiece::within((0..at.len() - 1).map(cubic).collect(), range)
    }

    /// The way-points.
    #[must_use]
    pub fn waypoints(&self) -> &Waypoints<D> {
        &self.waypoints
    }
}

/// Not-a-knot with fewer than four way-points leaves the spline undetermined: the polynomial through them is meant.
fn settle<const D: usize>(ends: SplineEnds<D>, steps: &[f64], chords: &[SVector<f64, D>]) -> SplineEnds<D> {
    match (ends, steps, chords) {
        (SplineEnds::NotAKnot, [_], _) => SplineEnds::Natural,
        (SplineEnds::NotAKnot, [h0, h1], [d0, d1]) => {
            let half = (d1 - d0) / (h0 + h1);
            SplineEnds::Clamped { start: d0 - half * *h0, end: d1 + half * *h1 }
        }
        _ => ends,
    }
}

fn rows<const D: usize>(ends: SplineEnds<D>, steps: &[f64], chords: &[SVector<f64, D>]) -> Vec<Row<D>> {
    let inner = steps.windows(2).zip(chords.windows(2)).map(|(h, d)| Row {
        before: h[1],
        own: 2.0 * (h[0] + h[1]),
        after: h[0],
        right: (d[0] * h[1] + d[1] * h[0]) * 3.0,
    });
    let n = steps.len();
    let (first, last) = match ends {
        SplineEnds::Clamped { start, end } => (clamped(start), clamped(end)),
        SplineEnds::Natural => (natural(chords[0]), natural(chords[n - 1])),
        SplineEnds::NotAKnot => (
            not_a_knot(&steps[..2], [chords[0], chords[1]]),
            not_a_knot(&[steps[n - 1], steps[n - 2]], [chords[n - 1], chords[n - 2]]),
        ),
    };
    let last = Row { before: last.after, after: 0.0, ..last };
    std::iter::once(first).chain(inner).chain(std::iter::once(last)).collect()
}

/// `s_0` as given.
fn clamped<const D: usize>(slope: SVector<f64, D>) -> Row<D> {
    Row { before: 0.0, own: 1.0, after: 0.0, right: slope }
}

/// `p''(λ_0) = 0`: `2 s_0 + s_1 = 3 d_0`.
fn natural<const D: usize>(chord: SVector<f64, D>) -> Row<D> {
    Row { before: 0.0, own: 2.0, after: 1.0, right: chord * 3.0 }
}

/// Equal third derivatives on the outermost two segments, `s_2` eliminated by the row of `s_1`; seen from either end.
fn not_a_knot<const D: usize>(steps: &[f64], chords: [SVector<f64, D>; 2]) -> Row<D> {
    let (h0, h1) = (steps[0], steps[1]);
    let both = h0 + h1;
    let right = (chords[0] * ((h0 + 2.0 * both) * h1) + chords[1] * (h0 * h0)) / both;
    Row { before: 0.0, own: h1, after: both, right }
}

/// Elimination without pivoting: all pivots stay positive. Inner rows are diagonally dominant. A not-a-knot row at the start
/// leaves the row after it the pivot `h_0 + h_1` beside a factor `h_0`; one at the end, with `b` the outermost step and `a` the
/// one before, follows a pivot above `2 a + b` and is left with more than `a² / (2 a + b)`.
fn solve<const D: usize>(mut rows: Vec<Row<D>>) -> Vec<SVector<f64, D>> {
    for i in 1..rows.len() {
        let above = rows[i - 1];
        let factor = rows[i].before / above.own;
        rows[i].own -= factor * above.after;
        rows[i].right -= above.right * factor;
    }
    let mut next = SVector::zeros();
    let mut slopes: Vec<SVector<f64, D>> = rows
        .iter()
        .rev()
        .map(|row| {
            next = (row.right - next * row.after) / row.own;
            next
        })
        .collect();
    slopes.reverse();
    slopes
}

#[cfg(test)]
mod tests;
