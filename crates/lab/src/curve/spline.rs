use super::error::CurveError;
use super::waypoints::{Waypoints, segment};
use nalgebra::SVector;

/// What a spline does at its two ends, besides passing through them.
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
    /// A clamped end whose derivative is not finite.
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
        Ok(Self { waypoints, slopes })
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

/// Elimination without pivoting. The pivots stay positive: inner rows are diagonally dominant; a not-a-knot row turns the
/// pivot after it into `h0 + h1`, still larger than the factor `h0` that follows, and the last pivot is at least
/// `h a / (2 a + b)` for outermost steps `b` and `a`, `h = a`.
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
mod tests {
    use super::super::waypoints::Spacing;
    use super::*;
    use nalgebra::{DMatrix, DVector, Vector1, Vector2};
    use proptest::prelude::*;

    const AT: [f64; 6] = [-1.0, -0.4, 0.1, 0.9, 1.2, 2.0];

    fn through(at: &[f64], value: impl Fn(f64) -> Vector2<f64>) -> Waypoints<2> {
        let points = at.iter().map(|&x| value(x)).collect();
        Waypoints::new(points, &Spacing::At(at.to_vec()), 0.0..1.0).expect("valid")
    }

    /// A cubic with its derivatives.
    fn cubic(x: f64) -> [Vector2<f64>; 3] {
        [
            Vector2::new(1.0 - 2.0 * x + x * x * x, x * (3.0 - x)),
            Vector2::new(-2.0 + 3.0 * x * x, 3.0 - 2.0 * x),
            Vector2::new(6.0 * x, -2.0),
        ]
    }

    /// Values of order 10 are rounded to 1e-15; the second derivative divides differences by steps of 0.3 twice.
    const ROUNDING: f64 = 1e-12;

    fn all_ends() -> [SplineEnds<2>; 3] {
        let clamped = SplineEnds::Clamped { start: Vector2::new(1.0, -2.0), end: Vector2::new(0.5, 3.0) };
        [SplineEnds::Natural, clamped, SplineEnds::NotAKnot]
    }

    #[test]
    fn a_cubic_is_met_exactly_by_clamped_and_by_not_a_knot_ends() {
        let clamped = SplineEnds::Clamped { start: cubic(-1.0)[1], end: cubic(2.0)[1] };
        for ends in [clamped, SplineEnds::NotAKnot] {
            for count in [4, 5, 6] {
                let at: Vec<f64> = AT.into_iter().skip(6 - count).collect();
                let ends = match ends {
                    SplineEnds::Clamped { end, .. } => SplineEnds::Clamped { start: cubic(at[0])[1], end },
                    other => other,
                };
                let spline = CubicSpline::new(through(&at, |x| cubic(x)[0]), ends).expect("valid");
                for i in -5..=25 {
                    let x = 0.1 * f64::from(i);
                    for (found, expected) in spline.at(x).iter().zip(cubic(x)) {
                        // Beyond the ends of the path errors grow with the distance.
                        assert!(
                            (found - expected).norm() < 10.0 * ROUNDING,
                            "{count} points at {x}: {found} {expected}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn two_way_points_give_a_line_and_three_not_a_knot_a_parabola() {
        for ends in [SplineEnds::Natural, SplineEnds::NotAKnot] {
            let line = CubicSpline::new(through(&AT[..2], |x| cubic(x)[0]), ends).expect("valid");
            assert!(line.at(-0.7)[2].norm() < ROUNDING);
        }
        let parabola = |x: f64| Vector2::new(2.0 * x * x - x, 1.0 - x * x);
        let spline = CubicSpline::new(through(&AT[2..5], parabola), SplineEnds::NotAKnot).expect("valid");
        for x in [0.1, 0.3, 0.9, 1.0, 1.2] {
            assert!((spline.at(x)[0] - parabola(x)).norm() < ROUNDING);
            assert!((spline.at(x)[2] - Vector2::new(4.0, -2.0)).norm() < ROUNDING);
        }
    }

    #[test]
    fn natural_ends_have_no_second_derivative_and_clamped_ends_their_first() {
        let natural = CubicSpline::new(through(&AT, |x| Vector2::new(x.sin(), x.cos())), SplineEnds::Natural);
        let natural = natural.expect("valid");
        assert!(natural.at(-1.0)[2].norm() < ROUNDING && natural.at(2.0)[2].norm() < ROUNDING);
        let [_, ends, _] = all_ends();
        let clamped = CubicSpline::new(through(&AT, |x| Vector2::new(x.sin(), x.cos())), ends).expect("valid");
        assert!((clamped.at(-1.0)[1] - Vector2::new(1.0, -2.0)).norm() < ROUNDING);
        assert!((clamped.at(2.0)[1] - Vector2::new(0.5, 3.0)).norm() < ROUNDING);
    }

    /// Factors of unknowns, and what their sum is.
    type Condition = (Vec<(usize, f64)>, Vector2<f64>);

    /// The naive twin: four unknown coefficients a segment, every condition one row of a dense system.
    /// Returns the coefficients of `1, t, t², t³` with `t = λ - λ_i`, one column per coordinate.
    fn dense(waypoints: &Waypoints<2>, ends: SplineEnds<2>) -> DMatrix<f64> {
        let (at, points) = (waypoints.at(), waypoints.points());
        let n = at.len() - 1;
        let mut rows: Vec<Condition> = Vec::new();
        let zero = Vector2::zeros();
        for i in 0..n {
            let h = at[i + 1] - at[i];
            let c = 4 * i;
            rows.push((vec![(c, 1.0)], points[i]));
            rows.push((vec![(c, 1.0), (c + 1, h), (c + 2, h * h), (c + 3, h * h * h)], points[i + 1]));
            if i + 1 < n {
                rows.push((vec![(c + 1, 1.0), (c + 2, 2.0 * h), (c + 3, 3.0 * h * h), (c + 5, -1.0)], zero));
                rows.push((vec![(c + 2, 2.0), (c + 3, 6.0 * h), (c + 6, -2.0)], zero));
            }
        }
        let (c, h) = (4 * (n - 1), at[n] - at[n - 1]);
        match ends {
            SplineEnds::Natural => {
                rows.push((vec![(2, 2.0)], zero));
                rows.push((vec![(c + 2, 2.0), (c + 3, 6.0 * h)], zero));
            }
            SplineEnds::Clamped { start, end } => {
                rows.push((vec![(1, 1.0)], start));
                rows.push((vec![(c + 1, 1.0), (c + 2, 2.0 * h), (c + 3, 3.0 * h * h)], end));
            }
            SplineEnds::NotAKnot => {
                rows.push((vec![(3, 6.0), (7, -6.0)], zero));
                rows.push((vec![(c - 1, 6.0), (c + 3, -6.0)], zero));
            }
        }
        let mut system = DMatrix::zeros(4 * n, 4 * n);
        let mut right = [DVector::zeros(4 * n), DVector::zeros(4 * n)];
        for (r, (entries, value)) in rows.iter().enumerate() {
            for &(column, factor) in entries {
                system[(r, column)] = factor;
            }
            (right[0][r], right[1][r]) = (value.x, value.y);
        }
        let lu = system.lu();
        DMatrix::from_columns(&right.map(|b| lu.solve(&b).expect("regular")))
    }

    proptest! {
        #[test]
        fn the_slopes_are_those_of_the_dense_system(
            steps in prop::collection::vec((0.1..1.0, -1.0..1.0, -1.0..1.0), 4..9),
            which in 0_usize..3,
        ) {
            let mut lambda = 0.0;
            let mut at = Vec::new();
            for step in &steps {
                lambda += step.0;
                at.push(lambda);
            }
            let points: Vec<_> = steps.iter().map(|s| Vector2::new(s.1, s.2)).collect();
            let Ok(waypoints) = Waypoints::new(points, &Spacing::At(at.clone()), 0.0..1.0) else { return Ok(()) };
            let ends = all_ends()[which];
            let twin = dense(&waypoints, ends);
            let spline = CubicSpline::new(waypoints, ends).expect("valid");
            for i in 0..at.len() - 1 {
                let [value, first, second] = spline.at(at[i]);
                // The dense system has entries from 1e-3 to 6 and a condition below 1e5: 1e-16 * 1e5, and values below
                // 1e3 (chords of 2 over steps of 0.1, twice).
                for k in 0..2 {
                    prop_assert!((value[k] - twin[(4 * i, k)]).abs() < 1e-8);
                    prop_assert!((first[k] - twin[(4 * i + 1, k)]).abs() < 1e-8);
                    prop_assert!((second[k] - 2.0 * twin[(4 * i + 2, k)]).abs() < 1e-8);
                }
            }
        }

        #[test]
        fn value_slope_and_curvature_are_continuous_at_the_way_points(
            ys in prop::collection::vec(-1.0..1.0_f64, 6),
            which in 0_usize..3,
        ) {
            let points = ys.iter().map(|&y| Vector2::new(y, y * y)).collect();
            let Ok(waypoints) = Waypoints::new(points, &Spacing::At(AT.to_vec()), 0.0..1.0) else { return Ok(()) };
            let spline = CubicSpline::new(waypoints, all_ends()[which]).expect("valid");
            for x in &AT[1..5] {
                // One ulp below the way-point lies in the segment before.
                let (left, right) = (spline.at(x.next_down()), spline.at(*x));
                for (a, b) in left.iter().zip(right) {
                    // Second derivatives are below 200 and rounded through divisions by steps of at least 0.3.
                    prop_assert!((a - b).norm() < 1e-11, "{a} {b}");
                }
            }
        }
    }

    #[test]
    fn an_end_derivative_that_is_not_finite_is_refused() {
        let points = vec![Vector1::new(0.0), Vector1::new(1.0)];
        let waypoints = Waypoints::new(points, &Spacing::Chord, 0.0..1.0).expect("valid");
        let ends = SplineEnds::Clamped { start: Vector1::new(f64::NAN), end: Vector1::new(0.0) };
        assert_eq!(CubicSpline::new(waypoints, ends).err(), Some(CurveError::EndDerivative));
    }
}
