//! The PUMA-560 against reference data and against its own inverse kinematics.

use nalgebra::{Matrix6, Rotation3, Vector3};
use proptest::prelude::*;
use slideway_robot::{
    Branch, Elbow, InverseMethod, JacobiSvd, JointVector, NumericIk, NumericIkSettings, Shoulder, SphericalWristIk,
    Task, Twist, Wrist, euler, models, rotation_vector, solve_rates,
};

/// Height of the pedestal in the reference data; the paper's base frame sits at the shoulder.
const PEDESTAL: f64 = 0.67183;

fn numbers(value: &serde_json::Value) -> Vec<f64> {
    value.as_array().expect("array").iter().map(|x| x.as_f64().expect("number")).collect()
}

fn rows() -> Vec<serde_json::Value> {
    let text = include_str!("puma560_dynamics.json");
    let data: serde_json::Value = serde_json::from_str(text).expect("valid JSON");
    data["rows"].as_array().expect("rows").clone()
}

#[test]
fn forward_kinematics_agree_with_the_reference_to_1e_12() {
    let arm = models::puma560();
    assert_eq!(rows().len(), 20);
    for row in rows() {
        let pose = arm.forward(&JointVector::<6>::from_vec(numbers(&row["q"]))).to_homogeneous();
        for (i, line) in row["T"].as_array().expect("matrix").iter().enumerate() {
            for (j, expected) in numbers(line).into_iter().enumerate() {
                let height = if (i, j) == (2, 3) { PEDESTAL } else { 0.0 };
                assert!((pose[(i, j)] + height - expected).abs() < 1e-12, "T[{i}][{j}]");
            }
        }
    }
}

#[test]
fn jacobians_agree_with_the_reference_to_1e_12() {
    let arm = models::puma560();
    for row in rows() {
        let jacobian = arm.jacobian(&JointVector::<6>::from_vec(numbers(&row["q"])));
        for (i, line) in row["J"].as_array().expect("matrix").iter().enumerate() {
            for (j, expected) in numbers(line).into_iter().enumerate() {
                assert!((jacobian[(i, j)] - expected).abs() < 1e-12, "J[{i}][{j}]");
            }
        }
    }
}

fn joints() -> impl Strategy<Value = JointVector<6>> {
    prop::array::uniform6(-3.0..3.0_f64).prop_map(JointVector::<6>::from)
}

const BRANCHES: [(Shoulder, Elbow, Wrist); 8] = [
    (Shoulder::Right, Elbow::Up, Wrist::NoFlip),
    (Shoulder::Right, Elbow::Up, Wrist::Flip),
    (Shoulder::Right, Elbow::Down, Wrist::NoFlip),
    (Shoulder::Right, Elbow::Down, Wrist::Flip),
    (Shoulder::Left, Elbow::Up, Wrist::NoFlip),
    (Shoulder::Left, Elbow::Up, Wrist::Flip),
    (Shoulder::Left, Elbow::Down, Wrist::NoFlip),
    (Shoulder::Left, Elbow::Down, Wrist::Flip),
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, max_global_rejects: 100_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_closed_form_branch_reaches_the_pose_and_one_is_the_configuration_it_came_from(q in joints()) {
        let arm = models::puma560();
        let pose = arm.forward(&q);
        let ik = SphericalWristIk::new(&arm).expect("PUMA geometry");
        let mut nearest = f64::INFINITY;
        for (shoulder, elbow, wrist) in BRANCHES {
            let solution = ik.solve(&pose, Branch { shoulder, elbow, wrist }).expect("reachable: it came from a configuration");
            let reached = arm.forward(&solution);
            // A straight or folded arm takes an angle from an arc cosine near 1, which costs half of the digits (1e-8),
            // but moves the tool only in second order; 1e-7 holds with room.
            prop_assert!((reached.translation.vector - pose.translation.vector).norm() < 1e-7);
            prop_assert!(rotation_vector(&(reached.rotation.inverse() * pose.rotation)).norm() < 1e-7);
            let apart = (0..6).map(|i| { let d = (solution[i] - q[i]).abs() % std::f64::consts::TAU; d.min(std::f64::consts::TAU - d) }).fold(0.0, f64::max);
            nearest = nearest.min(apart);
        }
        let jacobian = arm.jacobian(&q);
        // Away from singularities, where angles are well determined, the original configuration is among the eight.
        prop_assume!(jacobian.determinant().abs() > 1e-4);
        prop_assert!(nearest < 1e-6, "nearest branch differs by {nearest}");
    }

    #[test]
    fn numeric_inverse_kinematics_returns_to_a_nearby_configuration(q in joints(), d in prop::array::uniform6(-0.05..0.05_f64)) {
        let arm = models::puma560();
        prop_assume!(arm.jacobian(&q).determinant().abs() > 1e-2);
        let pose = arm.forward(&q);
        let seed = q + JointVector::<6>::from(d);
        let found = NumericIk::new(&arm, Task::Pose, NumericIkSettings::default()).solve(&pose, &seed).expect("converges");
        // Tolerance 1e-12 in the pose, divided by the smallest singular value, which |det J| > 1e-2 keeps above 1e-3.
        prop_assert!((found - q).norm() < 1e-8);
    }

    #[test]
    fn jacobian_is_the_derivative_of_forward_kinematics(q in joints(), qd in prop::array::uniform6(-1.0..1.0_f64)) {
        let arm = models::puma560();
        let qd = JointVector::<6>::from(qd);
        let h = 1e-6;
        let (before, after) = (arm.forward(&(q - qd * h)), arm.forward(&(q + qd * h)));
        let twist = arm.jacobian(&q) * qd;
        let linear = (after.translation.vector - before.translation.vector) / (2.0 * h);
        let angular = rotation_vector(&(after.rotation * before.rotation.inverse())) / (2.0 * h);
        // Central difference: h² times third derivatives (below 100 here) plus rounding 1e-16 / h.
        prop_assert!((linear - twist.fixed_rows::<3>(0)).norm() < 1e-8);
        prop_assert!((angular - twist.fixed_rows::<3>(3)).norm() < 1e-8);
    }

    #[test]
    fn bias_acceleration_is_the_derivative_of_the_jacobian_times_velocity(q in joints(), qd in prop::array::uniform6(-1.0..1.0_f64)) {
        let arm = models::puma560();
        let qd = JointVector::<6>::from(qd);
        let h = 1e-6;
        let naive = (arm.jacobian(&(q + qd * h)) - arm.jacobian(&(q - qd * h))) * qd / (2.0 * h);
        // As above; the derivative is of size 10.
        prop_assert!((naive - arm.bias_acceleration(&q, &qd)).norm() < 1e-7);
    }

    #[test]
    fn regular_configurations_are_inverted_exactly_by_every_method(q in joints(), v in prop::array::uniform6(-1.0..1.0_f64)) {
        let arm = models::puma560();
        let jacobian = arm.jacobian(&q);
        prop_assume!(jacobian.determinant().abs() > 1e-2);
        let twist = Twist::from(v);
        for method in [
            InverseMethod::Adjugate { epsilon: 1e-5 },
            InverseMethod::TruncatedSvd { cutoff: 1e-6 },
            InverseMethod::DampedLeastSquares { damping: 1e-8 },
        ] {
            let speeds = solve_rates(method, Task::Pose, &jacobian, &twist);
            // Damping 1e-8 bends the answer by λ²/σ² < 1e-16 / 1e-6; rounding is amplified by the condition squared.
            prop_assert!((jacobian * speeds - twist).norm() < 1e-8, "{method:?}");
        }
    }

    #[test]
    fn adjugate_times_matrix_is_the_determinant_times_the_identity(entries in prop::collection::vec(-1.0..1.0_f64, 36), drop in any::<bool>()) {
        let mut matrix = Matrix6::from_vec(entries);
        if drop { let row = matrix.row(0) * 2.0; matrix.set_row(3, &row); }
        let determinant = if drop { 0.0 } else { matrix.lu().determinant() };
        let product = slideway_robot::adjugate(&matrix) * matrix;
        // Entries of the adjugate are at most of size 5^2.5 (Hadamard) and each side carries some hundred roundings.
        prop_assert!((product - Matrix6::identity() * determinant).norm() < 1e-11);
    }

    #[test]
    fn jacobi_svd_reproduces_every_matrix_with_orthogonal_factors(entries in prop::collection::vec(-1.0..1.0_f64, 42), drop in any::<bool>(), scale in -8..8_i32) {
        let mut matrix = slideway_robot::Jacobian::<7>::from_vec(entries) * 10f64.powi(scale);
        if drop { let row = matrix.row(0) * 2.0; matrix.set_row(3, &row); }
        let svd = JacobiSvd::new(&matrix).expect("finite");
        let size = matrix.norm();
        // Some ten sweeps of 21 rotations, each a few roundings: 1e-13 leaves a factor of ten.
        prop_assert!((svd.scaled * svd.v.transpose() - matrix).norm() < 1e-13 * size);
        prop_assert!((svd.v.transpose() * svd.v - nalgebra::SMatrix::<f64, 7, 7>::identity()).norm() < 1e-13);
        let gram = svd.scaled.transpose() * svd.scaled;
        for i in 0..7 { for j in 0..i { prop_assert!(gram[(i, j)].abs() < 1e-14 * size * size); } }
    }

    #[test]
    fn nearest_euler_triple_reproduces_the_rotation_and_stays_near(a in prop::array::uniform3(-7.0..7.0_f64), d in prop::array::uniform3(-0.01..0.01_f64)) {
        let previous = Vector3::from(a);
        let now = previous + Vector3::from(d);
        let rotation = euler::rotation(&now);
        let triple = euler::nearest(&rotation, &previous);
        prop_assert!((euler::rotation(&triple).matrix() - rotation.matrix()).norm() < 1e-12);
        // Within pi/2 of the gimbal the other family may lie nearer; away from it the triple itself comes back.
        if now[1].cos().abs() > 0.05 { prop_assert!((triple - now).norm() < 1e-12); }
    }

    #[test]
    fn euler_rate_map_gives_the_angular_velocity(a in prop::array::uniform3(-3.0..3.0_f64), r in prop::array::uniform3(-1.0..1.0_f64)) {
        let (angles, rates) = (Vector3::from(a), Vector3::from(r));
        let h = 1e-6;
        let naive = rotation_vector(&(euler::rotation(&(angles + rates * h)) * euler::rotation(&(angles - rates * h)).inverse())) / (2.0 * h);
        prop_assert!((naive - euler::rate_map(&angles) * rates).norm() < 1e-8);
        let slope = (euler::rate_map(&(angles + rates * h)) - euler::rate_map(&(angles - rates * h))) * rates / (2.0 * h);
        prop_assert!((slope - euler::rate_map_bias(&angles, &rates)).norm() < 1e-8);
    }
}

#[test]
fn gimbal_lock_keeps_the_previous_first_angle_and_the_rotation() {
    let rotation = euler::rotation(&Vector3::new(0.3, std::f64::consts::FRAC_PI_2, 0.1));
    let triple = euler::nearest(&rotation, &Vector3::new(0.25, 1.5, 0.0));
    assert!((triple[0] - 0.25).abs() < 1e-15);
    assert!((euler::rotation(&triple).matrix() - rotation.matrix()).norm() < 1e-15 * 10.0);
}

#[test]
fn exactly_singular_wrist_keeps_the_direction_of_motion() {
    // q5 = 0: the fourth and sixth axes coincide; the adjugate turns both, against each other and without bound but 1/ε.
    let arm = models::puma560();
    let q = JointVector::<6>::new(0.1, 0.9, 3.0, 0.2, 0.0, 0.4);
    let jacobian = arm.jacobian(&q);
    let speeds = solve_rates(
        InverseMethod::Adjugate { epsilon: 1e-5 },
        Task::Pose,
        &jacobian,
        &Twist::new(0.0, 0.0, 0.0, 1.0, 0.3, 0.0),
    );
    assert!(speeds.iter().all(|v| v.is_finite()));
    assert!((speeds[3] + speeds[5]).abs() < 1e-9 * speeds[3].abs(), "self-motion of the wrist");
    assert!(speeds[3].abs() > 100.0);
}

#[test]
fn rotation_vector_of_half_turns_and_small_turns_is_accurate() {
    let axis = nalgebra::Unit::new_normalize(Vector3::new(1.0, -2.0, 0.5));
    for angle in [1e-12, 1e-6, 0.1, 1.0, 3.0, 3.1] {
        let vector = rotation_vector(&Rotation3::from_axis_angle(&axis, angle));
        assert!((vector - axis.into_inner() * angle).norm() < 1e-13_f64.max(1e-12 * angle), "{angle}");
    }
}
