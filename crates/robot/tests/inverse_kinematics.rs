//! Closed-form solutions for every spherical wrist, numeric ones within joint limits, and the built-in models.

mod wrist_partitioned;

use nalgebra::{Rotation3, Translation3, Unit, Vector3};
use proptest::prelude::*;
use slideway_robot::models::{self, Model};
use slideway_robot::{
    DhRow, Joint, JointKind, JointVector, NumericIk, NumericIkSettings, Pose, PositionRange, RobotError, SerialArm,
    Task, manipulability, rotation_vector,
};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use wrist_partitioned::WristPartitionedIk;

fn joints<const N: usize>() -> impl Strategy<Value = JointVector<N>> {
    prop::collection::vec(-3.0..3.0_f64, N).prop_map(JointVector::from_vec)
}

/// Distance of two configurations, each angle up to whole turns.
fn apart(a: &JointVector<6>, b: &JointVector<6>) -> f64 {
    a.zip_map(b, |x, y| ((x - y) - TAU * ((x - y) / TAU).round()).abs()).max()
}

/// A DH table with a spherical wrist: every choice of twist signs, shoulder and elbow offsets, tool length, zero offsets.
fn spherical_arm() -> impl Strategy<Value = SerialArm<6>> {
    (prop::array::uniform5(any::<bool>()), prop::array::uniform6(-0.4..0.4_f64), prop::array::uniform6(-1.0..1.0_f64))
        .prop_map(|(signs, lengths, offsets)| {
            let right = |i: usize| if signs[i] { FRAC_PI_2 } else { -FRAC_PI_2 };
            let rows = [
                (lengths[0], right(0), 0.4),
                (0.45, if signs[4] { 0.0 } else { PI }, lengths[1]),
                (lengths[2], right(1), lengths[3]),
                (0.0, right(2), 0.5),
                (0.0, right(3), 0.0),
                (0.0, 0.0, lengths[4]),
            ];
            let row = |i: usize| DhRow { a: rows[i].0, alpha: rows[i].1, d: rows[i].2, offset: offsets[i] };
            SerialArm::from_dh(std::array::from_fn(row)).expect("finite")
        })
}

fn reaches(arm: &SerialArm<6>, q: &JointVector<6>, pose: &Pose) -> bool {
    let found = arm.forward(q);
    // A straight arm or wrist takes an angle from an arc cosine near 1, which costs half of the digits, but moves the tool
    // in second order only: 1e-7 holds with room.
    (found.translation.vector - pose.translation.vector).norm() < 1e-7
        && rotation_vector(&(found.rotation.inverse() * pose.rotation)).norm() < 1e-7
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, max_global_rejects: 100_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_closed_form_solution_of_every_spherical_wrist_reaches_the_pose_and_one_is_the_origin(
        arm in spherical_arm(), q in joints::<6>(),
    ) {
        let pose = arm.forward(&q);
        let ik = WristPartitionedIk::new(&arm).expect("spherical wrist");
        let solutions = ik.solutions(&pose).expect("reachable: it came from a configuration");
        prop_assert!(solutions.len() <= 8 && solutions.iter().all(|s| reaches(&arm, s, &pose)));
        prop_assume!(arm.jacobian(&q).determinant().abs() > 1e-4);
        let nearest = solutions.iter().map(|s| apart(s, &q)).fold(f64::INFINITY, f64::min);
        prop_assert!(nearest < 1e-6, "{nearest}");
        prop_assert!((ik.nearest(&pose, &q).expect("solutions") - q).amax() < 1e-6);
    }

    #[test]
    fn the_tilted_and_shifted_puma_is_solved_from_its_joints_alone(
        q in joints::<6>(), shift in prop::array::uniform3(-1.0..1.0_f64), turn in prop::array::uniform3(-2.0..2.0_f64),
    ) {
        let placed = Pose::from_parts(Translation3::from(Vector3::from(shift)), Rotation3::from_scaled_axis(turn.into()));
        let mut joints = *models::puma560().joints();
        joints[0].origin = placed * joints[0].origin;
        let arm = SerialArm::new(joints, placed.inverse());
        let pose = arm.forward(&q);
        let solutions = WristPartitionedIk::new(&arm).expect("spherical wrist").solutions(&pose).expect("reachable");
        prop_assert!(solutions.iter().all(|s| reaches(&arm, s, &pose)));
    }

    #[test]
    fn numeric_solutions_with_restarts_lie_within_the_limits_and_reach_the_pose(share in prop::array::uniform7(0.1..0.9_f64)) {
        let robot = Model::Panda.describe().expect("built in");
        let arm = robot.arm::<7>().expect("seven joints");
        let ranges: [Option<PositionRange>; 7] = std::array::from_fn(|i| robot.joints[i].limits.position);
        let q = JointVector::<7>::from_fn(|i, _| ranges[i].map_or(0.0, |r| r.lower + share[i] * (r.upper - r.lower)));
        let pose = arm.forward(&q);
        let ik = NumericIk::new(&arm, Task::Pose, NumericIkSettings::default());
        let middle = JointVector::<7>::from_fn(|i, _| ranges[i].map_or(0.0, |r| 0.5 * (r.lower + r.upper)));
        let found = ik.solve_within(&pose, &middle, &ranges, 200).expect("found within 200 seeds");
        prop_assert!((0..7).all(|i| ranges[i].is_some_and(|r| r.contains(found[i]))));
        let reached = arm.forward(&found);
        prop_assert!((reached.translation.vector - pose.translation.vector).norm() < 1e-11);
        prop_assert!(rotation_vector(&(reached.rotation.inverse() * pose.rotation)).norm() < 1e-11);
    }

    #[test]
    fn manipulability_is_the_root_of_the_determinant_it_stands_for(q in joints::<7>(), p in joints::<6>()) {
        let jacobian = Model::Pa10.describe().expect("built in").arm::<7>().expect("seven").jacobian(&q);
        let naive = (jacobian * jacobian.transpose()).determinant().max(0.0).sqrt();
        // The naive twin squares the condition: 1e-16 of the size 10 under the root.
        prop_assert!((manipulability(Task::Pose, &jacobian) - naive).abs() < 1e-6);
        let jacobian = models::puma560().jacobian(&p);
        prop_assert!((manipulability(Task::Pose, &jacobian) - jacobian.determinant().abs()).abs() < 1e-14 * 10.0);
    }
}

#[test]
fn arms_without_a_spherical_wrist_are_refused_with_the_reason() {
    let ur5e = Model::Ur5e.describe().expect("built in").arm::<6>().expect("six");
    let error = WristPartitionedIk::new(&ur5e).expect_err("three parallel axes");
    assert!(error.to_string().contains("meet in one point"), "{error}");
    let panda = Model::Panda.describe().expect("built in").arm::<7>().expect("seven");
    assert!(matches!(WristPartitionedIk::new(&panda), Err(RobotError::NotSphericalWrist { .. })));
    let mut joints = *models::puma560().joints();
    joints[2].kind = JointKind::Prismatic;
    assert!(WristPartitionedIk::new(&SerialArm::new(joints, Pose::identity())).is_err());
}

#[test]
fn poses_out_of_reach_are_told_with_what_is_missing() {
    let ik = WristPartitionedIk::new(&models::puma560()).expect("spherical wrist");
    let at = |x, y, z| Pose::from_parts(Translation3::new(x, y, z), Rotation3::identity());
    let Err(RobotError::OutOfReach { shortfall, .. }) = ik.solutions(&at(2.0, 0.0, 0.0)) else { panic!("too far") };
    let span = 0.4318 + 0.0203_f64.hypot(0.4318);
    assert!((shortfall - ((4.0 - 0.15005_f64.powi(2)).sqrt() - span)).abs() < 1e-12, "{shortfall}");
    let Err(RobotError::OutOfReach { shortfall, .. }) = ik.solutions(&at(0.1, 0.0, 0.3)) else { panic!("too close") };
    assert!((shortfall - 0.05005).abs() < 1e-12, "{shortfall}");
    assert!(ik.solutions(&at(f64::NAN, 0.0, 0.3)).map_or(true, |s| s.iter().all(|q| q.iter().any(|x| x.is_nan()))));
}

#[test]
fn limits_that_exclude_every_solution_are_reported_as_such() {
    let joint = |at: f64| Joint {
        origin: Pose::from_parts(Translation3::new(at, 0.0, 0.0), Rotation3::identity()),
        axis: Unit::new_normalize(Vector3::z()),
        kind: JointKind::Revolute,
        offset: 0.0,
    };
    let arm = SerialArm::new(
        [joint(0.0), joint(1.0)],
        Pose::from_parts(Translation3::new(1.0, 0.0, 0.0), Rotation3::identity()),
    );
    let ik = NumericIk::new(&arm, Task::PlanarPosition, NumericIkSettings::default());
    let pose = arm.forward(&[0.3, 1.0].into());
    let bent = |lower, upper| [None, Some(PositionRange { lower, upper })];
    // The elbow bends by 1 rad one way or the other; 2π + 1 is brought into its range by a turn.
    for (ranges, elbow) in [(bent(0.0, 3.0), 1.0), (bent(-3.0, 0.0), -1.0), (bent(6.0, 8.0), 1.0 + TAU)] {
        let found = ik.solve_within(&pose, &[0.0, 0.5].into(), &ranges, 20).expect("within the limits");
        assert!((found[1] - elbow).abs() < 1e-9, "{found}");
    }
    let error = ik.solve_within(&pose, &[0.0, 0.5].into(), &bent(1.5, 2.5), 20).expect_err("excluded");
    assert!(matches!(error, RobotError::OutsideLimits { joint: 1, trials: 21, .. }), "{error}");
}

#[test]
fn built_in_models_stand_where_their_makers_say() {
    let tool = |model: Model, q: &[f64]| {
        let robot = model.describe().expect("built in");
        match robot.joint_count() {
            2 => robot.arm::<2>().expect("two").forward(&JointVector::<2>::from_column_slice(q)),
            6 => robot.arm::<6>().expect("six").forward(&JointVector::<6>::from_column_slice(q)),
            _ => robot.arm::<7>().expect("seven").forward(&JointVector::<7>::from_column_slice(q)),
        }
    };
    for (model, q, expected) in [
        (Model::Planar2R, vec![FRAC_PI_2, -FRAC_PI_2], [1.0, 1.0, 0.0]),
        // Stretched upwards: 0.317 + 0.45 + 0.5 + 0.08.
        (Model::Pa10, vec![0.0; 7], [0.0, 0.0, 1.347]),
        (Model::Pa10, vec![0.0, FRAC_PI_2, 0.0, 0.0, 0.0, 0.0, 0.0], [1.03, 0.0, 0.317]),
        // Stretched along -x: a2 + a3, -(d4 + d6), d1 - d5.
        (Model::Ur5e, vec![0.0; 6], [-0.8172, -0.2329, 0.0628]),
        (Model::Ur20, vec![0.0; 6], [-1.5907, -0.3553, 0.077]),
        // Upright: 0.333 + 0.316 + 0.384 less the flange, which points down at 0.088 to the front.
        (Model::Panda, vec![0.0; 7], [0.088, 0.0, 0.926]),
    ] {
        let found = tool(model, &q).translation.vector;
        assert!((found - Vector3::from(expected)).norm() < 1e-12, "{model:?}: {found}");
    }
    for model in Model::ALL {
        assert_eq!(Model::named(model.name()), Some(model));
    }
}

#[test]
fn every_model_with_masses_has_a_positive_definite_mass_matrix() {
    let ur20 = Model::Ur20.describe().expect("built in").dynamics::<6>().expect("masses");
    let q = JointVector::<6>::new(0.3, -1.0, 0.8, 0.2, 0.9, -0.4);
    assert!(ur20.mass_matrix(&q).cholesky().is_some());
    // Stretched along -x, the shoulder carries every link by its lever: Σ m x g.
    let lever = 29.632 * (0.862 - 0.5226) + 7.879 * (0.862 + 0.7287 - 0.3234) + (3.054 + 3.126 + 0.926) * 1.5907;
    let held = ur20.gravity_torque(&JointVector::<6>::zeros());
    assert!((held[1] + 9.81 * lever).abs() < 1e-9, "{held} for {lever}");
    let rods = Model::Planar2R.describe().expect("built in").dynamics::<2>().expect("masses");
    let mass = rods.mass_matrix(&[0.4, 1.1].into());
    // Textbook: 1/3 + 1/3 + 1 + cos q2, 1/3 + cos q2 / 2, 1/3.
    let cosine = 1.1_f64.cos();
    assert!((mass[(0, 0)] - (5.0 / 3.0 + cosine)).abs() < 1e-15 * 10.0);
    assert!((mass[(0, 1)] - (1.0 / 3.0 + 0.5 * cosine)).abs() < 1e-15 * 10.0);
    assert!((mass[(1, 1)] - 1.0 / 3.0).abs() < 1e-15 * 10.0);
    assert_eq!(rods.gravity_torque(&[0.4, 1.1].into()).norm(), 0.0);
}
