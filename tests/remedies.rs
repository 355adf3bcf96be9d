//! Remedies are true: each is applied to the input that it was given for, and the error is gone.

mod support;

use slideway_scenario::{AnyScenario, BUILT_IN, CONDITIONING_TEMPLATE, ScenarioError, TEMPLATE};
use std::path::Path;
use support::slideway;

/// Two joints on a path of the joints.
const JOINTS: &str = "
[robot]
model = 'planar-2r'
[path.joints.spline]
points = [[0, 1], [0.5, 1.2], [1, 1]]
[limits]
speed = 1
[control]
gain = 10
sampling_period = 1e-3
bandwidth = 10
target_rate = 2
";

/// Four joints on a path of the tool.
const FOUR: &str = "
[robot]
dh = [{ a = 0, alpha = 'pi / 2', d = 0.3 }, { a = 0.4, alpha = 0, d = 0 }, { a = 0.4, alpha = 0, d = 0 }, { a = 0.2, alpha = 0, d = 0 }]
task = 'position'
inverse.damped-least-squares.damping = 0.01
[start]
near = [0, 0.8, -1.2, 0.2]
[path]
position.line = { from = [0.7, 0, 0.4], to = [0.65, 0.1, 0.45] }
[limits]
speed = 1
[control]
gain = 10
sampling_period = 1e-3
bandwidth = 10
target_rate = 2
";

/// A part of a text, what stands there instead, what is said of it and what to do, and the same done.
type Case<'a> = (&'a str, &'a str, &'a str, &'a str, &'a str);

/// Reason why a text cannot be used, short of running it.
fn refused(text: &str, folder: &Path) -> Option<ScenarioError> {
    let scenario = AnyScenario::parse("mine", text).map(|s| s.in_folder_of(&folder.join("mine.toml")));
    match scenario {
        Err(error) => Some(error),
        Ok(AnyScenario::Speed(scenario)) => match scenario.experiment() {
            Err(error) => Some(error),
            Ok(experiment) => experiment.judged_method(scenario.judged_method()).err().map(Into::into),
        },
        Ok(AnyScenario::Conditioning(scenario)) => scenario.problem().err(),
    }
}

fn remedies_hold(base: &str, cases: &[Case<'_>]) {
    let folder = tempfile::tempdir().expect("folder");
    assert!(refused(base, folder.path()).is_none(), "{:?}", refused(base, folder.path()));
    for (part, spoilt, says, remedy, mended) in cases {
        assert_eq!(base.matches(part).count(), 1, "`{part}`");
        let error = refused(&base.replace(part, spoilt), folder.path()).unwrap_or_else(|| panic!("{spoilt}: accepted"));
        let (said, told) = (error.to_string(), error.remedy());
        assert!(said.contains(says), "{spoilt}: `{says}` is not in: {said}");
        assert!(told.contains(remedy), "{spoilt}: `{remedy}` is not in: {told} (of: {said})");
        let left = refused(&base.replace(part, mended), folder.path());
        assert!(left.is_none(), "{spoilt}: {told}: {mended}: {left:?}");
    }
}

#[test]
fn remedies_for_values_and_keys_of_a_speed_scenario_remove_the_error() {
    let cases: [Case<'_>; 20] = [
        ("\ngain = 10", "\ngain = nan", "`control.gain`: NaN is not a finite number", "greater than", "\ngain = 10"),
        ("\ngain = 10", "\ngian = 10", "unknown field `gian`", "did you mean `gain`", "\ngain = 10"),
        ("\ngain = 10", "", "missing field `gain`", "`gain = 10`", "\ngain = 10"),
        // The template's methods at a fixed speed have a longer period, which is told next if the gain is too high for that alone.
        ("\ngain = 10", "\ngain = 2000", "outside (0, 2000)", "greater than 0 and less than 2000", "\ngain = 799"),
        (
            "\nspeed = 0.5",
            "\nspeed = inf",
            "`limits.speed`: inf is not a finite number",
            "greater than zero",
            "\nspeed = 1e-3",
        ),
        (
            "\nspeed = 0.5",
            "\nspeed = [1, 2]",
            "2 numbers given, 6 needed",
            "a single one for all joints",
            "\nspeed = 2",
        ),
        ("\nspeed = 0.5", "\nspeed = '0.5 - lambda'", "must be positive", "keeps its sign", "\nspeed = '7 - lambda'"),
        ("\nspeed = 0.5", "\nspeed = '0.5 * w'", "which means nothing here", "`pi`", "\nspeed = '0.5 * pi'"),
        (
            "\nepsilon = 1e-5",
            "\nepsilon = nan",
            "`robot.inverse.adjugate.epsilon`",
            "greater than zero",
            "\nepsilon = 1e-6",
        ),
        ("\nend = \"2 * pi\"", "\nend = nan", "`path.end`", "from small to large", "\nend = 0.1"),
        ("model = \"puma560\"", "model = \"puma\"", "unknown variant `puma`", "`puma560`", "model = \"puma560\""),
        ("start = [0.58, -0.15, 0.14]", "start = [0.58, -0.15]", "length 2", "length 3", "start = [0.58, -0.15, 0.14]"),
        ("grid_points = 1000", "grid_points = -4", "-4", "a whole number that is not negative", "grid_points = 100"),
        ("grid_points = 1000", "grid_points = 1", "outside [10, 100000]", "from 10 to 100000", "grid_points = 10"),
        (
            "\nbandwidth = 13",
            "\nbandwidth = 5000",
            "must not exceed 1",
            "until their product is at most 1",
            "\nbandwidth = 1000",
        ),
        ("# [disturbances]", "[disturbances]\njitter = 1", "outside", "from 0 to", "[disturbances]\njitter = 0"),
        ("# [disturbances]", "[disturbances]\ndelay = 0.5", "0.5", "a whole number", "[disturbances]\ndelay = 1"),
        (
            "# [disturbances]",
            "[disturbances]\njoint_noise = -1e-3",
            "outside",
            "from 0 to",
            "[disturbances]\njoint_noise = 1e-3",
        ),
        ("\n[limits]", "\n[limit]", "unknown field `limit`", "did you mean `limits`", "\n[limits]"),
        (
            "\n[compare]",
            "\n[compare]\nmethod = 'slidng-mode'",
            "unknown variant",
            "did you mean `sliding-mode`",
            "\n[compare]\nmethod = 'sliding-mode'",
        ),
    ];
    remedies_hold(TEMPLATE, &cases);
}

#[test]
fn remedies_for_paths_of_the_joints_remove_the_error() {
    let spline = "[path.joints.spline]\npoints = [[0, 1], [0.5, 1.2], [1, 1]]";
    let cases: [Case<'_>; 9] = [
        (
            spline,
            "[path.joints.lines]\npoints = [[0, 1], [0.5, 1.2], [1, 1]]",
            "missing field `blend`",
            "`blend = 0.2`",
            "[path.joints.lines]\nblend = 0.2\npoints = [[0, 1], [0.5, 1.2], [1, 1]]",
        ),
        (
            "points = [[0, 1], [0.5, 1.2], [1, 1]]",
            "spacing = 'uniform'\npoints = [[0, 1], [0, 1], [1, 1]]",
            "are the same",
            "remove one of the two",
            "spacing = 'uniform'\npoints = [[0, 1], [1, 1]]",
        ),
        ("[0.5, 1.2]", "[0.5, nan]", "`path.joints.spline.points.1.1`: NaN", "give a finite number", "[0.5, 1]"),
        (
            "model = 'planar-2r'",
            "model = 'planar-2r'\nlocked = { joint9 = 0 }",
            "no joint called `joint9`",
            "the joints are joint1, joint2",
            "model = 'planar-2r'",
        ),
        ("model = 'planar-2r'", "", "say which robot", "add", "model = 'planar-2r'"),
        (
            "model = 'planar-2r'",
            "model = 'planar-2r'\ndh = [{ a = 1, alpha = 0, d = 0 }]",
            "exclude each other",
            "keep one",
            "model = 'planar-2r'",
        ),
        (
            "\nspeed = 1",
            "\nspeed = 1\nstart_rate = 5",
            "above `control.target_rate`, 2",
            "from 0 to 2",
            "\nspeed = 1\nstart_rate = 2",
        ),
        ("\nspeed = 1", "\nspeed = 1\nstart_rate = -1", "below 0", "at least 0", "\nspeed = 1\nstart_rate = 0"),
        (
            "\nspeed = 1",
            "\nspeed = 1\nposition = [[1, 0], [0, 2]]",
            "does not lie after",
            "from small to large",
            "\nspeed = 1\nposition = [[0, 1], [0, 2]]",
        ),
    ];
    remedies_hold(JOINTS, &cases);
}

#[test]
fn remedies_for_tasks_and_poses_remove_the_error() {
    let cases: [Case<'_>; 2] = [
        ("task = 'position'", "task = 'pose'", "6 coordinates and the arm 4 joints", "`position`", "task = 'position'"),
        (
            "task = 'position'",
            "",
            "6 coordinates and the arm 4 joints",
            "`planar-position`",
            "task = 'planar-position'",
        ),
    ];
    remedies_hold(FOUR, &cases);
    let poses = BUILT_IN.iter().find(|b| b.name == "ur5e-poses").expect("built in").text;
    let dwell = "[-0.45, -0.20, 0.25, 0.0, \"pi\", 0.0],\n    [-0.45, -0.20, 0.25, 0.1, \"pi\", 0.0],";
    let cases: [Case<'_>; 1] = [(
        "[path.poses]\npoints = [\n    [-0.45, -0.20, 0.25, 0.0, \"pi\", 0.0],",
        &format!("[path.poses]\npoints = [\n    {dwell}"),
        "in the same place",
        "`spacing = \"uniform\"`",
        &format!("[path.poses]\nspacing = \"uniform\"\npoints = [\n    {dwell}"),
    )];
    remedies_hold(poses, &cases);
}

#[test]
fn remedies_for_a_conditioning_scenario_remove_the_error() {
    let second = CONDITIONING_TEMPLATE.lines().filter(|l| l.starts_with("name = ")).nth(1).expect("two constraints");
    let first = CONDITIONING_TEMPLATE.lines().find(|l| l.starts_with("name = ")).expect("a constraint");
    let other = "name = \"another\"";
    let formula = "shape.formula = \"0.05 - sqrt(x^2 + y^2 + z^2)\"";
    let cases: [Case<'_>; 9] = [
        (second, first, "stands twice", "a name of its own", other),
        (second, "name = \"\"", "is empty", "a name of its own", other),
        (
            "\npush_cutoff = 20",
            "\npush_cutoff = nan",
            "`conditioner.push_cutoff`",
            "greater than zero",
            "\npush_cutoff = 20",
        ),
        (
            "\npush_cutoff = 20",
            "\npush_cutof = 20",
            "unknown field",
            "did you mean `push_cutoff`",
            "\npush_cutoff = 20",
        ),
        (
            "\nmargin = \"none\"",
            "\nmargin.fixed = [0.001]",
            "2 needed",
            "one per constraint",
            "\nmargin.fixed = [0.001, 0.001]",
        ),
        (formula, "shape.formula = \"0.05 - w\"", "means nothing here", "x, y, z", "shape.formula = \"0.05 - x\""),
        (
            formula,
            "shape.formula = \"0.05 - (x\"",
            "cannot read",
            "close every parenthesis",
            "shape.formula = \"0.05 - (x)\"",
        ),
        ("\nrate = \"2 * pi / 5\"", "\nrate = 0", "not positive", "greater than zero", "\nrate = 1"),
        ("\nend = \"2 * pi\"", "\nend = -1", "does not lie after", "small to large", "\nend = 1"),
    ];
    remedies_hold(CONDITIONING_TEMPLATE, &cases);
}

#[test]
fn remedies_for_files_of_way_points_remove_the_error() {
    let folder = tempfile::tempdir().expect("folder");
    let text = JOINTS.replace("points = [[0, 1], [0.5, 1.2], [1, 1]]", "csv = 'points.csv'");
    let right = "0,1\n0.5,1.2\n1,1\n";
    let utf16: Vec<u8> = [0xff, 0xfe].into_iter().chain(right.bytes().flat_map(|b| [b, 0])).collect();
    let broken: [(Vec<u8>, &str, &str); 6] = [
        (right.replace(',', ";").into_bytes(), "separated by semicolons", "commas"),
        (b"0,0;1,0\n0,5;1,2\n1,0;1,0\n".to_vec(), "separated by semicolons", "decimal point"),
        (right.replace(',', "\t").into_bytes(), "separated by tabs", "commas"),
        (right.replace(',', "  ").into_bytes(), "separated by blanks", "commas"),
        (utf16, "UTF-16", "save the file as UTF-8"),
        (b"0,1\n0.5,1.2\n1\n".to_vec(), "line 3: 1 numbers given, 2 needed", "as many numbers"),
    ];
    for (bytes, says, remedy) in broken {
        std::fs::write(folder.path().join("points.csv"), bytes).expect("written");
        let error = refused(&text, folder.path()).expect("refused");
        let (said, told) = (error.to_string(), error.remedy());
        assert!(said.contains(says) && told.contains(remedy), "{said}: {told}");
    }
    std::fs::write(folder.path().join("points.csv"), right).expect("written");
    assert!(refused(&text, folder.path()).is_none());
}

/// Text that the command prints of a failure, its lines joined.
fn printed(folder: &Path, arguments: &[&str]) -> String {
    let output = slideway(folder, arguments);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    text.split_whitespace().filter(|word| *word != "│").collect::<Vec<_>>().join(" ")
}

#[test]
fn remedies_of_the_command_remove_the_error() {
    let folder = tempfile::tempdir().expect("folder");
    std::fs::write(folder.path().join("mine.toml"), JOINTS).expect("written");
    let utf16: Vec<u8> = [0xff, 0xfe].into_iter().chain(JOINTS.bytes().flat_map(|b| [b, 0])).collect();
    std::fs::write(folder.path().join("utf16.toml"), utf16).expect("written");
    let marked = [b"\xef\xbb\xbf".as_slice(), JOINTS.as_bytes()].concat();
    std::fs::write(folder.path().join("marked.toml"), marked).expect("written");
    let said = printed(folder.path(), &["compare", "utf16.toml"]);
    assert!(said.contains("is UTF-16, not UTF-8") && said.contains("save the file as UTF-8"), "{said}");
    assert_ne!(slideway(folder.path(), &["compare", "marked.toml"]).status.code(), Some(2));
    let said = printed(folder.path(), &["sweep", "mine.toml", "--set", "limits=3"]);
    assert!(
        said.contains("expected a table") && said.contains("set one of the keys in it, for example `limits."),
        "{said}"
    );
    let set = ["sweep", "mine.toml", "--set", "limits.speed=3"];
    assert_ne!(slideway(folder.path(), &set).status.code(), Some(2));
}

#[test]
fn an_unknown_link_is_answered_with_the_nearest_ones_however_many_there_are() {
    let folder = tempfile::tempdir().expect("folder");
    let mut text = String::from("<robot name=\"long\">\n<link name=\"a00\"/>\n");
    for i in 1..=40 {
        let (parent, child) = (format!("a{:02}", i - 1), if i == 40 { "tool0".into() } else { format!("a{i:02}") });
        let kind = if i <= 3 { "revolute" } else { "fixed" };
        text += &format!(
            "<link name=\"{child}\"/>\n<joint name=\"j{i}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"{child}\"/>\
             <origin xyz=\"0.1 0 0\"/><axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\" velocity=\"1\" effort=\"1\"/></joint>\n"
        );
    }
    std::fs::write(folder.path().join("long.urdf"), text + "</robot>\n").expect("written");
    let said = printed(folder.path(), &["robot", "long.urdf", "--tip", "tol0", "--q", "0,0,0"]);
    assert!(said.contains("the links are `tool0`"), "{said}");
    let mended = slideway(folder.path(), &["robot", "long.urdf", "--tip", "tool0", "--q", "0,0,0"]);
    assert_eq!(mended.status.code(), Some(0), "{}", String::from_utf8_lossy(&mended.stderr));
}
