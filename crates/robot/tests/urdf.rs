//! Arms from URDF files. The fixtures were written for these tests, in the style of what makers of arms publish.

use nalgebra::Vector3;
use proptest::prelude::*;
use slideway_robot::models::Model;
use slideway_robot::{
    ChainEnds, JointKind, JointLimits, JointVector, PositionRange, RobotDescription, RobotError, UrdfError, UrdfFault,
};

const PLANAR: &str = include_str!("urdf/planar.urdf");
const GANTRY: &str = include_str!("urdf/gantry.urdf");
const SIX: &str = include_str!("urdf/six_axis.urdf");
const SEVEN: &str = include_str!("urdf/seven_axis.urdf");

fn read(text: &str) -> RobotDescription {
    RobotDescription::parse_urdf(text, &ChainEnds::default()).expect("a good URDF")
}

fn between(text: &str, base: &str, tip: &str) -> Result<RobotDescription, UrdfError> {
    let named = |name: &str| Some(name.to_owned()).filter(|n| !n.is_empty());
    RobotDescription::parse_urdf(text, &ChainEnds { base: named(base), tip: named(tip) })
}

#[test]
fn a_planar_urdf_has_the_joints_limits_masses_and_friction_it_states() {
    let robot = read(PLANAR);
    assert_eq!((robot.base.as_str(), robot.tip.as_str(), robot.joint_count()), ("ground", "tool", 2));
    let [shoulder, elbow] = robot.joints.as_slice() else { panic!("two joints") };
    assert_eq!(shoulder.limits.position, Some(PositionRange { lower: -3.0, upper: 3.0 }));
    assert_eq!((shoulder.limits.velocity, shoulder.limits.effort), (Some(2.0), Some(40.0)));
    assert_eq!(elbow.limits.position, None, "continuous");
    assert_eq!(elbow.joint.axis, Vector3::y_axis(), "axes are normalised");
    assert_eq!((shoulder.drive.friction.viscous, shoulder.drive.friction.backward), (0.1, 0.2));
    // The tool's mass is merged into the forearm: 1 kg at 0.2 m and 0.5 kg at 0.4 m.
    assert_eq!(elbow.link.mass, 1.5);
    assert!((elbow.link.com.z - 0.4 / 1.5).abs() < 1e-15);
    assert!(robot.notes.is_empty());
    let arm = robot.arm::<2>().expect("two joints");
    let tool = arm.forward(&[0.3, 0.4].into()).translation.vector;
    let expected =
        Vector3::new(0.5 * 0.3_f64.sin() + 0.4 * 0.7_f64.sin(), 0.0, 0.5 * 0.3_f64.cos() + 0.4 * 0.7_f64.cos());
    assert!((tool - expected).norm() < 1e-15 * 10.0);
    // Hanging out along x, gravity pulls down: about +y that is a positive turn, so the torque that holds is negative.
    let torque = robot.dynamics::<2>().expect("masses").gravity_torque(&[std::f64::consts::FRAC_PI_2, 0.0].into());
    assert!((torque[1] + 9.81 * (0.2 + 0.5 * 0.4)).abs() < 1e-12);
    assert!((torque[0] + 9.81 * (2.0 * 0.25 + 0.7 + 0.5 * 0.9)).abs() < 1e-12);
}

#[test]
fn slides_carry_weight_as_forces_and_move_without_turning() {
    let robot = read(GANTRY);
    let kinds: Vec<JointKind> = robot.joints.iter().map(|j| j.joint.kind).collect();
    assert_eq!(kinds, [JointKind::Prismatic, JointKind::Prismatic, JointKind::Revolute]);
    let tool = robot.arm::<3>().expect("three").forward(&[0.7, -0.2, 0.0].into()).translation.vector;
    assert!((tool - Vector3::new(0.7, 0.0, 0.5)).norm() < 1e-15);
    let dynamics = robot.dynamics::<3>().expect("masses");
    let force = dynamics.inverse(&[0.7, -0.2, 0.0].into(), &JointVector::<3>::zeros(), &[2.0, 1.0, 0.0].into());
    assert!((force[0] - 26.0 * 2.0).abs() < 1e-12 && (force[1] - 6.0 * (9.81 + 1.0)).abs() < 1e-12);
}

#[test]
fn a_six_axis_urdf_ends_at_its_tool_frame_and_moves_like_its_dh_table() {
    let robot = read(SIX);
    assert_eq!((robot.base.as_str(), robot.tip.as_str(), robot.joint_count()), ("world", "tool0", 6));
    assert!(robot.velocity_limits().is_some_and(|v| v == [3.2; 6]));
    let (urdf, table) =
        (robot.arm::<6>().expect("six"), Model::Ur5e.describe().expect("built in").arm::<6>().expect("six"));
    for q in [[0.0; 6], [0.1, -0.7, 1.2, -0.4, 0.9, 2.0], [-2.0, 1.0, -0.3, 0.2, -1.0, 0.5]] {
        let q = JointVector::<6>::from(q);
        let difference = urdf.forward(&q).to_homogeneous() - table.forward(&q).to_homogeneous();
        assert!(difference.norm() < 1e-14 * 10.0, "{difference}");
        assert!((urdf.jacobian(&q) - table.jacobian(&q)).norm() < 1e-14 * 10.0);
    }
    assert!(robot.dynamics::<6>().expect("masses").mass_matrix(&JointVector::<6>::zeros()).cholesky().is_some());
}

#[test]
fn a_seven_axis_urdf_with_a_gripper_ends_between_the_fingers_and_carries_them() {
    let robot = read(SEVEN);
    assert_eq!((robot.tip.as_str(), robot.joint_count()), ("hand_tcp", 7));
    assert_eq!(robot.notes.len(), 3);
    let says: Vec<String> = robot.notes.iter().map(ToString::to_string).collect();
    assert!(
        says.iter().any(|note| note.contains("`finger2` (it mimics `finger1`) is not part of the arm")),
        "{says:?}"
    );
    assert_eq!(robot.tip_alternatives, ["flange", "left_finger", "right_finger"]);
    // Link 7 weighs 0.9, the hand 0.7, two fingers 0.1 each.
    assert!((robot.joints[6].link.mass - 1.8).abs() < 1e-15 * 4.0);
    let flange = between(SEVEN, "", "flange").expect("a link").arm::<7>().expect("seven");
    let table = Model::Panda.describe().expect("built in").arm::<7>().expect("seven");
    let q = JointVector::<7>::from([0.1, -0.7, 0.3, -2.2, 0.4, 1.6, 0.8]);
    assert!((flange.forward(&q).to_homogeneous() - table.forward(&q).to_homogeneous()).norm() < 1e-14 * 10.0);
    // A part of the arm, from its middle.
    let part = between(SEVEN, "link2", "link5").expect("on the way");
    assert_eq!(part.joints.iter().map(|j| j.name.as_str()).collect::<Vec<_>>(), ["joint3", "joint4", "joint5"]);
}

#[test]
fn wrong_files_are_refused_with_the_element_and_a_remedy() {
    let planar = |from: &str, to: &str| {
        assert!(PLANAR.contains(from), "{from}");
        between(&PLANAR.replacen(from, to, 1), "", "")
    };
    let cases = [
        (planar("</robot>", ""), "not a URDF"),
        (
            planar("<mass value=\"2\"/>", "<mass value=\"two\"/>"),
            "link `upper`: `value=\"two\"` of its `<mass>` is not a number",
        ),
        (planar("xyz=\"0 0 0.5\"", "xyz=\"0 0\""), "joint `elbow`: `xyz=\"0 0\"` of its `<origin>` is not 3 numbers"),
        (planar("name=\"elbow\"", "name=\"shoulder\""), "two joints are called `shoulder`"),
        (
            planar("<link name=\"ground\"/>", "<link name=\"ground\"/><link name=\"tool\"/>"),
            "two links are called `tool`",
        ),
        (
            planar("lower=\"-3\" upper=\"3\"", "lower=\"3\" upper=\"-3\""),
            "joint `shoulder`: the lower limit 3 lies above",
        ),
        (planar("velocity=\"3\"", "velocity=\"-3\""), "joint `elbow`: the velocity limit is -3"),
        (planar("xyz=\"0 2 0\"", "xyz=\"0 0 0\""), "joint `elbow`: its axis is zero"),
        (planar("xyz=\"0 2 0\"", "xyz=\"nan 0 0\""), "joint `elbow`: its axis is zero or not finite"),
        (planar("xyz=\"0 0 0.5\"", "xyz=\"0 0 inf\""), "joint `elbow`: a number in its origin"),
        (planar("<mass value=\"2\"/>", "<mass value=\"-2\"/>"), "link `upper`: its mass is -2"),
        (planar("ixx=\"0.05\"", "ixx=\"-0.05\""), "link `upper`: its inertia matrix has the negative"),
        (planar("damping=\"0.1\"", "damping=\"-0.1\""), "joint `shoulder`: its viscous friction is -0.1"),
        (planar("<child link=\"fore\"/>", "<child link=\"four\"/>"), "its child link `four` does not exist"),
        (
            planar("<child link=\"tool\"/>", "<child link=\"fore\"/>"),
            "the child of both joint `elbow` and joint `tool_mount`",
        ),
        (planar("<parent link=\"ground\"/>", "<parent link=\"fore\"/>"), "loop"),
        (planar("<link name=\"ground\"/>", "<link name=\"ground\"/><link name=\"lost\"/>"), "`ground`, `lost`"),
        (planar("type=\"continuous\"", "type=\"planar\""), "joint `elbow` is planar"),
        (
            planar("<axis xyz=\"0 2 0\"/>", "<axis xyz=\"0 2 0\"/><mimic joint=\"elbow\"/>"),
            "joint `elbow` mimics itself",
        ),
        (
            planar("<axis xyz=\"0 2 0\"/>", "<axis xyz=\"0 2 0\"/><mimic joint=\"knee\"/>"),
            "joint `elbow` mimics joint `knee`, which does not exist",
        ),
        (between(PLANAR, "tool", "upper"), "link `upper` is not reachable from `tool`"),
        (between(PLANAR, "", "hand"), "no link called `hand`"),
        (between(PLANAR, "fore", "tool"), "no joint between `fore` and `tool` moves"),
        (between("<robot name=\"r\"/>", "", ""), "no link"),
        (between(SEVEN, "hand", ""), "branches at link `hand`"),
        (between(&format!("<robot name=\"r\">{}", "<a>".repeat(100_000)), "", ""), "`<a>` is never closed"),
    ];
    for (result, says) in cases {
        let error = result.expect_err(says);
        assert!(error.to_string().contains(says), "`{says}` not in: {error}");
        assert!(error.remedy().len() > 10, "{error}");
    }
    let missing = RobotDescription::read_urdf(std::path::Path::new("no/such.urdf"), &ChainEnds::default());
    let missing = missing.expect_err("no file");
    assert!(matches!(*missing.fault, UrdfFault::Read { .. }) && missing.place.is_none());
}

#[test]
fn errors_point_at_the_name_of_the_element() {
    let spoiled = PLANAR.replace("name=\"elbow\"", "name=\"shoulder\"");
    let error = between(&spoiled, "", "").expect_err("named twice");
    let place = error.locate(&spoiled).expect("in the text");
    assert_eq!(&spoiled[place.clone()], "shoulder");
    assert!(place.start > spoiled.find("fore").expect("there") - 600, "the second of the two");
}

#[test]
fn limits_can_be_overridden_by_name_and_wrong_ones_are_refused() {
    let mut robot = read(PLANAR);
    let slow = JointLimits { velocity: Some(0.5), ..JointLimits::default() };
    robot.override_limits("elbow", slow).expect("positive");
    assert_eq!(robot.velocity_limits(), Some(vec![2.0, 0.5]));
    let inverted = JointLimits { position: Some(PositionRange { lower: 1.0, upper: f64::NAN }), ..slow };
    assert!(matches!(robot.override_limits("elbow", inverted), Err(RobotError::InvertedLimits { .. })));
    assert!(matches!(robot.override_limits("knee", slow), Err(RobotError::UnknownJoint { .. })));
    let stuck = JointLimits { velocity: Some(0.0), ..slow };
    assert!(matches!(robot.override_limits("elbow", stuck), Err(RobotError::LimitNotPositive { .. })));
    assert_eq!(robot.velocity_limits(), Some(vec![2.0, 0.5]), "a refused override changes nothing");
    assert!(matches!(robot.arm::<3>(), Err(RobotError::JointCount { found: 2, expected: 3 })));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn arbitrary_bytes_never_panic_the_reader(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let _ = between(&String::from_utf8_lossy(&bytes), "", "");
    }

    #[test]
    fn spoiled_files_never_panic_the_reader(
        file in 0..4_usize, at in any::<prop::sample::Index>(), length in 0..40_usize, bytes in prop::collection::vec(any::<u8>(), 0..12),
    ) {
        let mut text = [PLANAR, GANTRY, SIX, SEVEN][file].as_bytes().to_vec();
        let at = at.index(text.len());
        let end = (at + length).min(text.len());
        text.splice(at..end, bytes);
        if let Ok(robot) = between(&String::from_utf8_lossy(&text), "", "") {
            let _ = (robot.arm::<2>(), robot.dynamics::<6>(), robot.dynamics::<7>());
        }
    }

    #[test]
    fn any_number_in_any_place_is_refused_or_gives_a_finite_description(place in any::<prop::sample::Index>(), number in prop::num::f64::ANY) {
        let quoted: Vec<(usize, &str)> = PLANAR.match_indices("=\"").map(|(i, _)| (i + 2, &PLANAR[i + 2..])).collect();
        let numeric: Vec<_> = quoted.into_iter().filter(|(_, t)| t.starts_with(|c: char| c.is_ascii_digit() || c == '-')).collect();
        let (begin, rest) = numeric[place.index(numeric.len())];
        let length = rest.find(['"', ' ']).expect("closed");
        let text = format!("{}{number}{}", &PLANAR[..begin], &PLANAR[begin + length..]);
        if let Ok(robot) = between(&text, "", "") {
            prop_assert!(robot.joints.iter().all(|j| j.joint.origin.translation.vector.iter().all(|x| x.is_finite())));
        }
    }
}
