//! The spline against exact cubics and a dense system.

use super::*;
use crate::curve::waypoints::Spacing;
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
                    assert!((found - expected).norm() < 10.0 * ROUNDING, "{count} points at {x}: {found} {expected}");
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

#[test]
fn slopes_that_overflow_are_refused() {
    let points = vec![Vector1::new(-1e150), Vector1::new(1e150), Vector1::new(0.0)];
    let waypoints = Waypoints::new(points, &Spacing::At(vec![0.0, 1e-200, 1.0]), 0.0..1.0).expect("valid");
    let refused = CubicSpline::new(waypoints, SplineEnds::Natural).err();
    assert!(matches!(refused, Some(CurveError::TooSteep { .. })), "{refused:?}");
    let far = vec![Vector1::new(-1e300), Vector1::new(1e300)];
    let refused = Waypoints::new(far, &Spacing::Uniform, 0.0..1.0).err();
    assert_eq!(refused, Some(CurveError::TooSteep { index: 1 }));
}
