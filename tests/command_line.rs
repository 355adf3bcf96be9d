//! The `slideway` command as a newcomer uses it, in an empty folder.

mod support;

use slideway_scenario::{ConditioningScenario, Scenario};
use support::{json, slideway, stdout};

#[test]
fn compare_writes_everything_it_promises_and_the_verdict_holds() {
    let folder = tempfile::tempdir().expect("folder");
    let output = slideway(folder.path(), &["compare", "puma-helix"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(stdout(&output).contains("Yes: the sliding mode"));
    let out = folder.path().join("out/puma-helix");
    let summary = json(&std::fs::read_to_string(out.join("summary.json")).expect("summary"));
    let methods: Vec<&str> =
        summary["methods"].as_array().expect("list").iter().map(|m| m["method"].as_str().expect("name")).collect();
    let expected = [
        "ideal",
        "saturated",
        "direction-preserving",
        "sliding-mode",
        "sliding-mode-synchronised",
        "sliding-mode-implicit",
    ];
    assert_eq!(methods, expected);
    for method in expected {
        let trace = std::fs::read_to_string(out.join(format!("trace-{method}.csv"))).expect("trace");
        let width = trace.lines().next().expect("header").split(',').count();
        assert!(trace.lines().count() > 1000 && trace.lines().all(|l| l.split(',').count() == width));
    }
    let motion = std::fs::read_to_string(out.join("optimum.csv")).expect("the optimum's motion");
    let header: Vec<&str> = motion.lines().next().expect("header").split(',').collect();
    assert_eq!(header[..3], ["t_s", "lambda", "lambda_rate_per_s"]);
    assert_eq!(header[header.len() - 2..], ["limit", "limit_use"]);
    // 4.2412 s at 1 kHz, both ends included.
    assert_eq!(motion.lines().count(), 1 + 4243);
    assert!(motion.lines().all(|line| line.split(',').count() == header.len()));
    let figures: Vec<_> = std::fs::read_dir(out.join("figures")).expect("figures").collect();
    assert!(figures.len() >= 12, "each figure as SVG and as PNG");
    let report = std::fs::read_to_string(out.join("report.html")).expect("report");
    for link in ["src=\"http", "href=\"http", "url(http", "<script"] {
        assert!(!report.contains(link), "the report must open without a network: {link}");
    }
}

#[test]
fn json_on_standard_output_is_the_summary_with_its_documented_keys() {
    let folder = tempfile::tempdir().expect("folder");
    let output = slideway(folder.path(), &["compare", "puma-helix-on-path", "--json", "--out", "here"]);
    assert_eq!(output.status.code(), Some(0));
    let summary = json(&stdout(&output));
    assert_eq!(summary, json(&std::fs::read_to_string(folder.path().join("here/summary.json")).expect("summary")));
    assert_eq!(summary["scenario"], "puma-helix-on-path");
    for key in ["duration_s", "lower_s", "upper_s", "gap", "certified", "cells", "stop", "solver", "solve_s"] {
        assert!(!summary["optimum"][key].is_null(), "optimum.{key}");
    }
    for key in ["duration_s", "lower_s", "upper_s", "grid_points", "status", "solve_s"] {
        assert!(!summary["optimum"]["on_grid"][key].is_null(), "optimum.on_grid.{key}");
    }
    assert_eq!(summary["optimum"]["certified_for"], "spline");
    assert_eq!(summary["optimum"]["duration_s"], summary["optimum"]["upper_s"]);
    assert_eq!(summary["verdict"]["status"], "holds");
    for key in ["ratio", "ratio_lower", "ratio_upper", "tolerance", "holds"] {
        assert!(!summary["verdict"][key].is_null(), "verdict.{key}");
    }
    let sliding = &summary["methods"][3];
    for key in [
        "completed",
        "duration_s",
        "motion_start_s",
        "robot_arrival_s",
        "rms_error",
        "rms_error_norm",
        "peak_error",
        "limit_ratio_peak",
    ] {
        assert!(!sliding[key].is_null(), "{key}");
    }
    let chattering = &sliding["chattering"];
    assert!(chattering["measured"].as_f64() <= chattering["bound"].as_f64());
    assert!(chattering["paper_estimate"].is_f64());
    // The proven band contains what was measured.
    assert!(sliding["limit_ratio_peak"].as_f64() <= summary["limit_ratio_bound"].as_f64());
}

#[test]
fn a_verdict_that_does_not_hold_exits_with_1() {
    let folder = tempfile::tempdir().expect("folder");
    let output = slideway(folder.path(), &["compare", "puma-helix", "--tolerance", "1e-4"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(stdout(&output).contains("No: the sliding mode needs"));
}

#[test]
fn every_built_in_scenario_is_listed_shown_and_gets_the_verdict_expected_of_it() {
    let folder = tempfile::tempdir().expect("folder");
    let list = stdout(&slideway(folder.path(), &["list"]));
    let scenarios = list.lines().skip(1).take_while(|line| line.starts_with(' '));
    let names: Vec<&str> = scenarios.filter_map(|line| line.split_whitespace().next()).collect();
    let output = slideway(folder.path(), &["compare", "--all", "--json"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let gallery = json(&stdout(&output));
    let entries = gallery["scenarios"].as_array().expect("a list");
    let found: Vec<&str> = entries.iter().filter_map(|e| e["scenario"].as_str()).collect();
    assert_eq!(found, names);
    for entry in entries {
        assert_eq!(entry["as_expected"], true, "{entry}");
        // A bracket closes to the default of `optimum.gap`, or there is nothing to certify.
        assert!(entry["gap"].as_f64().is_none_or(|gap| gap <= 1e-5), "{entry}");
    }
    for name in names {
        assert!(folder.path().join("out").join(name).join("report.html").exists());
        assert!(!stdout(&slideway(folder.path(), &["show", name])).is_empty());
    }
    assert!(folder.path().join("out/index.html").exists());
}

#[test]
fn all_and_a_scenario_exclude_each_other_and_one_of_them_is_needed() {
    let folder = tempfile::tempdir().expect("folder");
    for arguments in [&["compare"][..], &["compare", "--all", "puma-helix"]] {
        assert_eq!(slideway(folder.path(), arguments).status.code(), Some(2));
    }
}

#[test]
fn the_template_of_init_runs_as_it_is_and_is_not_overwritten() {
    let folder = tempfile::tempdir().expect("folder");
    assert_eq!(slideway(folder.path(), &["init", "mine.toml"]).status.code(), Some(0));
    assert_eq!(slideway(folder.path(), &["compare", "mine.toml"]).status.code(), Some(0));
    assert!(folder.path().join("out/mine/report.html").exists());
    let again = slideway(folder.path(), &["init", "mine.toml"]);
    assert_eq!(again.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&again.stderr).contains("exists already"));
}

/// A planar two-joint arm on a circle, without a closed-form inverse: nothing of it is built in.
const PLANAR: &str = r#"
[robot]
dh = [{ a = 0.5, alpha = 0, d = 0 }, { a = 0.4, alpha = 0, d = 0 }]
task = "planar-position"
inverse.adjugate.epsilon = 1e-6
[start]
near = [0.2, 1.2]
[path]
end = "2 * pi"
position.formula = { x = "0.5 + 0.1 * cos(lambda)", y = "0.3 + 0.1 * sin(lambda)", z = "0" }
[limits]
speed = [1.0, 2.0]
speed_lower = [-0.5, -1.5]
[control]
gain = 10
sampling_period = 1e-4
bandwidth = 40
target_rate = 8
[compare]
tolerance = 0.03
"#;

#[test]
fn an_arm_and_path_of_ones_own_with_asymmetric_limits_meet_the_optimum() {
    let folder = tempfile::tempdir().expect("folder");
    std::fs::write(folder.path().join("planar.toml"), PLANAR).expect("written");
    let output = slideway(folder.path(), &["compare", "planar.toml", "--json"]);
    assert_eq!(output.status.code(), Some(0), "{}{}", stdout(&output), String::from_utf8_lossy(&output.stderr));
    let summary = json(&stdout(&output));
    let ratio = summary["verdict"]["ratio"].as_f64().expect("ratio");
    // The filter's start-up from rest costs some 35 ms of 1.4 s here.
    assert!((1.0..1.03).contains(&ratio), "{ratio}");
}

#[test]
fn under_acceleration_limits_the_look_ahead_is_judged_by_the_optimum_under_the_same_limits() {
    let folder = tempfile::tempdir().expect("folder");
    let text = PLANAR.replace("speed = [1.0, 2.0]", "speed = [1.0, 2.0]\nacceleration = 2.0");
    std::fs::write(folder.path().join("planar.toml"), text).expect("written");
    let output = slideway(folder.path(), &["compare", "planar.toml", "--json"]);
    let summary = json(&stdout(&output));
    assert!(summary["optimum"]["lower_s"].as_f64() > summary["optimum_speed_only"]["upper_s"].as_f64());
    assert_eq!(summary["verdict"]["method"], "acceleration-look-ahead");
    let ratio = summary["verdict"]["ratio"].as_f64().expect("ratio");
    // Slower than the optimum: the plan keeps 5 % of the acceleration limits in reserve (2.5 % of the time where they bind),
    // and the filter takes its time to rise.
    assert!((1.0..1.1).contains(&ratio), "{ratio}");
    let windows = summary["look_ahead"].as_array().expect("windows");
    assert!(windows.len() > 2 && windows.iter().all(|w| w["samples_off_path"] == 0));
    assert!(folder.path().join("out/planar/figures/look-ahead.svg").exists());
    // The sliding mode, which knows no acceleration limits, exceeds them; the two that do know do not.
    for method in summary["methods"].as_array().expect("methods") {
        let uses = method["limit_use"].as_array().expect("uses");
        let share = uses[0]["share"].as_f64().expect("share");
        let keeps = method["method"].as_str().expect("name").starts_with("acceleration-");
        assert_eq!(share <= 1.0 + 1e-9, keeps, "{method}");
    }
}

#[test]
fn a_disturbed_run_says_by_what() {
    let folder = tempfile::tempdir().expect("folder");
    let show = |name| stdout(&slideway(folder.path(), &["show", name]));
    let speed = "\n[disturbances]\nspeed_error = [0.07, -0.01]\ndelay = 2\n";
    let path = "\n[disturbances]\ndistance_noise = 1e-4\n";
    for (name, table, said) in [
        (
            "planar-line",
            speed,
            "the runs are disturbed: drives off by up to 7 %, measurements late by 2 samples; the optimum is not",
        ),
        (
            "trap-ellipsoid",
            path,
            "forms are disturbed: measured distances off by up to 0.0001 m; the other methods' are not",
        ),
    ] {
        let file = folder.path().join("disturbed.toml");
        std::fs::write(&file, show(name) + table).expect("written");
        let output = slideway(folder.path(), &["compare", "disturbed.toml"]);
        assert!(stdout(&output).contains(said), "{}", stdout(&output));
        let summary = std::fs::read_to_string(folder.path().join("out/disturbed/summary.json")).expect("summary");
        assert!(json(&summary)["disturbances"].is_object());
    }
    let plain = slideway(folder.path(), &["compare", "planar-line", "--json"]);
    assert!(json(&stdout(&plain))["disturbances"].is_null());
}

#[test]
fn quiet_leaves_the_verdict_and_verbose_tells_of_stages_and_files() {
    let folder = tempfile::tempdir().expect("folder");
    let run = |arguments: &[&str]| slideway(folder.path(), &[&["compare", "planar-line"], arguments].concat());
    let (usual, quiet, verbose) = (run(&[]), run(&["--quiet"]), run(&["--verbose"]));
    let verdict =
        json(&stdout(&run(&["--quiet", "--json"])))["verdict"]["sentence"].as_str().expect("words").to_owned();
    assert_eq!((stdout(&quiet), quiet.stderr.is_empty()), (verdict.clone() + "\n", true));
    assert!(stdout(&usual).lines().count() > 10 && stdout(&usual).contains(&verdict));
    let told = String::from_utf8_lossy(&verbose.stderr).into_owned();
    for line in [
        " s  solving for the optimum",
        " s  writing traces and figures",
        "wrote out/planar-line/summary.json",
        "joint-speeds.svg",
    ] {
        assert!(told.contains(line), "{line}: {told}");
    }
    assert!(stdout(&verbose).contains(&verdict));
    let trials = ["verify", "planar-line", "--trials", "3", "--quiet"];
    let verified = slideway(folder.path(), &trials);
    assert_eq!((stdout(&verified).lines().count(), verified.stderr.is_empty()), (1, true), "{}", stdout(&verified));
    assert_eq!(slideway(folder.path(), &["list", "--quiet", "--verbose"]).status.code(), Some(2));
}

#[test]
fn the_schema_lies_where_the_first_line_of_a_new_scenario_says() {
    let folder = tempfile::tempdir().expect("folder");
    for (kind, schema) in [("speed", Scenario::schema()), ("conditioning", ConditioningScenario::schema())] {
        let file = format!("{kind}.toml");
        assert!(slideway(folder.path(), &["init", &file, "--kind", kind]).status.success());
        let text = std::fs::read_to_string(folder.path().join(&file)).expect("reads");
        let named = text.lines().next().and_then(|line| line.strip_prefix("#:schema ./")).expect("a schema");
        assert!(slideway(folder.path(), &["schema", "--kind", kind, "--out", named]).status.success());
        let written = std::fs::read_to_string(folder.path().join(named)).expect("reads");
        assert_eq!(written, stdout(&slideway(folder.path(), &["schema", "--kind", kind])));
        assert_eq!(json(&written), schema);
    }
}

#[test]
fn completions_and_manual_pages_know_every_subcommand() {
    let folder = tempfile::tempdir().expect("folder");
    let pages = folder.path().join("man");
    assert!(slideway(folder.path(), &["man", "--out", "man"]).status.success());
    let page = stdout(&slideway(folder.path(), &["man"]));
    let scripts = ["bash", "zsh", "fish", "elvish", "powershell"]
        .map(|shell| stdout(&slideway(folder.path(), &["completions", shell])));
    let help = stdout(&slideway(folder.path(), &["--help"]));
    let (_, list) = help.split_once("Commands:\n").expect("a list of commands");
    let names = list.lines().take_while(|line| !line.is_empty()).filter_map(|line| line.split_whitespace().next());
    for name in names.filter(|name| *name != "help") {
        assert!(scripts.iter().all(|script| script.contains(name)), "{name}");
        assert!(page.contains(name) && pages.join(format!("slideway-{name}.1")).exists(), "{name}");
    }
}
