//! Wrong input: every error names the file and the line, says what is wrong and what to do, and exits with 2.

mod support;

use proptest::prelude::*;
use slideway_scenario::Scenario;
use support::slideway;

fn template() -> String {
    slideway_scenario::TEMPLATE.to_owned()
}

/// Runs the template with one line replaced; the exit status must be 2. Returns what was printed and the line's number.
fn spoil(from: &str, to: &str) -> (String, usize) {
    let text = template();
    let line = text.lines().position(|l| l == from).unwrap_or_else(|| panic!("the template has no line `{from}`"));
    let spoiled: Vec<&str> = text.lines().enumerate().map(|(i, l)| if i == line { to } else { l }).collect();
    let folder = tempfile::tempdir().expect("folder");
    std::fs::write(folder.path().join("bad.toml"), spoiled.join("\n")).expect("written");
    let output = slideway(folder.path(), &["compare", "bad.toml"]);
    // Long messages are wrapped for the terminal.
    let printed = String::from_utf8_lossy(&output.stderr).replace("\n  │ ", " ");
    assert_eq!(output.status.code(), Some(2), "{to}: {printed}");
    assert!(!printed.contains("panicked"), "{printed}");
    // A replacement of two lines puts what is wrong on the second.
    (printed, line + 1 + to.matches('\n').count())
}

/// The error points at the line and says what is expected in its message.
fn points_at_the_line(from: &str, to: &str, says: &str) {
    let (printed, line) = spoil(from, to);
    assert!(printed.contains(&format!("bad.toml:{line}:")), "no line {line} in: {printed}");
    assert!(printed.contains(says), "`{says}` not in: {printed}");
    assert!(printed.contains("help:"), "no remedy in: {printed}");
}

#[test]
fn values_that_cannot_be_meant_are_pointed_out_with_file_line_and_remedy() {
    for (from, to, says) in [
        ("speed = 0.5", "speed = 0", "not positive"),
        ("speed = 0.5", "speed = -0.5", "not positive"),
        ("speed = 0.5", "speed = nan", "not a finite number"),
        ("speed = 0.5", "speed = inf", "not a finite number"),
        ("speed = 0.5", "speed = [0.5, 0.5]", "2 numbers given, 6 needed"),
        ("speed = 0.5", "speed = [0.5, 0.5, 0.5, 0, 0.5, 0.5]", "not positive"),
        ("speed = 0.5", "speed = \"fast\"", "fast"),
        ("speed = 0.5", "speed = 0.5\nspeed_lower = 0.5", "not negative"),
        ("gain = 10", "gain = -1", "not positive"),
        ("gain = 10", "gain = 1e6", "outside"),
        ("gain = 10", "gian = 10", "unknown field"),
        ("sampling_period = 1e-3", "sampling_period = 0", "not positive"),
        ("bandwidth = 13", "bandwidth = 5000", "must not exceed 1"),
        ("target_rate = 2.6", "target_rate = 0", "not positive"),
        ("end = \"2 * pi\"", "end = -1", "does not lie after"),
        ("end = \"2 * pi\"", "end = \"2 * tau_x\"", "tau_x"),
        ("end = \"2 * pi\"", "end = 40", "leaves the robot's reach"),
        ("epsilon = 1e-5", "epsilon = 0", "must be positive"),
        ("model = \"puma560\"", "model = \"puma\"", "unknown variant"),
        ("radius = 0.1", "radius = 0", "not positive"),
        ("start = [0.58, -0.15, 0.14]", "start = [5.8, -0.15, 0.14]", "out of reach"),
        ("start = [0.58, -0.15, 0.14]", "start = [0.58, -0.15]", "length 3"),
        (
            "pose = [0.68, -0.25, 0.19, 0.2, \"pi - 0.2\", 0.1]",
            "pose = [6.8, -0.25, 0.19, 0.2, 3, 0.1]",
            "out of reach",
        ),
        ("rate = \"2 * pi / 5\"", "rate = 0", "not positive"),
        ("grid_points = 1000", "grid_points = -4", "u32"),
        ("grid_points = 1000", "grid_points = 0", "outside"),
        ("tolerance = 0.02", "tolerance = -0.02", "not positive"),
        ("[limits]", "[limit]", "unknown field"),
        ("# [disturbances]", "[disturbances]\njoint_noise = -1e-3", "outside"),
        ("# [disturbances]", "[disturbances]\njoint_noise = nan", "not a finite number"),
        ("# [disturbances]", "[disturbances]\ninitial_error = [0.1, 0.1]", "2 numbers given, 6 needed"),
        ("# [disturbances]", "[disturbances]\nspeed_error = [0, 0, 0, 0, 0, -1]", "outside"),
        ("# [disturbances]", "[disturbances]\njitter = 1", "outside"),
        ("# [disturbances]", "[disturbances]\ndelay = 0.5", "u32"),
        ("# [disturbances]", "[disturbances]\nnoise = 1", "unknown field"),
        ("# [disturbances]", "[disturbances]\njoint_offset = 0.01", "a list of numbers, one per joint"),
        ("# [verify]", "[verify]\njitter = 2", "outside"),
    ] {
        points_at_the_line(from, to, says);
    }
}

#[test]
fn what_a_remedy_offers_is_accepted_where_it_is_offered() {
    let all = "or a single one for all joints";
    for (from, to, says, says_not) in [
        ("speed = 0.5", "speed = [0.5, 0.5]", all, "give 6 numbers, one"),
        ("# [disturbances]", "[disturbances]\njoint_offset = [0, 0]", "give 6 numbers, one per joint", all),
        ("gain = 10", "gain = 2000", "greater than 0 and less than 2000", "from 0 to 2000"),
        ("end = \"2 * pi\"", "end = \"2 * pi\"\n[start]\nnear = [0, 0]", "", "single"),
    ] {
        let (printed, _) = spoil(from, to);
        let words = printed.replace("\n        ", " ");
        assert!(words.contains(says) && !words.contains(says_not), "{to}: {words}");
    }
    // An arm without a wrist, and a path that stands still: both name the file, and what they say to change is there.
    let arm = "[robot]\nmodel = \"planar-2r\"\n[path.joints.line]\nfrom = [0, 1]\nto = [0, 1]\n[limits]\nspeed = 1\n";
    let control = "[control]\ngain = 10\nsampling_period = 1e-3\nbandwidth = 50\ntarget_rate = 2\n";
    let folder = tempfile::tempdir().expect("folder");
    let line = slideway_scenario::BUILT_IN.iter().find(|b| b.name == "planar-line").expect("built in").text;
    let natural = format!("{line}\n[natural]\nfactor = \"arm\"\n");
    for (name, text, says) in [
        ("still.toml", format!("{arm}{control}"), "still.toml: no optimum: piece 1 of the joint path does not move"),
        ("wrist.toml", natural, "leave `natural.factor` out"),
    ] {
        std::fs::write(folder.path().join(name), text).expect("written");
        let output = slideway(folder.path(), &["compare", name]);
        let printed = String::from_utf8_lossy(&output.stderr).replace("\n  │ ", " ").replace("\n        ", " ");
        assert_eq!(output.status.code(), Some(2), "{printed}");
        assert!(printed.contains(says) && printed.contains(name), "{printed}");
        assert!(!printed.contains("start.branch"), "{printed}");
    }
}

#[test]
fn what_is_missing_is_named() {
    for (from, says) in [("gain = 10", "gain"), ("model = \"puma560\"", "model"), ("end = \"2 * pi\"", "end")] {
        let (printed, _) = spoil(from, "");
        assert!(printed.contains(says) && printed.contains("bad.toml:"), "{printed}");
    }
    let (printed, _) = spoil("branch = { shoulder = \"right\", elbow = \"up\", wrist = \"no-flip\" }", "");
    assert!(printed.contains("near"), "{printed}");
}

#[test]
fn missing_files_and_unknown_names_suggest_what_to_do() {
    let folder = tempfile::tempdir().expect("folder");
    for (arguments, says) in [
        (vec!["compare", "nowhere.toml"], "slideway list"),
        (vec!["compare", "puma-helx"], "puma-helix"),
        (vec!["show", "nothing"], "slideway list"),
        (vec!["compare", "."], "cannot read"),
        (vec!["compare", "puma-helix", "--tolerance", "-1"], "tolerance"),
        (vec!["compare", "puma-helix", "--tolerance", "nan"], "tolerance"),
        (vec!["compare", "puma-helix", "--out", "/dev/null/x"], "cannot write"),
        (vec!["init", "no/such/folder/x.toml"], "cannot write"),
        (vec!["compare"], "SCENARIO"),
        (vec!["dance"], "dance"),
    ] {
        let output = slideway(folder.path(), &arguments);
        let printed = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {printed}");
        assert!(printed.contains(says) && !printed.contains("panicked"), "{arguments:?}: {printed}");
    }
}

#[test]
fn a_torque_that_does_not_hold_the_arm_is_told_with_joint_place_and_what_would_do() {
    let folder = tempfile::tempdir().expect("folder");
    let lift = slideway_scenario::BUILT_IN.iter().find(|b| b.name == "ur20-lift").expect("built in").text;
    let weak = lift.replace("torque = [300, 620, 260, 50, 40, 20]", "torque = [300, 200, 260, 50, 40, 20]");
    std::fs::write(folder.path().join("weak.toml"), weak).expect("written");
    let output = slideway(folder.path(), &["compare", "weak.toml"]);
    assert_eq!(output.status.code(), Some(2));
    let words = String::from_utf8_lossy(&output.stderr).replace("\n  │", "").replace("\n       ", "");
    assert!(
        words.contains("weak.toml: no optimum: no speed profile keeps the torque limit of joint 2 at s = "),
        "{words}"
    );
    assert!(words.contains("; that joint is `joint2`"), "{words}");
    assert!(words.contains("if every such limit gave way by"), "{words}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn arbitrary_bytes_never_panic_the_scenario_reader(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let _ = Scenario::parse("fuzz", &String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn arbitrary_formulas_never_panic(text in "[a-z0-9+*/^(). -]{0,24}") {
        let _ = Scenario::parse("fuzz", &template().replace("\"2 * pi\"", &format!("{text:?}")));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn templates_with_a_wild_number_are_refused_or_run(line in 0..14_usize, value in prop::num::f64::ANY) {
        let keys = ["epsilon", "start =", "end", "radius", "climb", "speed", "gain", "sampling_period", "bandwidth", "target_rate", "rate", "tolerance", "grid_points", "euler"];
        let spoiled: String = template().lines().map(|l| if l.starts_with(keys[line]) {
            let key = l.split('=').next().unwrap_or_default();
            format!("{key}= {value:?}\n")
        } else { format!("{l}\n") }).collect();
        if let Ok(scenario) = Scenario::parse("fuzz", &spoiled.replace("NaN", "nan")) {
            let _ = scenario.experiment();
        }
    }
}
