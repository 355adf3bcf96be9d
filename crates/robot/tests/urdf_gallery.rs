//! A gallery of URDFs with one peculiarity each: kinematics and dynamics against pinocchio, limits and notes by hand.
//! `urdf_gallery/reference.py` made the reference values.

use nalgebra::{DVector, SVector, Vector3};
use proptest::prelude::*;
use serde_json::Value;
use slideway_robot::{
    ChainEnds, ForeignFormat, GRAVITY, JointLimits, JointVector, LimitKind, Note, PositionRange, RobotDescription,
    UrdfError, UrdfFault,
};
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/urdf_gallery")
}

fn names() -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder())
        .expect("folder")
        .map(|entry| entry.expect("entry").path())
        .filter(|path| path.extension().is_some_and(|e| e == "urdf"))
        .map(|path| path.file_stem().expect("name").to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

fn text(name: &str) -> String {
    RobotDescription::read_urdf_text(&folder().join(format!("{name}.urdf"))).expect("readable")
}

fn from(base: Option<&str>, tip: Option<&str>) -> ChainEnds {
    ChainEnds { base: base.map(str::to_owned), tip: tip.map(str::to_owned) }
}

fn read(name: &str) -> RobotDescription {
    // The base where it is not the root.
    let base = match name {
        "tilted" => Some("mount"),
        "moved_base" => Some("carriage"),
        _ => None,
    };
    RobotDescription::parse_urdf(&text(name), &from(base, None)).expect(name)
}

fn list(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(items) => items.iter().flat_map(list).collect(),
        number => vec![number.as_f64().expect("number")],
    }
}

/// A robot at one state: pose, Jacobian, mass matrix, gravity torque, inverse dynamics, by rows.
struct State {
    pose: Vec<f64>,
    jacobian: Vec<f64>,
    mass: Vec<f64>,
    gravity: Vec<f64>,
    torque: Vec<f64>,
}

fn rows<const R: usize, const C: usize>(matrix: &nalgebra::SMatrix<f64, R, C>) -> Vec<f64> {
    matrix.row_iter().flat_map(|row| row.iter().copied().collect::<Vec<_>>()).collect()
}

fn state_of<const N: usize>(robot: &RobotDescription, [q, qd, qdd]: [&[f64]; 3]) -> State {
    let [q, qd, qdd] = [q, qd, qdd].map(SVector::<f64, N>::from_column_slice);
    let (arm, dynamics) = (robot.arm::<N>().expect("arm"), robot.dynamics::<N>().expect("dynamics"));
    State {
        pose: rows(&arm.forward(&q).to_homogeneous()),
        jacobian: rows(&arm.jacobian(&q)),
        mass: rows(&dynamics.mass_matrix(&q)),
        gravity: rows(&dynamics.gravity_torque(&q)),
        torque: rows(&dynamics.inverse(&q, &qd, &qdd)),
    }
}

fn state(robot: &RobotDescription, at: [&[f64]; 3]) -> State {
    match robot.joint_count() {
        1 => state_of::<1>(robot, at),
        2 => state_of::<2>(robot, at),
        3 => state_of::<3>(robot, at),
        4 => state_of::<4>(robot, at),
        10 => state_of::<10>(robot, at),
        n => panic!("{n} joints"),
    }
}

fn relative(found: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len());
    let (found, expected) = (DVector::from_column_slice(found), DVector::from_column_slice(expected));
    (found - &expected).norm() / expected.norm()
}

#[test]
fn every_file_agrees_with_pinocchio_in_pose_jacobian_mass_matrix_gravity_and_torque() {
    let reference: Value = serde_json::from_str(include_str!("urdf_gallery/reference.json")).expect("valid JSON");
    let robots = reference["robots"].as_object().expect("robots");
    assert_eq!(robots.keys().cloned().collect::<Vec<_>>(), names());
    assert!(robots.len() >= 20);
    for (name, expected) in robots {
        let robot = read(name);
        assert_eq!(
            (&robot.base, &robot.tip),
            (&expected["base"].as_str().expect("base").into(), &expected["tip"].as_str().expect("tip").into()),
            "{name}"
        );
        for row in expected["states"].as_array().expect("states") {
            let [q, qd, qdd] = ["q", "qd", "qdd"].map(|key| list(&row[key]));
            let found = state(&robot, [&q, &qd, &qdd]);
            let compared = [
                ("pose", found.pose),
                ("jacobian", found.jacobian),
                ("mass_matrix", found.mass),
                ("gravity", found.gravity),
                ("torque", found.torque),
            ];
            for (key, found) in compared {
                let difference = relative(&found, &list(&row[key]));
                assert!(difference <= 1e-12, "{name}, {key}: {difference:e}");
            }
        }
    }
}

fn says(robot: &RobotDescription) -> String {
    robot.notes.iter().map(|note| format!("{note}\n")).collect()
}

#[test]
fn a_plain_file_calls_for_no_note_and_neither_does_decoration() {
    for name in ["plain", "decoration", "empty_axis", "long_axis", "latin1", "expanded_xacro", "base_defects"] {
        assert_eq!(says(&read(name)), "", "{name}");
    }
    assert_eq!(read("latin1").joints[0].name, "ärm");
}

#[test]
fn inertias_that_lack_parts_or_are_no_bodies_are_noted() {
    for (name, expected) in [
        ("bare_inertial", "link `b`: its `<inertial>` has no mass and no inertia, which counts as zero"),
        ("point_mass", "link `b`: its `<inertial>` has no inertia"),
        ("missing_product", "link `b`: its `<inertial>` has no ixz"),
        ("rounding", "link `b` has the negative principal moment"),
        ("speck", "link `antenna` has the negative principal moment"),
        ("triangle", "link `b`: no rigid body has its principal moments 1.000e-2, 1.000e-2 and 5.000e-2"),
    ] {
        let robot = read(name);
        // The choice of a tip among several ends is told beside.
        let others = robot.notes.iter().filter(|note| !matches!(note, Note::TipChosen { .. })).count();
        assert!(says(&robot).contains(expected) && others == 1, "{name}: {}", says(&robot));
    }
}

fn range(lower: f64, upper: f64) -> Option<PositionRange> {
    Some(PositionRange { lower, upper })
}

#[test]
fn missing_and_zero_limits_are_none_and_said_with_the_joint() {
    let robot = read("no_speed");
    assert_eq!(
        robot.joints[0].limits,
        JointLimits { position: range(-1.0, 1.0), effort: Some(30.0), ..JointLimits::default() }
    );
    assert_eq!(robot.joints[1].limits, JointLimits::default());
    assert_eq!(
        robot.notes[0],
        Note::MissingLimit { joints: vec!["j1".into(), "j2".into()], limit: LimitKind::Velocity }
    );
    assert_eq!((robot.notes.len(), robot.velocity_limits()), (3, None));
    assert_eq!(robot.joints_without(LimitKind::Velocity), ["j1", "j2"]);
    let robot = read("zero_limits");
    assert_eq!((robot.joints[0].limits.velocity, robot.joints[0].limits.effort), (None, None));
    assert_eq!(robot.joints_without(LimitKind::Velocity), ["j1"]);
    assert_eq!(robot.notes.len(), 2);
    let robot = read("frozen");
    assert_eq!(
        (robot.joints[0].limits.position, robot.notes.as_slice()),
        (None, &[Note::NoRange { joint: "j1".into() }][..])
    );
}

#[test]
fn limits_count_by_the_version_of_the_file() {
    let robot = read("version_1_2");
    let [first, second] = [0, 1].map(|i| robot.joints[i].limits);
    assert_eq!(
        first,
        JointLimits {
            position: range(-1.5, f64::INFINITY),
            velocity: Some(2.0),
            effort: None,
            acceleration: Some(5.0),
            jerk: Some(40.0)
        }
    );
    assert_eq!(
        second,
        JointLimits {
            position: range(f64::NEG_INFINITY, 1.0),
            effort: Some(7.0),
            acceleration: Some(4.0),
            ..JointLimits::default()
        }
    );
    assert_eq!((robot.acceleration_limits(), robot.notes.len()), (Some(vec![5.0, 4.0]), 1), "{}", says(&robot));
    let robot = read("version_1_0");
    assert_eq!(
        robot.joints[0].limits,
        JointLimits { position: range(0.0, 1.5), velocity: Some(2.0), effort: Some(9.0), ..JointLimits::default() }
    );
    let unread = |attribute| Note::NeedsVersion { joint: "j1".into(), attribute };
    assert_eq!(robot.notes, [unread("acceleration"), unread("jerk")]);
    let newer = text("version_1_2").replace("version=\"1.2\"", "version=\"1.7\"");
    let robot = RobotDescription::parse_urdf(&newer, &ChainEnds::default()).expect("read as 1.2");
    assert!(says(&robot).contains("version `1.7`") && robot.acceleration_limits().is_some());
}

#[test]
fn soft_limits_narrow_the_range_and_zeros_do_not() {
    let robot = read("soft_limits");
    assert_eq!([0, 1].map(|i| robot.joints[i].limits.position), [range(-1.8, 1.7), range(-2.0, 2.0)]);
    assert_eq!(robot.notes.len(), 1);
    let beyond = text("soft_limits").replace("-1.8", "2.5").replace("1.7", "3");
    let error = RobotDescription::parse_urdf(&beyond, &ChainEnds::default()).expect_err("nothing left");
    assert!(error.to_string().contains("joint `j1`: the lower limit 2.5 lies above the upper limit 2"), "{error}");
}

#[test]
fn followers_bind_and_brake_their_leader() {
    let robot = read("mimic");
    assert_eq!((robot.joint_count(), robot.followers.len()), (2, 1));
    assert_eq!(
        robot.notes[0].to_string(),
        "joint `j2` moves with joint `j1`: its position is -0.5 times that plus 0.3"
    );
    // -2 <= 0.3 - q / 2 <= 2, and |q̇ / 2| <= 3, which j1 keeps anyway.
    assert_eq!(robot.joints[0].limits.position, range(-2.0, 2.0));
    let friction = robot.joints[0].drive.friction;
    assert_eq!((friction.viscous, friction.forward, friction.backward), (0.1, 0.1, 0.1));
    let robot = read("mimic_of_mimic");
    assert_eq!(robot.joints.iter().map(|j| j.name.as_str()).collect::<Vec<_>>(), ["j3", "j4"]);
    // j1 at 2 q - 0.1 stays within 2 at up to 3: q from -0.95 to 1.05 at up to 1.5.
    let PositionRange { lower, upper } = robot.joints[0].limits.position.expect("a range");
    assert!((lower + 0.95).abs() < 1e-15 && (upper - 1.05).abs() < 1e-15);
    assert_eq!(robot.joints[0].limits.velocity, Some(1.5));
    let robot = read("mimic_outside");
    let held = Note::HeldMimic { joint: "j2".into(), leader: "lead".into(), position: 0.4 };
    assert!(robot.followers.is_empty() && robot.notes.contains(&held), "{}", says(&robot));
}

/// The rate of the Jacobian and the energies against differences, and the torque against the mass matrix.
#[test]
fn the_laws_of_motion_hold_with_followers() {
    for name in ["mimic", "mimic_of_mimic"] {
        let robot = read(name);
        let (arm, dynamics) = (robot.arm::<2>().expect("arm"), robot.dynamics::<2>().expect("masses"));
        let (q, qd, h) = (JointVector::<2>::new(0.3, -0.4), JointVector::<2>::new(0.7, 1.1), 1e-6);
        let (before, after) = (q - qd * h, q + qd * h);
        let rate = (arm.jacobian(&after) - arm.jacobian(&before)) / (2.0 * h);
        // Central differences: rounding of 1e-16 over h, and h² times third derivatives of order ten.
        assert!((rate - arm.jacobian_rate(&q, &qd)).norm() < 1e-8, "{name}");
        assert!((arm.jacobian_rate_at(&arm.frames(&q), &qd) - arm.jacobian_rate(&q, &qd)).norm() == 0.0);
        let zero = JointVector::<2>::zeros();
        let power = (dynamics.potential_energy(&after) - dynamics.potential_energy(&before)) / (2.0 * h);
        assert!((power - dynamics.gravity_torque(&q).dot(&qd)).abs() < 1e-7, "{name}");
        let qdd = JointVector::<2>::new(-0.2, 0.9);
        let torque = dynamics.inverse(&q, &qd, &qdd);
        let composed = dynamics.mass_matrix(&q) * qdd + dynamics.coriolis_torque(&q, &qd) + dynamics.gravity_torque(&q);
        assert!((torque - composed).norm() < 1e-13 * torque.norm(), "{name}");
        assert!((dynamics.forward(&q, &qd, &torque).expect("regular") - qdd).norm() < 1e-11, "{name}");
        assert_eq!(dynamics.inverse(&q, &zero, &zero), dynamics.gravity_torque(&q));
        let tool = arm.frames(&q).tool;
        assert_eq!((tool, arm.link_poses(&q).len()), (arm.forward(&q), 2));
    }
}

#[test]
fn a_locked_leader_holds_its_followers_and_any_other_joint_keeps_them() {
    let robot = read("mimic_of_mimic");
    let whole = robot.arm::<2>().expect("arm").forward(&[0.4, -0.7].into());
    let (first, second) = (robot.locked("j3", 0.4).expect("in range"), robot.locked("j4", -0.7).expect("in range"));
    assert!((first.followers.len(), second.followers.len()) == (0, 2));
    for (part, q) in [(first, -0.7), (second, 0.4)] {
        let pose = part.arm::<1>().expect("arm").forward(&[q].into());
        assert!((pose.to_homogeneous() - whole.to_homogeneous()).norm() < 1e-15 * 10.0);
        let torque = part.dynamics::<1>().expect("masses").gravity_torque(&[q].into());
        let both = robot.dynamics::<2>().expect("masses").gravity_torque(&[0.4, -0.7].into());
        let expected = both[usize::from(part.joints[0].name == "j4")];
        assert!((torque[0] - expected).abs() < 1e-13);
    }
}

#[test]
fn gravity_is_that_of_the_root_whatever_the_base_and_can_be_replaced() {
    let text = text("tilted");
    let both = [None, Some("mount")].map(|base| RobotDescription::parse_urdf(&text, &from(base, None)).expect("reads"));
    let torques = both.clone().map(|r| r.dynamics::<2>().expect("masses").gravity_torque(&[0.3, -0.4].into()));
    assert!((torques[0] - torques[1]).norm() < 1e-14 * torques[0].norm() && torques[0].norm() > 1.0);
    let [upright, tilted] = both;
    assert_eq!((upright.gravity, upright.notes.len()), (GRAVITY, 0));
    assert!((tilted.gravity.norm() - 9.81).abs() < 1e-14 && matches!(&tilted.notes[0], Note::TiltedBase { .. }));
    let hung = tilted.clone().with_gravity(Some([0.0, 0.0, 1.6])).expect("finite");
    assert_eq!(hung.dynamics::<2>().expect("masses").gravity(), &Vector3::new(0.0, 0.0, 1.6));
    assert_eq!(tilted.clone().with_gravity(None).expect("as it was"), tilted);
    assert!(tilted.with_gravity(Some([0.0, f64::NAN, 0.0])).is_err());
    assert!(says(&read("moved_base")).contains("link `carriage` is moved by joint `turn`"));
}

#[test]
fn a_guessed_tip_is_said_with_the_others() {
    let robot = read("tips");
    assert_eq!((robot.tip.as_str(), robot.tip_alternatives.as_slice()), ("tool0", &["camera_optical".to_owned()][..]));
    assert_eq!(
        robot.notes[0].to_string(),
        "link `tool0` was taken as the tip; the others that could be meant are `camera_optical`"
    );
    let given = RobotDescription::parse_urdf(&text("tips"), &from(None, Some("camera"))).expect("reads");
    assert!(given.tip_alternatives.is_empty() && given.notes.is_empty());
    let robot = read("beside_gripper");
    assert_eq!((robot.tip.as_str(), robot.tip_alternatives.as_slice()), ("left_tool0", &["finger".to_owned()][..]));
    assert_eq!(read("fingers").tip, "hand");
}

fn fault(text: &str) -> UrdfError {
    RobotDescription::parse_urdf(text, &ChainEnds::default()).expect_err(text)
}

#[test]
fn other_formats_are_recognised_and_answered_with_a_way_out() {
    let xacro = "expand it first";
    for (text, line, remedy) in [
        ("<robot xmlns:xacro='urn:x' name='r'><link name='a'/>\n<xacro:include filename='b'/></robot>", 2, xacro),
        ("<robot name='r'>\n<link name='a'/><joint name='${p}j' type='fixed'/></robot>", 2, xacro),
        ("<robot name='r'><link name='a'><xacro:m/></link></robot>", 1, xacro),
        ("<robot name='r' xmlns:xacro='urn:x'></robot>", 1, xacro),
        ("<?xml version='1.0'?>\n<sdf version='1.9'><model name='m'/></sdf>", 2, "Gazebo turns URDF into SDF"),
        ("<mujoco><worldbody/></mujoco>", 1, "MuJoCo reads URDF too"),
        ("<robot name='r'><group name='arm'><chain base_link='a' tip_link='b'/></group></robot>", 1, "belongs to it"),
        ("<html><body/></html>", 1, "root element is `<robot>`"),
        ("not XML at all", 1, "check the XML"),
        ("<robot name='r'>\n<link name='a'>\n</robot>", 2, "check the XML"),
    ] {
        let error = fault(text);
        assert!(error.remedy().contains(remedy), "{text}: {error}; {}", error.remedy());
        assert_eq!(error.place.as_ref().map(|place| place.line), Some(line), "{text}: {error}");
    }
    let in_number = text("plain").replacen("xyz=\"0.3 0.05 0.1\"", "xyz=\"0 0 ${h}\"", 1);
    assert!(matches!(*fault(&in_number).fault, UrdfFault::Xacro { .. }));
    assert!(matches!(*fault("<sdf/>").fault, UrdfFault::OtherFormat { format: ForeignFormat::Sdf }));
}

#[test]
fn refusals_name_the_joint_or_link_the_line_and_the_value() {
    for (name, from, to, says) in [
        (
            "plain",
            "upper=\"2\"",
            "upper=\"wide\"",
            "line 23: joint `j1`: `upper=\"wide\"` of its `<limit>` is not a number",
        ),
        ("plain", "lower=\"-2\"", "lower=\"nan\"", "line 23: joint `j1`: a number in its limit is not finite"),
        ("plain", "<parent link=\"base\"/>", "", "line 19: joint `j1` has no parent link"),
        ("plain", " type=\"revolute\"", "", "line 19: joint `j1` has no type"),
        ("plain", "<joint name=\"j1\"", "<joint", "line 19: a joint has no name"),
        ("plain", "value=\"2.0\"", "value=\"-1\"", "line 6: link `a`: its mass is -1 kg"),
        ("plain", "ixx=\"0.02\"", "ixx=\"-0.02\"", "line 6: link `a`: its inertia matrix has the negative"),
        ("plain", "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 0\"/>", "line 23: joint `j1`: its axis is zero"),
        ("version_1_2", "0.1 0.2 -0.3 0.9273618495495703", "0 0 0 0", "joint `j2`: its `quat_xyzw` is zero"),
        ("mimic", "multiplier=\"-0.5\"", "multiplier=\"half\"", "joint `j2`: `multiplier=\"half\"` of its `<mimic>`"),
        ("mimic", "joint=\"j1\" m", "m", "joint `j2` has no joint to mimic"),
    ] {
        let whole = text(name);
        assert!(whole.contains(from), "{name}: {from}");
        let spoiled = whole.replacen(from, to, 1);
        let error = fault(&spoiled);
        assert!(error.to_string().contains(says), "`{says}` not in: {error}");
        assert!(error.place.is_some() && error.locate(&spoiled).is_some() && error.remedy().len() > 10, "{error}");
    }
    let folder = scratch_file("undeclared.urdf", b"<robot name='r'>\n<link name='\xe4'/></robot>");
    let error = RobotDescription::read_urdf(&folder, &ChainEnds::default()).expect_err("not UTF-8");
    assert!(matches!(*error.fault, UrdfFault::Encoding { declared: None, line: 2, .. }), "{error}");
}

/// A file in the build's own folder for such.
fn scratch_file(name: &str, bytes: &[u8]) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, bytes).expect("written");
    path
}

/// Elements that no reader of kinematics looks at, well or badly made.
const JUNK: [&str; 9] = [
    "<visual/>",
    "<visual><geometry><mesh scale='0.001'/></geometry><material name='m'><texture/></material></visual>",
    "<collision><geometry><box size='a b'/><plane/></geometry></collision>",
    "<gazebo><joint name='j1'/><link/><a x='1' x='2'/></gazebo>",
    "<transmission><joint name='x'/></transmission>",
    "<ros2_control><joint name='j1'><limit lower='x'/></joint></ros2_control>",
    "<material name='m'><color rgba='1 0 0'/></material>",
    "<!-- <limit/> & -->",
    "<unheard_of>&<limit velocity='-1'/><![CDATA[<link/>]]></unheard_of>",
];

/// Kind, origin, turn, axis and mass.
type MadeUpJoint = (usize, [f64; 3], [f64; 3], [f64; 3], f64);

fn chain(joints: &[MadeUpJoint]) -> String {
    let kinds = ["revolute", "prismatic", "continuous", "fixed"];
    let mut text = "<robot name='r'>\n<link name='l0'></link>\n".to_owned();
    for (i, (kind, [x, y, z], [r, p, w], [a, b, c], mass)) in joints.iter().enumerate() {
        let kind = if i == 0 { "revolute" } else { kinds[*kind] };
        text += &format!(
            "<link name='l{0}'><inertial><origin xyz='{y} {z} {x}'/><mass value='{mass}'/><inertia ixx='{mass}' ixy='0' ixz='0' iyy='{mass}' iyz='0' izz='{mass}'/></inertial></link>\n\
             <joint name='j{0}' type='{kind}'><origin xyz='{x} {y} {z}' rpy='{r} {p} {w}'/><parent link='l{i}'/><child link='l{0}'/><axis xyz='{a} {b} {c}'/><limit lower='-1' upper='1' velocity='1' effort='1'/></joint>\n",
            i + 1
        );
    }
    text + "</robot>"
}

fn triple() -> impl Strategy<Value = [f64; 3]> {
    [-1.5..1.5_f64, -1.5..1.5_f64, 0.1..1.5_f64]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn decoration_changes_nothing(
        joints in prop::collection::vec((0..4_usize, triple(), triple(), triple(), 0.1..5.0_f64), 1..13),
        junk in prop::collection::vec((any::<prop::sample::Index>(), 0..JUNK.len()), 1..20),
    ) {
        let plain = chain(&joints);
        let mut decorated = plain.clone();
        for (at, which) in junk {
            // Between elements: before any closing tag, or after any element at the top.
            let places: Vec<usize> = ["</link>", "</joint>", "</robot>", "\n<link", "\n<joint"].iter()
                .flat_map(|tag| decorated.match_indices(tag).map(|(i, _)| i).collect::<Vec<_>>())
                .filter(|i| !inside_junk(&decorated, *i)).collect();
            decorated.insert_str(places[at.index(places.len())], JUNK[which]);
        }
        let [plain, decorated] = [plain, decorated].map(|text| RobotDescription::parse_urdf(&text, &ChainEnds::default()));
        prop_assert_eq!(plain.expect("a chain"), decorated.expect("the same"));
    }
}

/// True if a place lies inside an element that has been inserted.
fn inside_junk(text: &str, at: usize) -> bool {
    JUNK.iter().any(|junk| text.match_indices(junk).any(|(begin, _)| begin < at && at < begin + junk.len()))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn spoiled_gallery_files_never_panic(
        file in any::<prop::sample::Index>(), at in any::<prop::sample::Index>(), length in 0..60_usize,
        bytes in prop_oneof![prop::collection::vec(any::<u8>(), 0..12), prop::sample::select(GRAFTS).prop_map(|s| s.as_bytes().to_vec())],
    ) {
        let names = names();
        let mut text = text(&names[file.index(names.len())]).into_bytes();
        let at = at.index(text.len());
        let end = (at + length).min(text.len());
        text.splice(at..end, bytes);
        let text = String::from_utf8_lossy(&text);
        match RobotDescription::parse_urdf(&text, &ChainEnds::default()) {
            Ok(robot) => {
                let _ = (says(&robot), robot.dynamics::<2>().map(|d| d.gravity_torque(&[0.1, 0.2].into())));
                let _ = (robot.arm::<10>(), robot.locked("j1", 0.1));
            }
            Err(error) => {
                let _ = (error.to_string(), error.remedy());
                prop_assert!(error.place.is_none_or(|place| text.get(place.bytes).is_some()));
            }
        }
    }
}

const GRAFTS: &[&str] = &[
    "1e308",
    "nan",
    "inf",
    "<mimic joint=\"j1\" multiplier=\"1e300\" offset=\"1e300\"/>",
    "<mimic joint='j2'/>",
    "j1",
    "base",
    "</joint>",
    "<joint name='x' type='fixed'><parent link='b'/><child link='base'/></joint>",
    "<!--",
    "<![CDATA[",
    "&lt;",
    "\"",
];
