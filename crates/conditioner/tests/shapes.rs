//! Every shape against finite differences of its own value.

use proptest::prelude::*;
use slideway_conditioner::ParameterError;
use slideway_conditioner::path::{Constraint, ConstraintSample, Motion};
use slideway_conditioner::shapes::{
    Ball, BoothOval, Cylinder, Ellipsoid, HalfSpace, Moving, Oscillation, Polytope, ShapeParameter, Side, SmoothBox,
    UniformMotion,
};

/// Step of the differences. Their truncation error is `h²/6` times a third derivative, their rounding `1e-16 / h`.
const H: f64 = 1e-5;

/// Third derivatives of the shapes below, at the points below, in units of 1/m²: curvature radii are 0.1 m and more, the
/// box and the oval have ten times that. `h² * 1e4 = 1e-6` covers them; a wrong term of a gradient of size 1 does not hide.
const TOLERANCE: f64 = 1e-6;

fn moved(m: &Motion<3>, time: f64) -> Motion<3> {
    let position = std::array::from_fn(|i| m.position[i] + time * m.velocity[i]);
    Motion { time: m.time + time, position, velocity: m.velocity }
}

fn check(constraint: &dyn Constraint<3>, at: &Motion<3>) -> Result<(), TestCaseError> {
    let here = constraint.sample(at);
    let near = |actual: f64, expected: f64, what: &str| -> Result<(), TestCaseError> {
        let size = 1.0 + expected.abs() + here.gradient_rate.iter().map(|x| x.abs()).sum::<f64>();
        prop_assert!((actual - expected).abs() <= TOLERANCE * size * 10.0, "{what}: {actual}, differences {expected}");
        Ok(())
    };
    for i in 0..3 {
        let shifted = |h: f64| {
            let mut m = *at;
            m.position[i] += h;
            constraint.sample(&m).value
        };
        near(here.gradient[i], (shifted(H) - shifted(-H)) / (2.0 * H), "gradient")?;
    }
    let later = |h: f64| constraint.sample(&Motion { time: at.time + h, ..*at }).value;
    near(here.time_rate, (later(H) - later(-H)) / (2.0 * H), "time rate")?;
    let along = |h: f64| constraint.sample(&moved(at, h));
    let (ahead, behind): (ConstraintSample<3>, ConstraintSample<3>) = (along(H), along(-H));
    for i in 0..3 {
        near(here.gradient_rate[i], (ahead.gradient[i] - behind.gradient[i]) / (2.0 * H), "gradient rate")?;
    }
    near(here.time_rate_rate, (ahead.time_rate - behind.time_rate) / (2.0 * H), "rate of the time rate")
}

fn motions() -> impl Strategy<Value = Motion<3>> {
    // Between 0.2 and 1 m from every centre and axis: a singular point is a matter of another test.
    (prop::array::uniform3(0.2..0.6_f64), prop::array::uniform3(any::<bool>()), prop::array::uniform3(-1.0..1.0_f64))
        .prop_map(|(size, flip, velocity)| {
            let position = std::array::from_fn(|i| if flip[i] { -size[i] } else { size[i] });
            Motion { time: 0.3, position, velocity }
        })
}

const SIDES: [Side; 2] = [Side::Inside, Side::Outside];

proptest! {
    #[test]
    fn the_derivatives_of_every_standing_shape_are_those_of_its_value(at in motions()) {
        check(&HalfSpace::new(&[1.0, -2.0, 0.5], 0.3).expect("a normal"), &at)?;
        for side in SIDES {
            check(&Ball::new([0.05, 0.0, -0.05], 0.3, side).expect("valid"), &at)?;
            check(&Ellipsoid::new([0.0; 3], &[0.8, 0.5, 0.2], 0.2, side).expect("valid"), &at)?;
            check(&Cylinder::new([0.0; 3], &[0.0, 0.1, 1.0], 0.1, side).expect("valid"), &at)?;
            check(&SmoothBox::new([0.0; 3], [0.5, 0.4, 0.6], 6.0, 0.4, side).expect("valid"), &at)?;
            check(&BoothOval::new([1.0, 1.0, 0.3], 0.5, side).expect("valid"), &at)?;
            let cube = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]];
            check(&Polytope::new(&cube, [0.2, 0.3, 0.2, 0.3, 0.4], 5.0, side).expect("valid"), &at)?;
        }
    }

    #[test]
    fn the_derivatives_of_a_moving_shape_are_those_of_its_value(at in motions()) {
        let ball = Ball::new([0.0; 3], 0.3, Side::Outside).expect("valid");
        let swing = Oscillation { amplitude: [0.05, -0.02, 0.03], frequency: 3.0, phase: 0.4 };
        check(&Moving { shape: ball, trajectory: swing }, &at)?;
        let oval = BoothOval::new([1.0, 1.0, 0.3], 0.5, Side::Outside).expect("valid");
        let drift = UniformMotion { velocity: [0.1, -0.2, 0.1], acceleration: [0.0, 0.3, -0.1] };
        check(&Moving { shape: oval, trajectory: drift }, &at)?;
    }

    #[test]
    fn a_smoothed_polytope_is_on_the_safe_side_of_the_sharp_one(at in motions()) {
        let normals = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]];
        let offsets = [0.3, 0.3, 0.4, 0.4];
        let sharp = (0..4)
            .map(|i| (0..3).map(|k| normals[i][k] * at.position[k]).sum::<f64>() - offsets[i])
            .fold(f64::NEG_INFINITY, f64::max);
        let slack = 4.0_f64.ln() / 50.0;
        let inside = Polytope::new(&normals, offsets, 50.0, Side::Inside).expect("valid").sample(&at).value;
        let outside = Polytope::new(&normals, offsets, 50.0, Side::Outside).expect("valid").sample(&at).value;
        // Both sides to rounding.
        prop_assert!(inside >= sharp - 1e-14 && inside <= sharp + slack + 1e-14);
        prop_assert!(outside >= -sharp - 1e-14 && outside <= -sharp + slack + 1e-14);
    }
}

/// The naive twin: the sum over the faces given, none of them shifted. Its exponents stay below 50 for the faces below.
fn naive(normals: &[[f64; 3]], offsets: &[f64], sharpness: f64, side: Side, position: &[f64; 3]) -> f64 {
    let distance = |(n, d): (&[f64; 3], &f64)| {
        let along: f64 = n.iter().zip(position).map(|(n, p)| n * p).sum();
        (along - d) / n.iter().map(|n| n * n).sum::<f64>().sqrt()
    };
    let total: f64 = normals.iter().zip(offsets).map(|face| (sharpness * distance(face)).exp()).sum();
    match side {
        Side::Inside => total.ln() / sharpness,
        Side::Outside => ((normals.len() as f64).ln() - total.ln()) / sharpness,
    }
}

proptest! {
    #[test]
    fn a_polytope_is_the_sum_over_its_faces_in_any_order_and_of_no_others(
        faces in prop::collection::vec((prop::array::uniform3(0.1..2.0_f64), -1.0..1.0_f64), 1..=6),
        turn in 0..6_usize,
        at in motions(),
    ) {
        let (normals, offsets): (Vec<_>, Vec<_>) = faces.into_iter().unzip();
        let (mut turned_normals, mut turned_offsets) = (normals.clone(), offsets.clone());
        turned_normals.rotate_left(turn % normals.len());
        turned_offsets.rotate_left(turn % normals.len());
        for side in SIDES {
            // Room for twelve faces, of which up to six are there.
            let polytope = Polytope::<3, 12>::with_faces(&normals, &offsets, 4.0, side).expect("valid");
            let turned = Polytope::<3, 12>::with_faces(&turned_normals, &turned_offsets, 4.0, side).expect("valid");
            check(&polytope, &at)?;
            prop_assert_eq!(polytope.face_count(), normals.len());
            let (found, other) = (polytope.sample(&at).value, turned.sample(&at).value);
            let expected = naive(&normals, &offsets, 4.0, side, &at.position);
            // Distances of up to 10, for normals as short as 0.17 and offsets of 1: 1e-15 of that, times a few operations.
            prop_assert!((found - expected).abs() <= 1e-13, "{found} instead of {expected}");
            prop_assert!((found - other).abs() <= 1e-13, "{found} in one order, {other} in another");
        }
    }
}

#[test]
fn the_shapes_of_the_paper_have_its_values() {
    let at = |position| Motion { time: 0.0, position, velocity: [0.0; 3] };
    // [G12] eq 36 at the upper pole, eq 40 at the bottom of the upper hole and on the equator: boundaries.
    let ellipsoid = Ellipsoid::new([0.0; 3], &[0.8, 0.8, 0.1], 0.1, Side::Outside).expect("valid");
    assert!(ellipsoid.sample(&at([0.0, 0.0, 0.1])).value.abs() < 1e-16);
    let oval = BoothOval::new([1.0, 1.0, 0.3], 0.5, Side::Outside).expect("valid");
    assert!(oval.sample(&at([0.0, 0.0, 0.15])).value.abs() < 1e-15);
    assert!(oval.sample(&at([0.5, 0.0, 0.0])).value.abs() < 1e-15);
}

#[test]
fn a_shape_that_cannot_be_is_refused_by_name() {
    let refused = |error, expected| {
        assert!(matches!(error, Some(ParameterError::Shape { parameter, .. }) if parameter == expected))
    };
    refused(Ball::new([0.0; 3], 0.0, Side::Inside).err(), ShapeParameter::Radius);
    refused(Ball::new([0.0, f64::NAN, 0.0], 1.0, Side::Inside).err(), ShapeParameter::Coordinate(1));
    refused(HalfSpace::new(&[0.0; 3], 1.0).err(), ShapeParameter::DirectionLength);
    for length in [-1.0, 0.0, f64::NAN] {
        refused(Ellipsoid::new([0.0; 3], &[1.0, length, 1.0], 1.0, Side::Inside).err(), ShapeParameter::SemiAxis(1));
        let smooth = SmoothBox::new([0.0; 3], [1.0, 1.0, length], 2.0, 1.0, Side::Inside);
        refused(smooth.err(), ShapeParameter::SemiAxis(2));
    }
    refused(SmoothBox::new([0.0; 3], [1.0; 3], 1.5, 1.0, Side::Inside).err(), ShapeParameter::Exponent);
    refused(BoothOval::new([1.0, 0.0, 1.0], 1.0, Side::Inside).err(), ShapeParameter::Weight(1));
    refused(Cylinder::new([0.0; 3], &[0.0; 3], 1.0, Side::Inside).err(), ShapeParameter::DirectionLength);
    refused(Polytope::new(&[[1.0, 0.0, 0.0]], [0.0], 0.0, Side::Inside).err(), ShapeParameter::Sharpness);
    let normal = [1.0, 0.0, 0.0];
    for (normals, offsets) in [(&[][..], &[][..]), (&[normal; 3], &[0.0; 3]), (&[normal; 2], &[0.0; 1])] {
        let polytope = Polytope::<3, 2>::with_faces(normals, offsets, 1.0, Side::Inside);
        refused(polytope.err(), ShapeParameter::FaceCount);
    }
}

#[test]
fn a_shape_has_an_empty_gradient_where_it_has_none() {
    let at = Motion { time: 0.0, position: [0.0; 3], velocity: [1.0, 0.0, 0.0] };
    let shapes: [&dyn Constraint<3>; 4] = [
        &Ellipsoid::new([0.0; 3], &[1.0, 2.0, 3.0], 1.0, Side::Outside).expect("valid"),
        &Cylinder::new([0.0; 3], &[0.0, 0.0, 1.0], 1.0, Side::Outside).expect("valid"),
        &SmoothBox::new([0.0; 3], [1.0; 3], 4.0, 1.0, Side::Outside).expect("valid"),
        &BoothOval::new([1.0; 3], 1.0, Side::Outside).expect("valid"),
    ];
    for shape in shapes {
        let sample = shape.sample(&at);
        assert_eq!(sample.gradient.map(f64::abs), [0.0; 3]);
        assert!(sample.value > 0.0 && sample.gradient_rate.iter().all(|x| x.is_finite()));
    }
}

#[test]
fn a_position_that_is_not_a_number_has_no_value_in_any_shape() {
    // One component is NaN, the others are at the centre: nothing of them may pass for deep inside.
    let at = Motion { time: 0.0, position: [0.0, f64::NAN, 0.0], velocity: [0.0; 3] };
    for side in SIDES {
        let shapes: [&dyn Constraint<3>; 7] = [
            &Ball::new([0.0; 3], 1.0, side).expect("valid"),
            &Ellipsoid::new([0.0; 3], &[1.0, 2.0, 3.0], 1.0, side).expect("valid"),
            &Cylinder::new([0.0; 3], &[0.0, 0.0, 1.0], 1.0, side).expect("valid"),
            &SmoothBox::new([0.0; 3], [1.0; 3], 4.0, 1.0, side).expect("valid"),
            &BoothOval::new([1.0; 3], 1.0, side).expect("valid"),
            &HalfSpace::new(&[1.0, 0.0, 0.0], 1.0).expect("valid"),
            &Polytope::new(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [1.0; 2], 5.0, side).expect("valid"),
        ];
        for (i, shape) in shapes.iter().enumerate() {
            assert!(shape.sample(&at).value.is_nan(), "shape {i}, {side:?}");
        }
    }
}

#[test]
fn every_shape_is_zero_on_its_surface_and_measures_distance_where_it_is_one() {
    let value =
        |shape: &dyn Constraint<3>, position| shape.sample(&Motion { time: 0.0, position, velocity: [0.0; 3] }).value;
    // Equal up to a few roundings of numbers of order 1.
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-14, "{a} instead of {b}");
    for (side, sign) in [(Side::Inside, 1.0), (Side::Outside, -1.0)] {
        // 3-4-5 and 5-12-13: distances 5 from the centre, 13 from the axis through (1, 2, *).
        let ball = Ball::new([1.0, 1.0, -1.0], 2.0, side).expect("valid");
        close(value(&ball, [4.0, 5.0, -1.0]), sign * 3.0);
        let cylinder = Cylinder::new([1.0, 2.0, 7.0], &[0.0, 0.0, -4.0], 3.0, side).expect("valid");
        close(value(&cylinder, [6.0, 14.0, -3.0]), sign * 10.0);
        // h = |x - 1| / 2 on the axis through the centre, and the fourth root of 2 times 1/2 on a diagonal.
        let smooth = SmoothBox::new([1.0, -1.0, 2.0], [2.0, 4.0, 0.5], 4.0, 3.0, side).expect("valid");
        close(value(&smooth, [7.0, -1.0, 2.0]), sign * 6.0);
        close(value(&smooth, [2.0, 1.0, 2.0]), sign * 3.0 * (0.5 * 2.0_f64.powf(0.25) - 1.0));
    }
    // (3 * 5 + 4 * 5 - 10) / 5, and (2 * 1.25 - 0.5) / 2.
    let plane = HalfSpace::new(&[0.0, 3.0, 4.0], 10.0).expect("valid");
    close(value(&plane, [9.0, 5.0, 5.0]), 5.0);
    let one = Polytope::new(&[[0.0, 2.0, 0.0]], [0.5], 10.0, Side::Inside).expect("valid");
    close(value(&one, [9.0, 1.25, 0.0]), 1.0);
}

#[test]
fn a_plane_stays_where_its_equation_says_whatever_the_length_of_its_normal() {
    let at = |position| Motion { time: 0.0, position, velocity: [0.0; 3] };
    for length in [1e-3, 0.5, 1.0, 2.0, 1e3] {
        // 3 x + 4 z = 10 times a length: 2 m from the origin, with the unit normal (0.6, 0, 0.8).
        let (normal, offset) = ([3.0 * length, 0.0, 4.0 * length], 10.0 * length);
        let plane = HalfSpace::new(&normal, offset).expect("valid");
        let far = ([-1.0, 0.0, 0.0], 1e3);
        let faces = Polytope::new(&[normal, far.0], [offset, far.1], 50.0, Side::Inside).expect("valid");
        for (position, distance) in [([1.2, 7.0, 1.6], 0.0), ([0.0; 3], -2.0), ([1.8, -1.0, 2.4], 1.0)] {
            for found in [plane.sample(&at(position)), faces.sample(&at(position))] {
                // A few roundings of numbers below 10.
                assert!((found.value - distance).abs() < 1e-14, "σ = {} for length {length}", found.value);
                let slope = found.gradient.iter().map(|g| g * g).sum::<f64>();
                assert!((slope - 1.0).abs() < 1e-14, "σ is not a distance: slope {slope} for length {length}");
            }
        }
    }
    // Too short for its distance to be a number.
    let offset = |error: Option<ParameterError>| matches!(error, Some(ParameterError::Shape { parameter, .. }) if parameter == ShapeParameter::Offset);
    assert!(offset(HalfSpace::new(&[0.0, 1e-150, 0.0], 1e200).err()));
    assert!(offset(Polytope::new(&[[1e-150, 0.0, 0.0]], [1e200], 1.0, Side::Inside).err()));
}

#[test]
fn a_moving_shape_is_where_its_trajectory_says() {
    let shape = || Ball::new([0.0; 3], 1.0, Side::Inside).expect("valid");
    let at = Motion { time: 0.5, position: [4.0, 0.0, 0.0], velocity: [0.0; 3] };
    // ω t + ψ = π/3 + π/6: the sine is 1, the displacement 2.
    let (frequency, phase) = (2.0 * std::f64::consts::FRAC_PI_3, std::f64::consts::FRAC_PI_6);
    let swing = Oscillation { amplitude: [2.0, 0.0, 0.0], frequency, phase };
    let swung = Moving { shape: shape(), trajectory: swing }.sample(&at);
    assert!((swung.value - 1.0).abs() < 1e-14, "{swung:?}");
    // 4 - (2 t + 8 t²/2) = 2 with t = 1/2: distance 2 from the centre; it comes nearer at 2 + 8 t = 6.
    let drift = UniformMotion { velocity: [2.0, 0.0, 0.0], acceleration: [8.0, 0.0, 0.0] };
    let drifted = Moving { shape: shape(), trajectory: drift }.sample(&at);
    assert!((drifted.value - 1.0).abs() < 1e-14 && (drifted.time_rate + 6.0).abs() < 1e-13, "{drifted:?}");
}

#[test]
fn a_refusal_says_which_parameter_counted_from_one() {
    let words = [
        (ShapeParameter::Coordinate(0), "coordinate 1"),
        (ShapeParameter::Direction(1), "direction component 2"),
        (ShapeParameter::SemiAxis(2), "semi-axis 3"),
        (ShapeParameter::Weight(0), "weight 1"),
        (ShapeParameter::Radius, "radius"),
        (ShapeParameter::FaceCount, "number of faces"),
    ];
    for (parameter, said) in words {
        assert_eq!(parameter.to_string(), said);
    }
}
