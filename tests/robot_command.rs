//! `slideway robot`: the reference states through the command line, and what it says to wrong input.

use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

/// Height of the pedestal in the reference data; the command's base frame sits at the shoulder.
const PEDESTAL: f64 = 0.67183;

fn slideway(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_slideway")).args(arguments).output().expect("runs")
}

fn fixture(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robot/tests/urdf");
    folder.join(name).to_string_lossy().into_owned()
}

fn state(arguments: &[&str]) -> Value {
    let output = slideway(&[&["robot"], arguments, &["--json"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("valid JSON")
}

fn list(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(items) => items.iter().flat_map(list).collect(),
        number => vec![number.as_f64().expect("number")],
    }
}

/// Distance of two vectors or matrices, relative to the size of the expected one.
fn relative(found: &Value, expected: &Value) -> f64 {
    let (found, expected) = (list(found), list(expected));
    assert_eq!(found.len(), expected.len());
    let norm = |v: &mut dyn Iterator<Item = f64>| v.map(|x| x * x).sum::<f64>().sqrt();
    norm(&mut found.iter().zip(&expected).map(|(a, b)| a - b)) / norm(&mut expected.iter().copied())
}

#[test]
fn puma560_agrees_with_all_rows_of_the_reference() {
    let text = include_str!("../crates/robot/tests/puma560_dynamics.json");
    let data: Value = serde_json::from_str(text).expect("valid JSON");
    let rows = data["rows"].as_array().expect("rows");
    assert_eq!(rows.len(), 20);
    for row in rows {
        let joined = |key: &str| list(&row[key]).iter().map(|x| format!("{x:e}")).collect::<Vec<_>>().join(" ");
        let [q, qd, qdd, tau] = ["q", "qd", "qdd", "tau_in"].map(joined);
        let given = ["puma560", "--q", &q, "--qd", &qd, "--qdd", &qdd, "--tau", &tau];
        let rigid = state(&given);
        let mut pose = list(&rigid["pose"]);
        // Entry (3, 4) of the pose is the height.
        pose[11] += PEDESTAL;
        for (found, key) in [(&pose, "T"), (&list(&rigid["jacobian"]), "J")] {
            let worst = found.iter().zip(list(&row[key])).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(worst < 1e-12, "{key}: {worst:e}");
        }
        let rotors = state(&[&given[..], &["--rotor-inertia"]].concat());
        let all = state(&[&given[..], &["--rotor-inertia", "--friction"]].concat());
        for (state, key, reference, tolerance) in [
            (&rigid, "mass_matrix", "M_rigid", 1e-10),
            (&rigid, "gravity", "gravity_torque", 1e-10),
            (&rigid, "coriolis", "coriolis_torque", 1e-10),
            (&rigid, "torque", "tau_rnea_rigid", 1e-10),
            (&rigid, "acceleration", "qdd_fd_rigid", 1e-8),
            (&rigid, "manipulability", "manip_sqrt", 1e-10),
            (&rotors, "mass_matrix", "M_armature", 1e-10),
            (&rotors, "torque", "tau_rnea_armature", 1e-10),
            (&rotors, "acceleration", "qdd_fd_armature", 1e-8),
            (&all, "torque", "tau_rtb_full_with_friction", 1e-10),
            (&all, "acceleration", "qdd_fd_rtb_full_with_friction", 1e-8),
        ] {
            let difference = relative(&state[key], &row[reference]);
            assert!(difference <= tolerance, "{key}: {difference:e}");
        }
    }
}

#[test]
fn every_built_in_robot_and_every_fixture_prints_tables_and_json() {
    let fixtures = ["planar.urdf", "gantry.urdf", "six_axis.urdf", "seven_axis.urdf"].map(fixture);
    let names = ["puma560", "planar-2r", "pa10", "ur5e", "ur20", "panda"].into_iter();
    for name in names.chain(fixtures.iter().map(String::as_str)) {
        let output = slideway(&["robot", name]);
        assert_eq!(output.status.code(), Some(0), "{name}: {}", String::from_utf8_lossy(&output.stderr));
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(text.contains("pose of the tool") && text.contains("manipulability"), "{name}: {text}");
        let state = state(&[name]);
        let object = state.as_object().expect("object");
        let mut keys: Vec<&str> = object.keys().map(String::as_str).collect();
        keys.sort_unstable();
        let expected = [
            "acceleration",
            "coriolis",
            "gravity",
            "jacobian",
            "manipulability",
            "mass_matrix",
            "pose",
            "robot",
            "torque",
        ];
        assert_eq!(keys, expected, "{name}");
        assert_eq!((list(&state["pose"]).len(), list(&state["jacobian"]).len() % 6), (16, 0), "{name}");
    }
}

#[test]
fn a_robot_is_described_with_limits_followers_gravity_and_notes() {
    let gallery = |name: &str| fixture(&format!("../urdf_gallery/{name}"));
    let limited = state(&[&gallery("version_1_2.urdf")])["robot"].clone();
    let expected = serde_json::json!([
        { "name": "j1", "kind": "revolute", "position": [-1.5, null], "speed": 2.0, "acceleration": 5.0, "torque": null },
        { "name": "j2", "kind": "revolute", "position": [null, 1.0], "speed": null, "acceleration": 4.0, "torque": 7.0 },
    ]);
    assert_eq!(limited["joints"], expected, "{limited}");
    let mimic = state(&[&gallery("mimic.urdf")])["robot"].clone();
    let follower = serde_json::json!([{ "name": "j2", "leader": "j1", "ratio": -0.5, "offset": 0.3 }]);
    assert_eq!((&mimic["followers"], mimic["joints"].as_array().map(Vec::len)), (&follower, Some(2)));
    assert!(mimic["notes"][0].as_str().is_some_and(|note| note.contains("`j2` moves with joint `j1`")), "{mimic}");
    let tips = state(&[&gallery("tips.urdf")])["robot"].clone();
    assert!(!tips["tip_alternatives"].as_array().expect("links").is_empty(), "{tips}");
    let text = slideway(&["robot", &gallery("version_1_2.urdf")]).stdout;
    let text = String::from_utf8_lossy(&text);
    assert!(text.contains("acceleration") && text.contains("5.0000") && !text.contains("inf"), "{text}");
}

#[test]
fn a_part_of_a_urdf_between_base_and_tip_can_be_chosen() {
    let state = state(&[&fixture("seven_axis.urdf"), "--base", "link2", "--tip", "link5", "--q", "0.1, pi / 2, -0.3"]);
    assert_eq!(list(&state["jacobian"]).len(), 18);
}

#[test]
fn wrong_input_exits_with_2_and_names_the_place_and_a_remedy() {
    let planar = fixture("planar.urdf");
    let folder = tempfile::tempdir().expect("folder");
    let spoiled = |name: &str, from: &str, to: &str| {
        let path = folder.path().join(name);
        let text = std::fs::read_to_string(fixture("planar.urdf")).expect("fixture");
        assert!(text.contains(from));
        std::fs::write(&path, text.replacen(from, to, 1)).expect("written");
        path.to_string_lossy().into_owned()
    };
    let twice = spoiled("twice.urdf", "name=\"elbow\"", "name=\"shoulder\"");
    let inverted = spoiled("inverted.urdf", "lower=\"-3\"", "lower=\"4\"");
    let open = spoiled("open.urdf", "</robot>", "");
    let long = folder.path().join("long.urdf");
    let links: String = (0..9).map(|i| format!("<link name=\"l{i}\"/>")).collect();
    let joint = |i: usize| {
        format!(
            "<joint name=\"j{i}\" type=\"continuous\"><parent link=\"l{i}\"/><child link=\"l{}\"/><axis xyz=\"0 0 1\"/></joint>",
            i + 1
        )
    };
    let joints: String = (0..8).map(joint).collect();
    std::fs::write(&long, format!("<robot name=\"long\">{links}{joints}</robot>")).expect("written");
    let long = long.to_string_lossy().into_owned();
    for (arguments, says, remedy) in [
        (vec!["nowhere.urdf"], "no file called `nowhere.urdf`", "panda"),
        (vec!["puma56"], "`puma56`", "did you mean `puma560`"),
        (vec![&twice], "two joints are called `shoulder`", "a name of its own"),
        (vec![&inverted], "joint `shoulder`: the lower limit 4 lies above the upper limit 3", "exchange"),
        (vec![&open], "open.urdf", "check the XML"),
        (vec!["."], "cannot read", "path of a URDF file"),
        (vec![&long], "8 joints between `l0` and `l8`", "--tip"),
        (vec![&planar, "--tip", "hand"], "no link called `hand`", "`tool`"),
        (vec![&planar, "--base", "tool", "--tip", "fore"], "not reachable from `tool`", "another tip"),
        (vec!["ur5e", "--tip", "tool"], "--tip", "leave the option out"),
        (vec!["puma560", "--q", "1 2 3"], "--q: 3 numbers given, 6 needed", "--q \"0 0 0 0 0 0\""),
        (vec!["puma560", "--qd", "0 0 0 0 0 x"], "`x`", "give 6 numbers"),
        (vec!["puma560", "--tau", "0 0 0 0 0 nan"], "not a finite number", "give 6 numbers"),
        (vec!["panda", "--tau", "0 0 0 0 0 0 0"], "no masses", "leave the option out"),
        (vec!["ur20", "--friction"], "has no friction", "leave the option out"),
        (vec!["ur20", "--rotor-inertia"], "has no rotor inertia", "leave the option out"),
    ] {
        let output = slideway(&[&["robot"], arguments.as_slice()].concat());
        // Long messages are wrapped for the terminal.
        let printed = String::from_utf8_lossy(&output.stderr);
        let printed: String = printed.split_whitespace().filter(|w| *w != "│").collect::<Vec<_>>().join(" ");
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {printed}");
        assert!(printed.contains(says), "{arguments:?}: `{says}` not in: {printed}");
        assert!(printed.contains(remedy) && !printed.contains("panicked"), "{arguments:?}: {printed}");
    }
}

#[test]
fn a_robot_is_read_from_the_table_in_a_scenario_too() {
    let folder = tempfile::tempdir().expect("folder");
    let file = folder.path().join("arm.toml");
    let text = "[robot]\ndh = [{ a = 1, alpha = 0, d = 0 }, { a = 1, alpha = 0, d = 0 }]\n";
    std::fs::write(&file, text).expect("written");
    let found = state(&[&file.to_string_lossy(), "--q", "0.3 0.4"]);
    let built_in = state(&["planar-2r", "--q", "0.3 0.4"]);
    assert_eq!(found["pose"], built_in["pose"]);
    // Of two unit rods the determinant of Jᵀ J, turn included, is 2 - cos² q2.
    let expected = (2.0 - 0.4_f64.cos().powi(2)).sqrt();
    assert!((built_in["manipulability"].as_f64().expect("number") - expected).abs() < 1e-14);
    std::fs::write(&file, text.replace("d = 0 }]", "d = \"nan\" }]")).expect("written");
    let output = slideway(&["robot", &file.to_string_lossy()]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("arm.toml:2"));
}
