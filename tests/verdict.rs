//! Verdicts of `compare` say what is so.

mod support;

use support::{json, slideway, stdout};

/// One joint from 0 to 1 rad at up to 1 rad/s.
const JOINT: &str = "
    robot.dh = [{ a = 0.5, alpha = 0, d = 0 }]
    path.joints.line = { from = [0], to = [1] }
    optimum.grid_points = 100
";

/// A planar arm on a straight line of its tool.
const LINE: &str = "
    limits.speed = 1
    control = { gain = 10, sampling_period = 1e-3, bandwidth = 10, target_rate = 5 }
    optimum.grid_points = 100
    [robot]
    dh = [{ a = 0.5, alpha = 0, d = 0 }, { a = 0.4, alpha = 0, d = 0 }]
    task = 'planar-position'
    inverse.adjugate.epsilon = 1e-5
    [start]
    near = [0.3, 1.2]
    [path]
    end = 1
    position.line = { from = [0.5, 0.3, 0], to = [0.2, 0.6, 0] }
";

/// A comparison's verdict.
struct Said {
    sentence: String,
    holds: bool,
    summary: serde_json::Value,
}

impl Said {
    fn method(&self, name: &str) -> &serde_json::Value {
        let methods = self.summary["methods"].as_array().expect("list");
        methods.iter().find(|m| m["method"] == name).expect("was run")
    }
}

fn compare(scenario: &str) -> Said {
    let folder = tempfile::tempdir().expect("folder");
    std::fs::write(folder.path().join("mine.toml"), scenario).expect("written");
    let output = slideway(folder.path(), &["compare", "mine.toml", "--json"]);
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(matches!(output.status.code(), Some(0 | 1)), "{error}");
    let summary = json(&stdout(&output));
    let said = Said {
        sentence: summary["verdict"]["sentence"].as_str().expect("text").to_owned(),
        holds: summary["verdict"]["holds"].as_bool().expect("bool"),
        summary,
    };
    assert_eq!(output.status.code(), Some(i32::from(!said.holds)));
    said
}

/// Message about a scenario that cannot be compared.
fn refused(scenario: &str) -> String {
    let folder = tempfile::tempdir().expect("folder");
    std::fs::write(folder.path().join("mine.toml"), scenario).expect("written");
    let output = slideway(folder.path(), &["compare", "mine.toml"]);
    assert_eq!(output.status.code(), Some(2));
    // The report wraps its lines.
    String::from_utf8_lossy(&output.stderr).split_whitespace().filter(|word| *word != "│").collect::<Vec<_>>().join(" ")
}

const CONTROL: &str = "control = { gain = 10, sampling_period = 1e-3, bandwidth = 5, target_rate = 5 }\n";

#[test]
fn a_method_that_commands_beyond_a_joint_speed_limit_is_not_comparable_however_the_limit_is_written() {
    for limit in ["0.5", "'0.5 + 0 * lambda'"] {
        let path = "robot.dh = [{ a = 0.5, alpha = 0, d = 0 }]\n\
                    path.joints.spline = { points = [[0], [1.5], [-0.5], [0.7]], at = [0, 1, 2.2, 3] }\n";
        let ideal = format!("{path}{CONTROL}limits.speed = {limit}\ncompare.method = 'ideal'\n");
        let said = compare(&ideal);
        let beyond = "the method `ideal`, which has no limits, exceeds them ";
        assert!(!said.holds && said.sentence.contains(beyond), "{}", said.sentence);
        assert!(said.method("ideal")["command_use"].as_f64() > Some(1.01));
        // A law whose demand is beyond the limits and whose command is not stays comparable.
        let saturated = said.method("sliding-mode");
        assert!(saturated["limit_ratio_peak"].as_f64() > Some(1.01) && saturated["command_use"].as_f64() <= Some(1.0));
        assert!(compare(&ideal.replace("'ideal'", "'sliding-mode-synchronised'")).holds);
    }
}

#[test]
fn a_verdict_says_what_its_method_knows() {
    for (method, knows) in [
        ("natural-motion", "knowing the speed limits and the whole path in advance,"),
        ("constant-speed", "knowing the speed limits and the whole path in advance,"),
        ("sliding-mode-synchronised", "knowing nothing in advance,"),
        ("saturated", "run at a speed fixed beforehand,"),
    ] {
        let said = compare(&format!("{LINE}[natural]\n[compare]\ntolerance = 0.9\nmethod = '{method}'\n"));
        assert!(said.holds && said.sentence.contains(knows), "{}", said.sentence);
    }
}

#[test]
fn the_target_rate_is_named_to_regulated_methods_below_every_limit_and_to_no_other() {
    let hint = "The limits were never reached: raise `control.target_rate`.";
    for method in ["saturated", "constant-speed", "natural-motion"] {
        let said = compare(&format!("{LINE}[natural]\n[compare]\ntolerance = 1e-9\nmethod = '{method}'\n"));
        assert!(!said.holds && !said.sentence.contains(hint), "{}", said.sentence);
    }
    let slow = CONTROL.replace("target_rate = 5", "target_rate = 0.5");
    let said = compare(&format!("{JOINT}{slow}limits.speed = 1\n"));
    assert!(said.sentence.contains(hint), "{}", said.sentence);
    // The tool's limit is one too: 0.1 m/s at half a metre is 0.2 rad/s.
    let said = compare(&format!("{JOINT}{slow}limits = {{ speed = 1, tool_speed = 0.1 }}\ncompare.tolerance = 1e-4\n"));
    assert!(!said.holds && !said.sentence.contains(hint), "{}", said.sentence);
}

#[test]
fn less_than_the_optimum_s_time_is_put_down_to_what_disturbs_the_run() {
    let fast = format!("{JOINT}{CONTROL}limits.speed = 1\ndisturbances.speed_error = [0.9]\ncompare.tolerance = 0.5\n");
    let said = compare(&fast);
    assert!(said.summary["verdict"]["ratio"].as_f64() < Some(0.99));
    let cause = "the run is disturbed (drives off by up to 90 %), the optimum is not.";
    assert!(said.sentence.contains(cause) && !said.sentence.contains("path by up to"), "{}", said.sentence);
}

#[test]
fn a_sample_less_than_the_optimum_s_time_is_as_long_as_the_optimum_s_time() {
    let coarse = "control = { gain = 1, sampling_period = 0.5, bandwidth = 1, target_rate = 2 }\nlimits.speed = 1\n";
    let said = compare(&format!("{JOINT}{coarse}"));
    // 1 / 3 of the last period at the rate 2 before it was cut: the trace's joint takes the whole of it.
    let ratio = said.summary["verdict"]["ratio"].as_f64().expect("number");
    assert!((ratio - 5.0 / 6.0).abs() < 1e-6, "{ratio}");
    let apart = "within a sample of the optimum (0.5 s), and times are resolved no finer";
    assert!(said.sentence.contains(apart) && !said.sentence.contains("less"), "{}", said.sentence);
    // The demand is at the limit, to the last bit inside.
    assert!(!said.sentence.contains("never reached"), "{}", said.sentence);
}

#[test]
fn a_law_exceeds_the_tool_s_speed_by_its_feedback_alone_and_no_other_optimum_is_pointed_to() {
    let off =
        format!("{JOINT}{CONTROL}limits = {{ speed = 1, tool_speed = 0.1 }}\ndisturbances.initial_error = [-0.2]\n");
    let said = compare(&off);
    let told = "sliding mode, whose reference keeps them and whose feedback does not, exceeds them ";
    assert!(!said.holds && said.sentence.contains(told), "{}", said.sentence);
    assert!(!said.sentence.contains("alone)") && said.summary["optimum_speed_only"].is_null());
    let said = compare(&off.replace("[-0.2]\n", "[-0.2]\ncompare.method = 'saturated'\n"));
    assert!(said.sentence.contains("method `saturated`, which does not know them, exceeds"), "{}", said.sentence);
}

#[test]
fn limits_that_bind_the_optimum_alone_point_to_the_optimum_without_them() {
    let said = compare(&format!("{JOINT}{CONTROL}limits = {{ speed = 1, tool_acceleration = 1 }}\n"));
    let told =
        "the limits on tool acceleration and the synchronised sliding mode, which does not know them, exceeds them ";
    assert!(!said.holds && said.sentence.contains(told), "{}", said.sentence);
    let pointed = said.sentence.contains("(see the optimum under speed limits alone)");
    assert!(pointed && said.summary["optimum_speed_only"].is_object());
}

#[test]
fn a_run_that_time_ran_out_on_has_not_stopped_and_the_key_that_would_help_is_named() {
    let short = CONTROL.replace(" }", ", max_duration = 0.5 }");
    let said = compare(&format!("{JOINT}{short}limits.speed = 1\n"));
    let told = "given up after 0.5000 s with the reference still moving, at path parameter 0.4";
    assert!(said.sentence.contains(told) && said.sentence.contains("`control.max_duration`"), "{}", said.sentence);
    let slow = CONTROL.replace("target_rate = 5", "target_rate = 0.001");
    let said = compare(&format!("{JOINT}{slow}limits.speed = 1\n"));
    let told = "with the reference still moving, at path parameter 0.0398: no limit was ever reached, raise `control.target_rate`";
    assert!(said.sentence.contains(told), "{}", said.sentence);
    assert!(!said.sentence.contains("stopped"));
}

#[test]
fn each_kind_of_method_says_what_it_needs_to_be_judged() {
    let said = refused(&format!("{LINE}[compare]\nmethod = 'natural-motion'\n"));
    assert!(said.contains("needs a `[natural]` table") && said.contains("add a table `[natural]`"), "{said}");
    assert!(!said.contains("acceleration"), "{said}");
    let said = refused(&format!("{LINE}[compare]\nmethod = 'acceleration-limited'\n"));
    assert!(said.contains("needs joint-acceleration limits") && said.contains("give `limits.acceleration`"), "{said}");
    assert!(!said.contains("keep one of the keys"), "{said}");
}
