//! Scenarios with robots of every kind: built in, from URDF files, sliding joints, seven joints.

mod support;

use serde_json::Value;
use std::path::Path;
use support::slideway;

/// A folder with a scenario in `scenarios/` and the URDF fixtures in `robots/`: paths are relative to the scenario file.
fn folder(scenario: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("folder");
    for name in ["scenarios", "robots"] {
        std::fs::create_dir(folder.path().join(name)).expect("created");
    }
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robot/tests/urdf");
    for name in ["gantry.urdf", "seven_axis.urdf", "planar.urdf"] {
        std::fs::copy(fixtures.join(name), folder.path().join("robots").join(name)).expect("copied");
    }
    std::fs::write(folder.path().join("scenarios/mine.toml"), scenario).expect("written");
    folder
}

fn compare(scenario: &str) -> Value {
    let folder = folder(scenario);
    let output = slideway(folder.path(), &["compare", "scenarios/mine.toml", "--json"]);
    let status = output.status.code();
    assert!(matches!(status, Some(0 | 1)), "{status:?} {}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("valid JSON")
}

const GANTRY: &str = r#"
[robot]
urdf = "../robots/gantry.urdf"
task = "position"
inverse.damped-least-squares.damping = 1e-4
[start]
near = [0.8, -0.4, 0.1]
[path]
end = "2 * pi"
position.formula = { x = "0.8 + 0.3 * cos(lambda)", y = "0", z = "0.3 + 0.3 * sin(lambda)" }
[limits]
[control]
gain = 10
sampling_period = 1e-3
bandwidth = 40
target_rate = 8
[fixed_speed]
[optimum]
grid_points = 200
"#;

#[test]
fn columns_and_axes_of_a_joint_that_slides_are_in_metres_and_those_of_one_that_turns_in_radians() {
    let folder = folder(GANTRY);
    let output = slideway(folder.path(), &["compare", "scenarios/mine.toml", "--out", "out"]);
    assert!(matches!(output.status.code(), Some(0 | 1)), "{}", String::from_utf8_lossy(&output.stderr));
    let read = |file: &str| std::fs::read_to_string(folder.path().join("out").join(file)).expect("written");
    let trace = read("trace-sliding-mode.csv");
    let columns: Vec<&str> = trace.lines().next().expect("a header").split(',').collect();
    for (name, per) in [("q", ""), ("qd_desired", "_per_s"), ("qd_commanded", "_per_s")] {
        let of_joints: Vec<&str> = ["bridge", "lift", "spindle"]
            .map(|joint| {
                let begins = format!("{name}_{joint}_");
                *columns.iter().find(|column| column.starts_with(&begins)).expect("a column")
            })
            .to_vec();
        assert_eq!(of_joints, ["bridge_m", "lift_m", "spindle_rad"].map(|joint| format!("{name}_{joint}{per}")));
    }
    let limiting = columns.iter().position(|column| *column == "limiting_joint").expect("a column");
    let named = |row: &str| ["bridge", "lift", "spindle"].contains(&row.split(',').nth(limiting).expect("a field"));
    assert!(trace.lines().skip(1).any(named));
    let figure = read("figures/joint-speeds.svg");
    let is_titled = |joint: &&str| figure.lines().any(|line| line.trim() == *joint);
    assert!(["bridge", "lift", "spindle"].iter().all(is_titled));
    let axes = |unit: &str| figure.lines().filter(|line| line.trim() == unit).count();
    assert_eq!((axes("m/s"), axes("rad/s")), (2, 1));
}

#[test]
fn the_summary_and_the_robot_command_describe_a_robot_in_the_same_words() {
    let folder = folder(GANTRY);
    let printed = |arguments: &[&str]| -> Value {
        let output = slideway(folder.path(), &[arguments, &["--json"]].concat());
        serde_json::from_slice(&output.stdout).expect("valid JSON")
    };
    let robot = &printed(&["compare", "scenarios/mine.toml"])["robot"];
    assert_eq!(*robot, printed(&["robot", "robots/gantry.urdf"])["robot"]);
    let bridge = serde_json::json!({
        "name": "bridge", "kind": "prismatic", "position": [0.0, 2.0], "speed": 1.5, "acceleration": null, "torque": 500.0,
    });
    assert_eq!(
        (&robot["joints"][0], robot["base"].as_str(), robot["tip"].as_str()),
        (&bridge, Some("frame"), Some("tool"))
    );
    assert_eq!(robot["joints"][2]["position"], serde_json::json!([null, null]), "a spindle turns without end");
}

#[test]
fn a_joint_whose_name_has_a_comma_keeps_its_trace_readable_and_a_joint_outside_its_range_is_named() {
    let folder = folder(&GANTRY.replace("[limits]", "[limits]\nposition = [[0, 1], [-0.8, 0], [-1, 1]]"));
    let file = folder.path().join("robots/gantry.urdf");
    let text = std::fs::read_to_string(&file).expect("fixture");
    std::fs::write(&file, text.replace("\"bridge\"", "\"bridge, west\"")).expect("written");
    let output = slideway(folder.path(), &["compare", "scenarios/mine.toml", "--out", "out", "--json"]);
    let summary: Value = serde_json::from_slice(&output.stdout).expect("valid JSON");
    assert_eq!(summary["position_excesses"][0]["joint"], "bridge, west");
    assert!(summary["verdict"]["sentence"].as_str().expect("words").contains("joint `bridge, west` is at 1.1"));
    let mut reader = csv::Reader::from_path(folder.path().join("out/trace-ideal.csv")).expect("a file");
    let columns = reader.headers().expect("a header").clone();
    assert!(columns.iter().any(|column| column == "q_bridge, west_m"), "{columns:?}");
    assert!(reader.records().all(|row| row.is_ok_and(|row| row.len() == columns.len())));
}

#[test]
fn sliding_joints_run_with_the_speed_limits_of_their_urdf() {
    let summary = compare(GANTRY);
    assert_eq!(summary["optimum"]["certified"], true);
    // A circle of 0.3 m with at most 1.5 m/s across and 1 m/s upwards: no faster than its rise and fall at 1 m/s, 1.2 s,
    // but for what the spindle's swinging tool takes over.
    let time = summary["optimum"]["duration_s"].as_f64().expect("time");
    assert!((0.6..1.9).contains(&time), "{time}");
    let faster = compare(&GANTRY.replace("[limits]", "[limits]\nspeed = [3.0, 2.0, 8.0]"));
    let half = faster["optimum"]["duration_s"].as_f64().expect("time");
    // All limits doubled: exactly half of the time under speed limits alone.
    assert!((half / time - 0.5).abs() < 1e-3, "{half} for {time}");
}

/// The same seven-axis arm from its file and built in, both at the flange.
fn seven(robot: &str, inverse: &str) -> String {
    format!(
        r#"
[robot]
{robot}
inverse.{inverse}
[start]
near = [0.0, -0.6, 0.0, -2.2, 0.0, 1.6, 0.8]
[path]
end = 1
position.line = {{ from = [0.45, -0.15, 0.45], to = [0.45, 0.15, 0.45] }}
orientation.constant.euler = [0, "pi", 0]
[limits]
[control]
gain = 10
sampling_period = 1e-3
bandwidth = 40
target_rate = 4
[optimum]
grid_points = 100
"#
    )
}

#[test]
fn seven_joints_run_from_a_urdf_and_built_in_to_the_same_optimum() {
    let from_file = "urdf = \"../robots/seven_axis.urdf\"\ntip = \"flange\"";
    let mut times = Vec::new();
    for robot in [from_file, "model = \"panda\""] {
        for inverse in ["damped-least-squares.damping = 1e-4", "truncated-svd.cutoff = 1e-6"] {
            let summary = compare(&seven(robot, inverse));
            assert_eq!(summary["optimum"]["certified"], true, "{robot} {inverse}");
            let sliding = summary["methods"].as_array().expect("list").iter().find(|m| m["method"] == "sliding-mode");
            assert_eq!(sliding.expect("there")["completed"], true, "{robot} {inverse}");
            times.push(summary["optimum"]["duration_s"].as_f64().expect("time"));
        }
    }
    // The optimum does not depend on the controller's inverse; both descriptions agree to 1e-14.
    assert!(times.iter().all(|t| (t / times[0] - 1.0).abs() < 1e-6), "{times:?}");
}

#[test]
fn every_built_in_model_can_be_named_in_a_scenario() {
    let head = |model: &str, near: &str, path: &str, task: &str| {
        format!(
            "[robot]\nmodel = \"{model}\"\ntask = \"{task}\"\ninverse.damped-least-squares.damping = 1e-4\n[start]\nnear = {near}\n[path]\nend = 1\n{path}\n[limits]\nspeed = 1\n[control]\ngain = 10\nsampling_period = 1e-3\nbandwidth = 40\ntarget_rate = 6\n[optimum]\ngrid_points = 50\n"
        )
    };
    for (model, near, line) in [
        ("planar-2r", "[0.3, 1.2]", "{ from = [0.9, 0.9, 0], to = [0.6, 1.1, 0] }"),
        ("pa10", "[0, 0.6, 0, 1.2, 0, 0.6, 0]", "{ from = [0.6, 0, 0.6], to = [0.6, 0.2, 0.5] }"),
        ("ur5e", "[0, -1.2, 1.6, -2.0, -1.5, 0]", "{ from = [-0.4, -0.2, 0.4], to = [-0.4, 0.1, 0.4] }"),
        ("ur20", "[0, -1.2, 1.6, -2.0, -1.5, 0]", "{ from = [-0.8, -0.3, 0.7], to = [-0.8, 0.1, 0.7] }"),
        ("panda", "[0, -0.6, 0, -2.2, 0, 1.6, 0.8]", "{ from = [0.5, 0, 0.4], to = [0.5, 0.2, 0.4] }"),
    ] {
        let task = if model == "planar-2r" { "planar-position" } else { "position" };
        let summary = compare(&head(model, near, &format!("position.line = {line}"), task));
        assert_eq!(summary["optimum"]["certified"], true, "{model}");
    }
}

#[test]
fn wrong_robots_in_scenarios_exit_with_2_at_their_line_with_a_remedy() {
    for (from, to, says, remedy) in [
        ("gantry.urdf", "gone.urdf", "cannot read", "path of a URDF file"),
        ("urdf = ", "tip = \"hand\"\nurdf = ", "no link called `hand`", "`quill`"),
        ("urdf = ", "base = \"tool\"\ntip = \"frame\"\nurdf = ", "not reachable from `tool`", "another tip"),
        ("urdf = ", "model = \"panda\"\nurdf = ", "excludes", "keep one of the keys"),
        (
            "urdf = \"../robots/gantry.urdf\"",
            "model = \"pa10\"\ntip = \"tool\"",
            "name links of a `robot.urdf`",
            "keep",
        ),
        ("urdf = \"../robots/gantry.urdf\"", "model = \"puma560\"", "no speed limits of its own", "add the key"),
        ("near = [0.8, -0.4, 0.1]", "near = [0.8, -0.4]", "2 numbers given, 3 needed", "give 3 numbers"),
    ] {
        assert!(GANTRY.contains(from), "{from}");
        let folder = folder(&GANTRY.replacen(from, to, 1));
        let output = slideway(folder.path(), &["compare", "scenarios/mine.toml"]);
        let printed = String::from_utf8_lossy(&output.stderr);
        let printed: String = printed.split_whitespace().filter(|w| *w != "│").collect::<Vec<_>>().join(" ");
        assert_eq!(output.status.code(), Some(2), "{to}: {printed}");
        assert!(printed.contains(says) && printed.contains(remedy), "{to}: {printed}");
        assert!(printed.contains("mine.toml:") && !printed.contains("panicked"), "{to}: {printed}");
    }
}
