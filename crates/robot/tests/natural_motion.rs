//! Singularity-consistent inversion of whole arms: derivative, torque, factors, locked joints.

use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;
use slideway_robot::augmented::{Flow, NullVector, PathTangent, SingularityConsistent, SpeedFactor, path_torque};
use slideway_robot::models::{self, Model};
use slideway_robot::{
    Dynamics, JointLimits, JointVector, LinkInertia, PositionRange, RobotDescription, RobotError, SerialArm, Task,
    Twist,
};

type Numbers = [f64; 6];

/// A path whose twist is linear in its parameter: enough for any first derivative.
fn tangent(twist: &Numbers, slope: &Numbers) -> PathTangent {
    PathTangent { twist: Twist::from(*twist), slope: Twist::from(*slope) }
}

fn numbers() -> impl Strategy<Value = Numbers> {
    prop::array::uniform6(-1.0..1.0_f64)
}

fn pa10() -> SerialArm<6> {
    let robot = Model::Pa10.describe().and_then(|r| r.locked("joint3", 0.0)).expect("built in");
    robot.arm().expect("six joints")
}

fn inversion(factor: SpeedFactor) -> SingularityConsistent {
    SingularityConsistent::new(Task::Pose, factor, 6).expect("square")
}

/// Derivative of `n̄` along itself by central differences.
fn differences(
    inversion: &SingularityConsistent,
    arm: &SerialArm<6>,
    q: &JointVector<6>,
    tangent: &PathTangent,
    flow: &Flow<6>,
) -> NullVector<6> {
    let h = 1e-5;
    let at = |k: f64| {
        let twist = tangent.twist + tangent.slope * (k * h * flow.direction.path);
        inversion.direction(arm, &(q + flow.direction.joints * (k * h)), &twist)
    };
    let (ahead, behind) = (at(1.0), at(-1.0));
    NullVector { joints: ahead.joints - behind.joints, path: ahead.path - behind.path }.scaled(0.5 / h)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    // Lengths below 1 m and unit vectors: derivatives of order k grow like 6^k times |n̄|^k; h² times the third over six is
    // 1e-10 · 36, the roundings 1e-16 / h = 1e-11. In shares of (1 + |n̄|)³.
    #[test]
    fn derivative_along_the_flow_is_that_of_finite_differences(q in numbers(), twist in numbers(), slope in numbers()) {
        let q = JointVector::from(q) * 3.0;
        let tangent = tangent(&twist, &slope);
        let puma = models::puma560();
        for arm in [puma, pa10()] {
            let inversion = inversion(SpeedFactor::Determinant);
            let flow = inversion.flow(&arm, &q, &tangent);
            let NullVector { joints, path } = differences(&inversion, &arm, &q, &tangent, &flow);
            let size = (1.0 + flow.direction.norm()).powi(3);
            prop_assert!((flow.slope.joints - joints).norm() <= 1e-8 * size);
            prop_assert!((flow.slope.path - path).abs() <= 1e-8 * size);
        }
    }

    // As above, with the wrist at least 0.3 rad from its singularity, so that dividing by its sine costs a factor 1 / 0.3
    // per order.
    #[test]
    fn derivative_of_the_partial_factor_is_that_of_finite_differences(
        q in numbers(), twist in numbers(), slope in numbers(), bend in 0.3..1.5_f64,
    ) {
        let mut q = JointVector::from(q) * 3.0;
        q[4] = bend;
        let tangent = tangent(&twist, &slope);
        let inversion = inversion(SpeedFactor::Arm { scale: 0.225 });
        let flow = inversion.flow(&pa10(), &q, &tangent);
        let NullVector { joints, path } = differences(&inversion, &pa10(), &q, &tangent, &flow);
        let size = (1.0 + flow.direction.norm()).powi(3);
        prop_assert!((flow.slope.joints - joints).norm() <= 1e-6 * size);
        prop_assert!((flow.slope.path - path).abs() <= 1e-6 * size);
    }

    // Positions below 1 m: the determinant has a few roundings of 1e-16, its factors are divided out once.
    #[test]
    fn partial_factor_of_the_pa10_is_the_wrists_reach_times_the_elbows_sine(
        q in numbers(), twist in numbers(), bend in 0.3..1.5_f64,
    ) {
        let mut q = JointVector::from(q) * 3.0;
        q[4] = bend;
        let wrist = pa10().frames(&q).origins[4];
        let reach = wrist.x * q[0].cos() + wrist.y * q[0].sin();
        let found = inversion(SpeedFactor::Arm { scale: 0.225 }).direction(&pa10(), &q, &Twist::from(twist));
        prop_assert!((found.path - reach * q[2].sin()).abs() <= 1e-13);
        let whole = inversion(SpeedFactor::Determinant).direction(&pa10(), &q, &Twist::from(twist));
        let factored = -0.225 * reach * q[2].sin() * q[4].sin();
        prop_assert!((whole.path - factored).abs() <= 1e-14, "{} {factored}", whole.path);
    }

    #[test]
    fn torque_along_the_path_is_that_of_inverse_dynamics(
        q in numbers(), twist in numbers(), slope in numbers(), b in -3.0..3.0_f64, b_rate in -3.0..3.0_f64,
    ) {
        let dynamics = models::puma560_dynamics().expect("built in");
        let q = JointVector::from(q) * 3.0;
        let flow = inversion(SpeedFactor::Determinant).flow(dynamics.arm(), &q, &tangent(&twist, &slope));
        let motion = flow.motion(b, b_rate);
        let exact = dynamics.inverse(&q, &motion.joint_speed, &motion.joint_acceleration);
        let found = path_torque(&dynamics, &q, &flow).at(b, b_rate);
        prop_assert!((found - exact).norm() <= 1e-9 * exact.norm(), "{found} {exact}");
    }

    #[test]
    fn largest_b_uses_up_the_peak_torque_of_one_joint(q in numbers(), twist in numbers(), slope in numbers()) {
        let dynamics = models::puma560_dynamics().expect("built in");
        let q = JointVector::from(q) * 3.0;
        let flow = inversion(SpeedFactor::Determinant).flow(dynamics.arm(), &q, &tangent(&twist, &slope));
        let torque = path_torque(&dynamics, &q, &flow);
        let peak = torque.gravity.amax() + 10.0;
        let b = torque.largest_b(peak).expect("gravity leaves 10 N·m");
        // Roundings of the division and the root.
        prop_assert!((torque.at(b, 0.0).amax() - peak).abs() <= 1e-12 * peak);
        prop_assert!(torque.largest_b(0.9 * torque.gravity.amax()).is_none());
    }
}

/// Eq 10 and 11 as printed leave out what the path's own turning contributes.
#[test]
fn derivative_without_the_path_parameter_misses_the_torque() {
    let dynamics = models::puma560_dynamics().expect("built in");
    let q = JointVector::from([0.1, 0.8, -2.6, 0.4, 1.1, 0.2]);
    let inversion = inversion(SpeedFactor::Determinant);
    let bent = tangent(&[0.0, 1.0, 0.0, 0.0, 0.0, 0.0], &[-1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    let flow = inversion.flow(dynamics.arm(), &q, &bent);
    let printed = inversion.flow(dynamics.arm(), &q, &PathTangent { slope: Twist::zeros(), ..bent });
    let difference = path_torque(&dynamics, &q, &flow).inertial - path_torque(&dynamics, &q, &printed).inertial;
    assert!(difference.norm() > 0.1 * path_torque(&dynamics, &q, &flow).inertial.norm());
}

#[test]
fn joints_go_on_through_a_singularity_while_the_path_stands_and_turns() {
    let arm = Model::Planar2R.describe().expect("built in").arm::<2>().expect("two joints");
    let inversion = SingularityConsistent::new(Task::PlanarPosition, SpeedFactor::Determinant, 2).expect("square");
    // Straight out along x; the boundary is reached at q2 = 0 and the arm folds the other way.
    let outwards = PathTangent { twist: Twist::new(1.0, 0.0, 0.0, 0.0, 0.0, 0.0), slope: Twist::zeros() };
    let mut q = JointVector::<2>::new(-0.2, 0.4);
    let (mut parameter, h) = (0.0, 1e-3);
    let first = arm.forward(&q).translation.vector;
    let mut signs = [false; 2];
    for _ in 0..400 {
        let null = inversion.direction(&arm, &q, &outwards.twist);
        // The middle of a step: second order.
        let half = inversion.direction(&arm, &(q + null.joints * (0.5 * h)), &outwards.twist);
        assert!(half.joints.norm() >= 1.0 && half.joints.norm() <= 3.0, "{half:?}");
        signs[usize::from(half.path > 0.0)] = true;
        q += half.joints * h;
        parameter += half.path * h;
    }
    assert!(q[1] < -0.2 && signs == [true, true], "{q}");
    let tip = arm.forward(&q).translation.vector;
    // Midpoint rule: h² / 24 times third derivatives of order 10, over 0.4 s.
    assert!((tip - first - Vector3::x() * parameter).norm() <= 1e-5, "{tip} {parameter}");
}

fn panda_with_masses() -> RobotDescription {
    let mut robot = Model::Panda.describe().expect("built in");
    for (i, joint) in robot.joints.iter_mut().enumerate() {
        let x = 0.1 * (1.0 + i as f64);
        joint.link = LinkInertia {
            mass: 1.0 + x,
            com: Vector3::new(0.1 * x, -0.05, 0.1 - 0.1 * x),
            inertia: Matrix3::from_diagonal(&Vector3::new(0.02, 0.03, 0.01 + 0.01 * x)),
        };
    }
    robot
}

/// The joint vector of the whole arm, with the locked joint at `position`.
fn inserted(q: &JointVector<6>, joint: usize, position: f64) -> JointVector<7> {
    JointVector::from_fn(|i, _| match i.cmp(&joint) {
        std::cmp::Ordering::Less => q[i],
        std::cmp::Ordering::Equal => position,
        std::cmp::Ordering::Greater => q[i - 1],
    })
}

#[test]
fn locked_arm_moves_and_weighs_like_the_whole_one_with_that_joint_still() {
    let robot = panda_with_masses();
    let whole: Dynamics<7> = robot.dynamics().expect("rigid bodies");
    for joint in 0..7 {
        // Inside every range.
        let position = if joint == 3 { -1.2 } else { 0.7 };
        let locked = robot.locked(&format!("joint{}", joint + 1), position).expect("in range");
        let arm: Dynamics<6> = locked.dynamics().expect("rigid bodies");
        let q = JointVector::from([0.3, -0.4, 0.5, -1.1, 0.8, 0.2]);
        let qd = JointVector::from([0.5, -0.2, 0.3, 0.7, -0.6, 0.4]);
        let qdd = JointVector::from([-0.3, 0.6, 0.2, -0.5, 0.1, 0.9]);
        let (q7, qd7, qdd7) = (inserted(&q, joint, position), inserted(&qd, joint, 0.0), inserted(&qdd, joint, 0.0));
        let gap = arm.arm().forward(&q).to_homogeneous() - whole.arm().forward(&q7).to_homogeneous();
        // Some hundred roundings of lengths of 1 m, torques of 100 N·m.
        assert!(gap.norm() <= 1e-14, "{gap}");
        let torque = inserted(&arm.inverse(&q, &qd, &qdd), joint, 0.0);
        let mut wanted = whole.inverse(&q7, &qd7, &qdd7);
        wanted[joint] = 0.0;
        assert!((torque - wanted).norm() <= 1e-12, "{torque} {wanted}");
    }
}

#[test]
fn lock_that_cannot_be_is_an_error_with_a_remedy() {
    let mut robot = Model::Planar2R.describe().expect("built in");
    assert!(matches!(robot.locked("wrist", 0.0), Err(RobotError::UnknownJoint { .. })));
    assert!(matches!(robot.locked("joint1", f64::NAN), Err(RobotError::NotFinite { joint: 0, .. })));
    let position = Some(PositionRange { lower: -1.0, upper: 1.0 });
    robot.override_limits("joint1", JointLimits { position, ..JointLimits::default() }).expect("a range");
    let outside = robot.locked("joint1", 2.0).expect_err("outside");
    assert!(matches!(outside, RobotError::LockedOutsideLimits { .. }) && !outside.remedy().is_empty());
    let one = robot.locked("joint1", 0.5).expect("inside");
    assert!(matches!(one.locked("joint2", 0.0), Err(RobotError::JointCount { found: 1, .. })));
}

#[test]
fn inversion_that_does_not_fit_the_arm_is_refused() {
    let make = SingularityConsistent::new;
    assert!(matches!(make(Task::Pose, SpeedFactor::Determinant, 7), Err(RobotError::NotSquare { rows: 6, joints: 7 })));
    let arm = |scale| SpeedFactor::Arm { scale };
    assert!(matches!(make(Task::Pose, arm(f64::NAN), 6), Err(RobotError::NotPositive { .. })));
    assert!(matches!(make(Task::PlanarPose, arm(1.0), 3), Err(RobotError::NotSphericalWrist { .. })));
}
