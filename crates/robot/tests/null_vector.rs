//! The null vector of the column-augmented Jacobian against cofactors, singular values and finite differences.

use nalgebra::{DMatrix, Rotation3, SMatrix, SVector, Translation3, Unit, Vector3};
use proptest::prelude::*;
use slideway_robot::augmented::{JointMetric, NullVector, null_vector, null_vector_rate, redundant_null_vector};
use slideway_robot::{JacobiSvd, Jacobian, Joint, JointKind, JointVector, Pose, RobotError, SerialArm, Task, Twist};

/// Random configurations for each number of joints from 2 to 7: 12,000 in all.
const CASES: u32 = 2_000;

fn config() -> ProptestConfig {
    ProptestConfig { cases: CASES, failure_persistence: None, ..ProptestConfig::default() }
}

fn vector3() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-1.0..1.0_f64).prop_map(Vector3::from)
}

fn joint() -> impl Strategy<Value = Joint> {
    (vector3(), vector3(), vector3()).prop_map(|(shift, turn, axis)| Joint {
        origin: Pose::from_parts(Translation3::from(shift), Rotation3::from_scaled_axis(turn * 3.0)),
        axis: Unit::try_new(axis, 1e-3).unwrap_or_else(Vector3::x_axis),
        kind: JointKind::Revolute,
        offset: 0.0,
    })
}

/// Defect given to a configuration.
#[derive(Clone, Copy, Debug)]
enum Defect {
    /// No defect.
    None,
    /// One joint's column becomes a combination of two others plus so much of its own: rank lost, nearly or to rounding.
    Dependent(f64),
    /// As [`Defect::Dependent`], twice over: `J̄` itself may lose rank.
    Twice(f64),
    /// The path's direction becomes one that the joints can follow as well.
    Reachable(f64),
}

fn defect() -> impl Strategy<Value = Defect> {
    let rest = || prop_oneof![Just(0.0), (-16.0..-2.0_f64).prop_map(|e| 10f64.powf(e))];
    prop_oneof![
        Just(Defect::None),
        rest().prop_map(Defect::Dependent),
        rest().prop_map(Defect::Twice),
        rest().prop_map(Defect::Reachable),
    ]
}

/// A configuration of an arm with `N` joints: the first `N` rows of its Jacobian (of one more, random row for `N = 7`).
#[derive(Clone, Debug)]
struct Case<const N: usize> {
    jacobian: SMatrix<f64, N, N>,
    tangent: SVector<f64, N>,
}

fn dependent<const N: usize>(jacobian: &mut SMatrix<f64, N, N>, column: usize, rest: f64) {
    let (a, b) = ((column + 1) % N, (column + N - 1) % N);
    let mixed = jacobian.column(a) * 0.7 - jacobian.column(b) * 0.4 + jacobian.column(column) * rest;
    jacobian.set_column(column, &mixed);
}

fn case<const N: usize>() -> impl Strategy<Value = Case<N>> {
    let numbers = prop::collection::vec(-1.0..1.0_f64, 3 * N);
    (prop::collection::vec(joint(), N), numbers, defect()).prop_map(|(joints, numbers, defect)| {
        let joints: [Joint; N] = joints.try_into().expect("N of them");
        let arm = SerialArm::new(joints, Pose::identity());
        let full = arm.jacobian(&SVector::from_fn(|i, _| 3.0 * numbers[i]));
        let mut jacobian = SMatrix::from_fn(|i, j| if i < 6 { full[(i, j)] } else { numbers[N + j] });
        let mut tangent = SVector::from_fn(|i, _| numbers[2 * N + i]);
        match defect {
            Defect::None => {}
            Defect::Dependent(rest) => dependent(&mut jacobian, 0, rest),
            Defect::Twice(rest) => {
                dependent(&mut jacobian, 0, rest);
                dependent(&mut jacobian, 1, rest);
            }
            Defect::Reachable(rest) => {
                dependent(&mut jacobian, 0, rest);
                tangent = jacobian * SVector::from_fn(|i, _| numbers[N + i]) + tangent * rest;
            }
        }
        Case { jacobian, tangent }
    })
}

/// The naive twin: one determinant a minor, `N` not above 7, by elimination, with rows of unit length: pivoting mixes rows,
/// and a short one would inherit the roundings of a long one.
fn cofactors<const N: usize>(case: &Case<N>) -> NullVector<N> {
    // A row of zeros stays one.
    let length =
        |i: usize| Some(case.jacobian.row(i).norm().hypot(case.tangent[i])).filter(|x| *x > 0.0).unwrap_or(1.0);
    let even = Case {
        jacobian: SMatrix::<f64, N, N>::from_fn(|i, j| case.jacobian[(i, j)] / length(i)),
        tangent: SVector::<f64, N>::from_fn(|i, _| case.tangent[i] / length(i)),
    };
    cofactors_of_unit_rows(&even).scaled(hadamard(case))
}

fn cofactors_of_unit_rows<const N: usize>(case: &Case<N>) -> NullVector<N> {
    let minor = |i: usize, j: usize| {
        let minor = DMatrix::from_column_slice(N, N, case.jacobian.as_slice()).remove_row(j).remove_column(i);
        let sign = if (i + j).is_multiple_of(2) { 1.0 } else { -1.0 };
        sign * minor.lu().determinant()
    };
    let joints = SVector::from_fn(|i, _| (0..N).map(|j| minor(i, j) * case.tangent[j]).sum());
    NullVector { joints, path: DMatrix::from_column_slice(N, N, case.jacobian.as_slice()).lu().determinant() }
}

/// `J̄` as the upper left part of a 7×8 matrix with an identity of its own size in the rest: the same kernel.
fn bordered<const N: usize>(case: &Case<N>, size: f64) -> SMatrix<f64, 7, 8> {
    SMatrix::from_fn(|i, j| match (i < N, j) {
        (true, j) if j < N => case.jacobian[(i, j)],
        (true, j) if j == N => -case.tangent[i],
        (false, j) if j == i + 1 => size,
        _ => 0.0,
    })
}

/// Product of the rows' lengths: no cofactor is larger.
fn hadamard<const N: usize>(case: &Case<N>) -> f64 {
    (0..N).map(|i| case.jacobian.row(i).norm().hypot(case.tangent[i])).product()
}

fn check<const N: usize>(case: &Case<N>) -> Result<(), TestCaseError> {
    let null = null_vector(&case.jacobian, &case.tangent);
    let size = case.jacobian.norm().hypot(case.tangent.norm());
    let residual = (case.jacobian * null.joints - case.tangent * null.path).norm();
    // A few N roundings of 1e-16 are expected; 1e-12 is what is promised.
    prop_assert!(residual <= 1e-12 * size * null.norm(), "{residual:e} {size} {:e}", null.norm());

    // Both are determinants of matrices that are some N² roundings off: 1e-14 of what a determinant can be.
    let naive = cofactors(case);
    let gap = (null.joints - naive.joints).norm().hypot(null.path - naive.path);
    prop_assert!(gap <= 1e-13 * hadamard(case), "{gap:e} {:e}", hadamard(case));

    let svd = JacobiSvd::new(&bordered(case, size).transpose()).expect("finite");
    let smallest = (0..7).map(|k| svd.singular_value(k)).fold(f64::INFINITY, f64::min);
    let kernel = kernel_of_rows(&svd.scaled, N);
    // The kernel's direction moves by the roundings of J̄ over its smallest singular value.
    if smallest > 1e-6 * size && null.norm() > 0.0 {
        let unit = null.scaled(1.0 / null.norm());
        let along: f64 = (0..N).map(|i| unit.joints[i] * kernel[i]).sum::<f64>() + unit.path * kernel[N];
        prop_assert!((along.abs() - 1.0).abs() <= 1e-8);
    }
    Ok(())
}

/// The unit vector orthogonal to the seven singular vectors in the columns (scaled by their values), by projection.
fn kernel_of_rows(scaled: &SMatrix<f64, 8, 7>, joints: usize) -> SVector<f64, 8> {
    let mut best = SVector::<f64, 8>::zeros();
    for start in 0..=joints {
        let mut rest = SVector::<f64, 8>::zeros();
        rest[start] = 1.0;
        // Twice is enough: the first pass leaves only roundings along the columns.
        for _ in 0..2 {
            for column in scaled.column_iter() {
                let square = column.norm_squared();
                if square > 0.0 {
                    rest -= column * (column.dot(&rest) / square);
                }
            }
        }
        if rest.norm() > best.norm() {
            best = rest;
        }
    }
    best.normalize()
}

/// `n̄` with `J̄` moved along its rates by `h`.
fn moved<const N: usize>(case: &Case<N>, rates: &Case<N>, h: f64) -> NullVector<N> {
    null_vector(&(case.jacobian + rates.jacobian * h), &(case.tangent + rates.tangent * h))
}

/// Along a straight line the null vector is a polynomial of degree `N`: central differences of fourth order with h = 1e-2
/// err by h⁴ / 30 times the fifth derivative, which is at most `N!/(N-5)!` times the sizes' product.
fn check_rate<const N: usize>(case: &Case<N>, rates: &Case<N>) -> Result<(), TestCaseError> {
    let h = 1e-2;
    let found = null_vector_rate(&case.jacobian, &case.tangent, &rates.jacobian, &rates.tangent);
    let difference = |pick: fn(&NullVector<N>) -> SVector<f64, N>| {
        let at = |k: f64| pick(&moved(case, rates, k * h));
        ((at(1.0) - at(-1.0)) * 8.0 - (at(2.0) - at(-2.0))) / (12.0 * h)
    };
    let size: f64 = (0..N)
        .map(|i| {
            let one = case.jacobian.row(i).norm().hypot(case.tangent[i]);
            one + rates.jacobian.row(i).norm().hypot(rates.tangent[i])
        })
        .product();
    let steepest = 2520.0 * h.powi(4) / 30.0;
    let gap = (found.joints - difference(|n| n.joints)).norm();
    prop_assert!(gap <= (steepest + 1e-11) * size, "{gap:e} {size:e}");
    let path = difference(|n| SVector::from_element(n.path))[0];
    prop_assert!((found.path - path).abs() <= (steepest + 1e-11) * size);
    Ok(())
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn null_vector_of_2_joints_is_in_the_kernel(case in case::<2>()) { check(&case)?; }

    #[test]
    fn null_vector_of_3_joints_is_in_the_kernel(case in case::<3>()) { check(&case)?; }

    #[test]
    fn null_vector_of_4_joints_is_in_the_kernel(case in case::<4>()) { check(&case)?; }

    #[test]
    fn null_vector_of_5_joints_is_in_the_kernel(case in case::<5>()) { check(&case)?; }

    #[test]
    fn null_vector_of_6_joints_is_in_the_kernel(case in case::<6>()) { check(&case)?; }

    #[test]
    fn null_vector_of_7_joints_is_in_the_kernel(case in case::<7>()) { check(&case)?; }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..config() })]

    #[test]
    fn rate_is_the_derivative_at_every_rank_for_3_joints(case in case::<3>(), rates in case::<3>()) {
        check_rate(&case, &rates)?;
    }

    #[test]
    fn rate_is_the_derivative_at_every_rank_for_6_joints(case in case::<6>(), rates in case::<6>()) {
        check_rate(&case, &rates)?;
    }

    // A square Jacobian of a random six-joint arm: both are determinants, roundings of 1e-15 times what they can be.
    #[test]
    fn redundant_form_of_a_square_jacobian_is_the_null_vector_without_its_sign(case in case::<6>()) {
        let null = null_vector(&case.jacobian, &case.tangent);
        let metric = JointMetric::euclidean();
        let redundant = redundant_null_vector(Task::Pose, &case.jacobian, &case.tangent, &metric);
        let sign = null.path.signum();
        prop_assert!((redundant.path - null.path.abs()).abs() <= 1e-12 * hadamard(&case));
        // Below some roundings the determinant has no sign to take off, and the direction of smallest value is anyone's.
        if null.path.abs() > 1e-10 * hadamard(&case) {
            prop_assert!((redundant.joints - null.joints * sign).norm() <= 1e-9 * hadamard(&case));
        }
    }

    // Seven joints, six coordinates, random weights.
    #[test]
    fn redundant_form_follows_the_path_and_is_shortest_in_its_metric(
        joints in prop::collection::vec(joint(), 7),
        numbers in prop::collection::vec(-1.0..1.0_f64, 20),
    ) {
        let joints: [Joint; 7] = joints.try_into().expect("seven");
        let arm = SerialArm::new(joints, Pose::identity());
        let jacobian = arm.jacobian(&SVector::from_fn(|i, _| 3.0 * numbers[i]));
        let twist = Twist::from_fn(|i, _| numbers[7 + i]);
        let weights = JointVector::<7>::from_fn(|i, _| 1.1 + numbers[13 + i]);
        let metric = JointMetric::new(&weights).expect("positive");
        let null = redundant_null_vector(Task::Pose, &jacobian, &twist, &metric);
        let size = jacobian.norm().hypot(twist.norm()) * null.norm();
        prop_assert!((jacobian * null.joints - twist * null.path).norm() <= 1e-12 * size);
        // Shortest: orthogonal, in the metric, to every self-motion, that is W n is in the range of Jᵀ. The self-motion is
        // the vector of the minors of J, which is the null vector of its first six columns beside the seventh.
        let motion = null_vector(&jacobian.fixed_columns::<6>(0).into_owned(), &(-jacobian.column(6)));
        let self_motion = JointVector::<7>::from_fn(|i, _| if i < 6 { motion.joints[i] } else { motion.path });
        let across = null.joints.component_mul(&weights).dot(&self_motion);
        prop_assert!(across.abs() <= 1e-11 * null.joints.norm() * self_motion.norm() * weights.max());
    }
}

fn planar(q2: f64) -> (SMatrix<f64, 2, 2>, SVector<f64, 2>) {
    let (s, c) = q2.sin_cos();
    // Two links of 1 m, the first along x: the direction across the outer boundary is x.
    (SMatrix::<f64, 2, 2>::new(-s, -s, 1.0 + c, c), SVector::<f64, 2>::new(1.0, 0.0))
}

#[test]
fn null_vector_is_continuous_where_the_determinant_changes_sign() {
    let steps = 200;
    let mut before: Option<NullVector<2>> = None;
    for k in 0..=steps {
        let q2 = 1e-3 * f64::from(k - steps / 2);
        let (jacobian, tangent) = planar(q2);
        let null = null_vector(&jacobian, &tangent);
        // adj(J) (1, 0) = (cos q2, -(1 + cos q2)), det J = sin q2: a few roundings of numbers up to 2.
        let wanted = SVector::<f64, 2>::new(q2.cos(), -1.0 - q2.cos());
        assert!((null.joints - wanted).norm() <= 1e-14, "{null:?}");
        assert!((null.path - q2.sin()).abs() <= 1e-15, "{null:?}");
        if let Some(before) = before {
            // The slope is at most 2 per rad.
            assert!((null.joints - before.joints).norm() <= 2e-3 && (null.path - before.path).abs() <= 2e-3);
        }
        before = Some(null);
    }
}

#[test]
fn null_vector_is_zero_where_the_augmented_jacobian_loses_rank() {
    let (jacobian, _) = planar(0.0);
    let null = null_vector(&jacobian, &SVector::<f64, 2>::new(0.0, 3.0));
    assert!(null.norm() <= 1e-15, "{null:?}");
}

#[test]
fn nan_anywhere_makes_all_of_the_null_vector_nan() {
    let (mut jacobian, tangent) = planar(0.3);
    jacobian[(0, 1)] = f64::NAN;
    let null = null_vector(&jacobian, &tangent);
    assert!(null.path.is_nan() && null.joints.iter().all(|x| x.is_nan()));
    let empty = redundant_null_vector::<2>(Task::Pose, &Jacobian::zeros(), &Twist::zeros(), &JointMetric::euclidean());
    assert!(empty.path.is_nan(), "two joints do not serve six coordinates");
}

#[test]
fn weight_that_is_not_positive_is_refused() {
    let refused = JointMetric::new(&JointVector::<2>::new(1.0, 0.0));
    assert_eq!(refused, Err(RobotError::NotPositive { name: "joint weight", value: 0.0 }));
}
