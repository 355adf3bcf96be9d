//! Every kind of path runs from its scenario to the sampled joint path; what is wrong with way-points is pointed at.

use slideway_lab::{Experiment, Method};
use slideway_path::SampledPath;
use slideway_scenario::{Scenario, locate};
use std::path::Path;
use std::process::Command;

/// A PUMA-560 whose tool is to follow a path.
fn tool(path: &str) -> String {
    format!(
        r#"
[robot]
model = "puma560"
inverse.adjugate.epsilon = 1e-5
[start]
branch = {{ shoulder = "right", elbow = "up", wrist = "no-flip" }}
{path}
[limits]
speed = 0.5
[control]
gain = 10
sampling_period = 1e-3
bandwidth = 5
target_rate = 5
"#
    )
}

/// A PUMA-560 whose joints are to follow a path.
fn joints(path: &str) -> String {
    let text = tool(path);
    let start = text.find("[start]").expect("there");
    let end = text.find("[path").expect("there");
    format!("{}{}", &text[..start], &text[end..])
}

fn experiment(text: &str) -> Experiment {
    let scenario = Scenario::parse("test", text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    scenario.experiment().unwrap_or_else(|error| panic!("{error}\n{text}"))
}

const DOWN: &str = "[path.orientation]\nconstant.euler = [0, \"pi\", 0]";
const POINTS: &str =
    "points = [[0.58, -0.15, 0.14], [0.55, 0, 0.1], [0.5, 0.1, 0.16], [0.52, 0.2, 0.1]]\nspacing = \"uniform\"";

/// Tool paths of every kind that this file is about.
fn tool_paths() -> Vec<String> {
    let arc =
        format!("[path.position.arc]\nfrom = [0.58, -0.15, 0.14]\nvia = [0.5, 0, 0.2]\nto = [0.5, 0.15, 0.1]\n{DOWN}");
    let spline = |ends: &str| format!("[path.position.spline]\n{POINTS}\nends = {ends}\n{DOWN}");
    let line = "[path.position.line]\nfrom = [0.58, -0.15, 0.14]\nto = [0.5, 0.15, 0.1]";
    vec![
        arc,
        spline("\"natural\""),
        spline("\"not-a-knot\""),
        spline("{ clamped = { start = [0, 0.3, 0], end = [0, \"0.1 + 0.2\", 0.1] } }"),
        format!("[path.position.lines]\n{POINTS}\nblend = 0.3\n{DOWN}"),
        format!("[path.position.lines]\n{POINTS}\nblend = 0\n{DOWN}"),
        format!(
            "{line}\n[path.orientation.slerp]\nfrom = {{ euler = [0, \"pi\", 0] }}\nto = {{ quaternion = [0.0998334, 0, 0.9950042, 0] }}"
        ),
        format!(
            "{line}\n[path.orientation.squad]\nat = [0, 0.3, 1]\nrotations = [{{ euler = [0, \"pi\", 0] }}, {{ euler = [0.3, 2.9, 0] }}, {{ euler = [0, 2.8, 0.2] }}]"
        ),
        "[path.poses]\npoints = [[0.58, -0.15, 0.14, 0, \"pi\", 0], [0.55, 0, 0.1, 0.2, 3, 0], [0.5, 0.1, 0.1, 0, 3, 0.2]]".into(),
        "[path.poses]\nposition.lines.blend = 0.25\norientation = \"slerp\"\npoints = [[0.58, -0.15, 0.14, 0, 0, 1, 0], [0.55, 0, 0.1, 0, 0, 0.8, 0.6], [0.5, 0.1, 0.1, 0, 0, 1, 0]]".into(),
    ]
}

const CONFIGURATIONS: &str = "points = [[0, 0.8, -2.6, 3, 1, 2.8], [0.4, 0.6, -2.2, 2, 1, 2.6], [0.2, 0.1, -2.4, 2.5, 0.7, 2], [0, 0.1, -2, 3, 0.4, 1]]";

fn joint_paths() -> Vec<String> {
    let clamped = "{ clamped = { start = [0, 0, 0, 0, 0, 0], end = [1, 0, 0, 0, 0, 0] } }";
    let spline = |ends: &str| format!("[path.joints.spline]\n{CONFIGURATIONS}\nends = {ends}");
    vec![
        spline("\"natural\""),
        spline("\"not-a-knot\""),
        spline(clamped),
        format!("[path.joints.lines]\n{CONFIGURATIONS}\nblend = 0.5\nat = [2, 3, 3.5, 5]"),
        format!("[path.joints.lines]\n{CONFIGURATIONS}\nblend = 0"),
    ]
}

/// `|q'(s1) - q'(s0) - h (q''(s0) + q''(s1)) / 2|` is at most `h` times the variation of `q''` over the interval. The nodes
/// give that of a monotone `q''`; the neighbouring intervals are added for a kink of `q''` inside, and a part in ten thousand
/// of its size for its extrema. An error in `q''` itself does not shrink with the interval.
fn check_derivatives(path: &SampledPath, what: &str) {
    for piece in &path.pieces {
        let largest = piece.nodes.iter().flat_map(|n| &n.second).fold(1.0_f64, |m, x| m.max(x.abs()));
        for nodes in piece.nodes.windows(4) {
            let h = nodes[2].s - nodes[1].s;
            for joint in 0..path.joints {
                let second = |i: usize| nodes[i].second[joint];
                let change = nodes[2].first[joint] - nodes[1].first[joint];
                let error = (change - 0.5 * h * (second(1) + second(2))).abs();
                let variation: f64 = (0..3).map(|i| (second(i + 1) - second(i)).abs()).sum();
                assert!(error <= h * (variation + 1e-4 * largest), "joint {joint} at {}: {error} {what}", nodes[1].s);
            }
        }
    }
}

#[test]
fn every_kind_of_path_is_sampled_with_derivatives_that_agree_with_differences() {
    for text in tool_paths().iter().map(|p| tool(p)).chain(joint_paths().iter().map(|p| joints(p))) {
        let path = experiment(&text).sample(2000, 0).unwrap_or_else(|error| panic!("{error}\n{text}"));
        check_derivatives(&path, &text);
    }
}

#[test]
fn the_sliding_mode_follows_poses_and_configurations_to_their_end() {
    for text in [tool(&tool_paths()[8]), joints(&joint_paths()[1])] {
        let trace = experiment(&text).run(Method::SlidingModeImplicit).expect("runs");
        assert!(trace.finish_s.is_some(), "{text}");
    }
}

#[test]
fn corners_end_a_piece_and_nothing_else_does() {
    for text in tool_paths().iter().map(|p| tool(p)).chain(joint_paths().iter().map(|p| joints(p))) {
        let corners = if text.contains("blend = 0\n") { 2 } else { usize::from(text.contains("\"slerp\"")) };
        let path = experiment(&text).sample(200, 0).expect("sampled");
        assert_eq!(path.pieces.len(), corners + 1, "{text}");
    }
}

#[test]
fn splines_pass_through_their_way_points_and_joint_paths_end_where_they_say() {
    let path = experiment(&tool(&tool_paths()[2])).tool_path(4);
    let expected = [[0.58, -0.15, 0.14], [0.55, 0.0, 0.1], [0.5, 0.1, 0.16], [0.52, 0.2, 0.1]];
    for (found, expected) in path.iter().zip(expected) {
        // The reference itself: rounding only.
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?} {expected:?}");
    }
    for text in joint_paths() {
        let path = experiment(&joints(&text)).sample(2000, 0).expect("sampled");
        let mut travelled = [0.0; 6];
        for pair in path.pieces.iter().flat_map(|p| p.nodes.windows(2)) {
            let h = pair[1].s - pair[0].s;
            for (j, sum) in travelled.iter_mut().enumerate() {
                // Trapezoidal rule with the correction by the second derivative: of fourth order.
                *sum += 0.5 * h * (pair[0].first[j] + pair[1].first[j])
                    + h * h / 12.0 * (pair[0].second[j] - pair[1].second[j]);
            }
        }
        // A jump of q'' up to 100 inside one interval of 1/2000 costs at most 100 h³ a time.
        let expected = [0.0, -0.7, 0.6, 0.0, -0.6, -1.8];
        assert!(travelled.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6), "{travelled:?}");
    }
}

#[test]
fn the_range_is_that_of_the_listed_parameters_unless_given() {
    let ends = |text: &str| {
        let path = experiment(&joints(text)).sample(50, 0).expect("sampled");
        let (first, last) = (path.pieces.first().expect("one"), path.pieces.last().expect("one"));
        (first.nodes[0].lambda, last.nodes[last.nodes.len() - 1].lambda)
    };
    let near = |found: (f64, f64), expected: (f64, f64)| {
        // Ends are taken a billionth of the path inside.
        assert!((found.0 - expected.0).abs() < 1e-8 && (found.1 - expected.1).abs() < 1e-8, "{found:?}");
    };
    let spline = format!("[path.joints.spline]\n{CONFIGURATIONS}");
    near(ends(&spline), (0.0, 1.0));
    near(ends(&format!("{spline}\nat = [2, 3, 3.5, 5]")), (2.0, 5.0));
    near(ends(&format!("[path]\nend = \"2 * pi\"\n{spline}")), (0.0, std::f64::consts::TAU));
    near(ends(&format!("[path]\nstart = 2.5\n{spline}\nat = [2, 3, 3.5, 5]")), (2.5, 5.0));
}

/// The key of the error, and the text of the scenario that it points at.
fn refused(text: &str) -> (String, String, String) {
    let scenario = Scenario::parse("test", text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let error = scenario.experiment().err().unwrap_or_else(|| panic!("accepted\n{text}"));
    let span = locate(text, &error).unwrap_or_else(|| panic!("{error} points nowhere"));
    let key = error.key().unwrap_or_else(|| panic!("{error}")).to_owned();
    assert!(!error.remedy().is_empty());
    (key, error.to_string(), text[span].to_owned())
}

#[test]
fn what_is_wrong_with_way_points_is_pointed_at() {
    let lines = |points: &str, more: &str| joints(&format!("[path.joints.lines]\npoints = {points}\n{more}"));
    let position = |more: &str| tool(&format!("[path.position.{more}\n{DOWN}"));
    let poses = |points: &str, more: &str| tool(&format!("[path.poses]\npoints = {points}\n{more}"));
    let turn = |more: &str| {
        tool(&format!(
            "[path.position.line]\nfrom = [0.58, -0.15, 0.14]\nto = [0.5, 0.15, 0.1]\n[path.orientation.{more}"
        ))
    };
    let (zero, one) = ("[0, 0, 0, 0, 0, 0]", "[1, 1, 1, 1, 1, 1]");
    for (text, key, says, at) in [
        (lines(&format!("[{zero}, {one}, {one}]"), "blend = 0"), "path.joints.lines.points.2", "the same", one),
        (lines(&format!("[{zero}]"), "blend = 0"), "path.joints.lines.points", "at least two", "[["),
        (lines("[[0, 0], [1, 1]]", "blend = 0"), "path.joints.lines.points.0", "2 numbers given, 6 needed", "[0, 0]"),
        (lines(&format!("[{zero}, {one}]"), "blend = 0.6"), "path.joints.lines.blend", "outside [0, 0.5]", "0.6"),
        (
            lines(&format!("[{zero}, {one}]"), "blend = 0\nat = [0, 0]"),
            "path.joints.lines.at",
            "not lie after",
            "[0, 0]",
        ),
        (
            lines(&format!("[{zero}, {one}, {zero}]"), "blend = 0\nat = [0, 2, 1]"),
            "path.joints.lines.at.2",
            "does not lie after 2",
            "1",
        ),
        (
            lines(&format!("[{zero}, {one}]"), "blend = 0\nat = [0, 1, 2]"),
            "path.joints.lines.at",
            "3 path para",
            "[0, 1",
        ),
        (
            lines(&format!("[{zero}, {one}]"), "blend = 0\nat = [0, 1]\nspacing = \"chord\""),
            "path.joints.lines.spacing",
            "exclude",
            "\"chord\"",
        ),
        (
            joints(&format!("[path]\nend = 3\n[path.joints.spline]\npoints = [{zero}, {one}]\nat = [0, 1]")),
            "path.joints.spline.at",
            "runs from 0 to 1, the path from 0 to 3",
            "[0, 1]",
        ),
        (
            joints(&format!(
                "[path.joints.spline]\npoints = [{zero}, {one}]\nends = {{ clamped = {{ start = [0], end = [0] }} }}"
            )),
            "path.joints.spline.ends.clamped.start",
            "1 numbers given",
            "[0]",
        ),
        (joints("[path.joints.spline]\nends = \"natural\""), "path.joints.spline", "way-points", "["),
        (
            position("spline]\npoints = [[0, 0, 0], [0, 0, 0]]"),
            "path.position.spline.points.1",
            "no length",
            "[0, 0, 0]",
        ),
        (position("spline]\npoints = [[0, 0, 0], [0, 0]]"), "path.position.spline.points.1", "3 needed", "[0, 0]"),
        (
            position("arc]\nfrom = [0, 0, 0]\nvia = [1, 1, 1]\nto = [2, 2, 2]"),
            "path.position.arc.via",
            "no circle",
            "[1, 1, 1]",
        ),
        (poses("[[0.5, 0, 0, 0, 0], [1, 0, 0, 0, 0]]", ""), "path.poses.points.0", "5 numbers given, 6 or 7", "[0.5"),
        (
            poses("[[0.5, 0, 0, 0, 0, 0], [0.6, 0, 0, \"pi\", 0, 0]]", ""),
            "path.poses.points.1",
            "rotations 0 and 1 (counted from 0) are 180.000 degrees apart",
            "[0.6",
        ),
        (
            poses("[[0.5, 0, 0, 0, 0, 0], [0.5, 0, 0, 0, 0, 0]]", "spacing = \"uniform\""),
            "path.poses.points.1",
            "the same",
            "[0.5",
        ),
        (
            poses("[[0.5, 0, 0, 0, 0, 0], [0.6, 0, 0, 1, 0, 0]]", "position.lines.blend = -1"),
            "path.poses.position.lines.blend",
            "outside [0, 0.5]",
            "-1",
        ),
        (poses("[[0.5, 0, 0, 0, 0, 0], [0.5, 0, 0, 1, 0, 0]]", ""), "path.poses.points.1", "in the same place", "[0.5"),
        (poses("[[0.5, 0, 0, 1, 1, 0, 0], [0.5, 0, 0, 1, 0, 0, 0]]", ""), "path.poses.points.0", "length 1.41", "[0.5"),
        (
            turn("slerp]\nfrom = { euler = [0, 0, 0] }\nto = { quaternion = [0, 1, 0, 0] }"),
            "path.orientation.slerp.to",
            "180.000 degrees",
            "{ quaternion",
        ),
        (
            turn("slerp]\nfrom = { quaternion = [1, 1, 0, 0] }\nto = { euler = [0, 0, 0] }"),
            "path.orientation.slerp.from",
            "length 1.41",
            "{ quaternion",
        ),
        (
            turn("squad]\nrotations = [{ euler = [0, 0, 0] }, { euler = [0, 1, 0] }, { euler = [0, \"1 + pi\", 0] }]"),
            "path.orientation.squad.rotations.2",
            "rotations 1 and 2",
            "{ euler = [0, \"1 + pi\"",
        ),
        (
            turn("squad]\nat = [0, 0.5]\nrotations = [{ euler = [0, 0, 0] }, { euler = [0, 0, 3] }]"),
            "path.orientation.squad.at",
            "runs from 0 to 0.5",
            "[0, 0.5]",
        ),
        (
            tool("[path.position.helix]\nstart = [0.58, -0.15, 0.14]\nradius = 0.1\nclimb = 0"),
            "path.end",
            "how far",
            "",
        ),
    ] {
        let (found, message, place) = refused(&text);
        assert_eq!(found, key, "{message}");
        assert!(message.contains(says), "`{says}` not in `{message}`");
        assert!(place.starts_with(at), "points at `{place}`, not at `{at}`");
    }
}

#[test]
fn a_path_of_the_tool_given_twice_is_refused() {
    let poses = "[path.poses]\npoints = [[0.5, 0, 0, 0, 0, 0], [0.6, 0, 0, 0, 0, 0]]\n";
    let (key, ..) = refused(&tool(&format!("{poses}{DOWN}")));
    assert_eq!(key, "path.orientation");
    let (key, ..) = refused(&joints(&format!("{poses}[path.joints.spline]\n{CONFIGURATIONS}")));
    assert_eq!(key, "path.poses");
}

/// Runs `slideway compare` on a scenario with a CSV file in a folder beside it.
fn compare(scenario: &str, csv: &str) -> (Option<i32>, String) {
    let folder = tempfile::tempdir().expect("folder");
    std::fs::create_dir(folder.path().join("mine")).expect("created");
    std::fs::write(folder.path().join("mine/path.toml"), scenario).expect("written");
    std::fs::write(folder.path().join("mine/points.csv"), csv).expect("written");
    let output = Command::new(env!("CARGO_BIN_EXE_slideway"))
        .args(["compare", "mine/path.toml", "--json"])
        .current_dir(folder.path())
        .output()
        .expect("runs");
    // Long messages are wrapped for the terminal.
    (output.status.code(), String::from_utf8_lossy(&output.stderr).replace("\n  │ ", " "))
}

#[test]
fn a_csv_file_is_read_beside_the_scenario_and_its_errors_name_file_and_line() {
    let scenario = joints("[path.joints.spline]\ncsv = \"points.csv\"") + "[optimum]\ngrid_points = 100\n";
    let good = "q1,q2,q3,q4,q5,q6\n0,0.8,-2.6,3,1,2.8\n# half way\n0.4,0.6,-2.2,2,1,2.6\n0,0.1,-2,3,0.4,1\n";
    let (status, printed) = compare(&scenario, good);
    assert!(matches!(status, Some(0 | 1)), "{printed}");
    for (csv, says) in [
        (good.replace("0.6,", "0.6x,"), "line 4, column 2: `0.6x`"),
        (good.replace("0.6,", ""), "line 4: 5 numbers given, 6 needed"),
        (good.replace("0.4,0.6,-2.2,2,1,2.6", "0,0.8,-2.6,3,1,2.8"), "line 4: way-points 0 and 1"),
        (String::new(), "at least two"),
    ] {
        let (status, printed) = compare(&scenario, &csv);
        assert_eq!(status, Some(2), "{printed}");
        let file = Path::new("mine").join("points.csv");
        assert!(printed.contains(&*file.to_string_lossy()) && printed.contains(says), "`{says}` not in {printed}");
        assert!(printed.contains("path.toml:") && printed.contains("help:"), "{printed}");
    }
    let (status, printed) = compare(&scenario.replace("points.csv", "missing.csv"), good);
    assert_eq!(status, Some(2));
    assert!(printed.contains("missing.csv: cannot be read"), "{printed}");
}
