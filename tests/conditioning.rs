//! Path conditioning through the command: the figures of [G12]'s examples, user files, wrong input.

mod support;

use serde_json::Value;
use std::path::Path;
use support::slideway;

fn compare(folder: &Path, scenario: &str) -> (i32, Value) {
    let output = slideway(folder, &["compare", scenario, "--json"]);
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    let summary = serde_json::from_str(&text).unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&output.stderr)));
    (output.status.code().expect("exits"), summary)
}

fn method<'a>(summary: &'a Value, name: &str) -> &'a Value {
    summary["methods"].as_array().expect("methods").iter().find(|m| m["method"] == name).expect("the method")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[test]
fn example_9_1_has_the_specified_figures() {
    let folder = tempfile::tempdir().expect("folder");
    let (status, summary) = compare(folder.path(), "helix-plane-sphere");
    assert_eq!(status, 0);
    // Means of the specification, each ± 0.05 mm.
    for (name, mean) in [("projection", 4.52e-3), ("sliding-mode", 5.24e-3), ("potential-field", 11.36e-3)] {
        let found = number(&method(&summary, name)["mean_deviation_m"]);
        assert!((found - mean).abs() <= 5e-5, "{name}: {found}");
    }
    let sliding = method(&summary, "sliding-mode");
    for (i, sigma) in [-0.80e-3, -0.78e-3].into_iter().enumerate() {
        assert!((number(&sliding["max_sigma_m"][i]) - sigma).abs() <= 5e-5);
        assert_eq!(number(&sliding["clearance_m"][i]), -number(&sliding["max_sigma_m"][i]));
    }
    assert!((number(&sliding["all_active_s"]) - 0.53).abs() <= 0.02);
    let chattering = &sliding["chattering"];
    assert!(number(&chattering["measured"]) <= number(&chattering["bound"]));
    let implicit = method(&summary, "sliding-mode-implicit");
    assert!(number(&implicit["max_distance_to_qp_m"]) <= 1e-6);
    for file in ["summary.json", "report.html", "trace-qp-filter.csv", "trace-projection.csv"] {
        assert!(folder.path().join("out/helix-plane-sphere").join(file).exists(), "{file}");
    }
}

#[test]
fn distance_to_the_qp_path_falls_with_the_sampling_period() {
    let folder = tempfile::tempdir().expect("folder");
    let text = String::from_utf8(slideway(folder.path(), &["show", "helix-plane-sphere"]).stdout).expect("UTF-8");
    for (period, mean) in [("1e-3", 0.336e-3), ("2e-4", 0.068e-3), ("5e-5", 0.018e-3)] {
        std::fs::write(
            folder.path().join("s.toml"),
            text.replace("sampling_period = 1e-3", &format!("sampling_period = {period}")),
        )
        .expect("written");
        let (_, summary) = compare(folder.path(), "s.toml");
        let found = number(&method(&summary, "sliding-mode")["mean_distance_to_qp_m"]);
        assert!((found / mean - 1.0).abs() <= 0.1, "{period} s: {found}");
    }
}

#[test]
fn the_conditioner_escapes_every_trap_and_the_safe_walk_keeps_its_constraint() {
    let folder = tempfile::tempdir().expect("folder");
    for name in ["trap-ellipsoid", "trap-two-ellipsoids", "trap-booth-oval"] {
        let (status, summary) = compare(folder.path(), name);
        assert_eq!(status, 0, "{name}: {}", summary["verdict"]["sentence"]);
        for form in ["sliding-mode", "sliding-mode-paper", "sliding-mode-implicit"] {
            let entry = method(&summary, form);
            assert_eq!(entry["completed"], true, "{name} {form}");
            assert!(number(&entry["escape_s"]) > 0.0, "{name} {form}");
        }
        assert!(method(&summary, "qp-filter")["escape_s"].is_null());
    }
}

#[test]
fn a_typed_formula_is_the_same_constraint_as_the_built_in_sphere() {
    let folder = tempfile::tempdir().expect("folder");
    let text = String::from_utf8(slideway(folder.path(), &["show", "helix-plane-sphere"]).stdout).expect("UTF-8");
    let sphere = r#"shape.sphere = { centre = [0, 0, 0], radius = 0.05, side = "outside" }"#;
    assert!(text.contains(sphere));
    let typed = text.replace(sphere, r#"shape.formula = "0.05 - sqrt(x^2 + y^2 + z^2)""#);
    std::fs::write(folder.path().join("typed.toml"), typed).expect("written");
    let (_, built_in) = compare(folder.path(), "helix-plane-sphere");
    let (_, typed) = compare(folder.path(), "typed.toml");
    for key in ["mean_deviation_m", "max_deviation_m"] {
        let difference = number(&method(&built_in, "sliding-mode-implicit")[key])
            - number(&method(&typed, "sliding-mode-implicit")[key]);
        // The same function evaluated in another order: rounding, along a path that does not amplify it.
        assert!(difference.abs() < 1e-9, "{key}: {difference}");
    }
    // Without a closed form the projection comes from descents; it finds the same points.
    let difference = number(&method(&built_in, "projection")["mean_deviation_m"])
        - number(&method(&typed, "projection")["mean_deviation_m"]);
    assert!(difference.abs() < 1e-7, "{difference}");
}

#[test]
fn the_conditioning_template_runs_as_it_is_and_with_a_moving_obstacle() {
    let folder = tempfile::tempdir().expect("folder");
    let init = slideway(folder.path(), &["init", "mine.toml", "--kind", "conditioning"]);
    assert_eq!(init.status.code(), Some(0));
    let (status, _) = compare(folder.path(), "mine.toml");
    assert_eq!(status, 0);
    let text = slideway_scenario::CONDITIONING_TEMPLATE.replace("# motion.oscillation", "motion.oscillation");
    std::fs::write(folder.path().join("moving.toml"), text).expect("written");
    let (_, moving) = compare(folder.path(), "moving.toml");
    // The implicit form keeps φ <= 0 at every sample, moving or not; σ lags behind φ.
    for phi in method(&moving, "sliding-mode-implicit")["max_phi_m"].as_array().expect("list") {
        assert!(number(phi) <= 1e-9, "{phi}");
    }
}

#[test]
fn wrong_conditioning_input_names_file_line_and_remedy() {
    let template = slideway_scenario::CONDITIONING_TEMPLATE;
    for (from, to, says) in [
        ("rate = \"2 * pi / 5\"", "rate = 0", "not positive"),
        ("end = \"2 * pi\"", "end = -1", "does not lie after"),
        ("approach = 0.1", "approach = 0", "not positive"),
        ("push_cutoff = 20", "push_cutoff = nan", "not a finite number"),
        ("push_cutoff = 20", "push_cutof = 20", "unknown field"),
        ("sampling_period = 1e-3", "sampling_period = -1", "not positive"),
        ("law.normalised.amplitude = 0.1", "law.normalised.amplitude = 0", "not positive"),
        ("shape.formula = \"0.05 - sqrt(x^2 + y^2 + z^2)\"", "shape.formula = \"0.05 - w\"", "`w`"),
        (
            "shape.formula = \"0.05 - sqrt(x^2 + y^2 + z^2)\"",
            "shape.formula = \"(x^2 + y^2 + z^2 - 0.0025)^2\"",
            "gradient vanishes",
        ),
        (
            "shape.half-space = { normal = [0, 1, 0], offset = 0 }",
            "shape.half-space = { normal = [0, 0, 0], offset = 0 }",
            "length",
        ),
        ("margin = \"none\"", "margin.fixed = [0.001]", "1 numbers given, 2 needed"),
    ] {
        let line = template.lines().position(|l| l == from).unwrap_or_else(|| panic!("no line `{from}`"));
        let folder = tempfile::tempdir().expect("folder");
        std::fs::write(folder.path().join("bad.toml"), template.replacen(from, to, 1)).expect("written");
        let output = slideway(folder.path(), &["compare", "bad.toml"]);
        let printed = String::from_utf8_lossy(&output.stderr).replace("\n  │ ", " ");
        assert_eq!(output.status.code(), Some(2), "{to}: {printed}");
        assert!(printed.contains(&format!("bad.toml:{}:", line + 1)), "no line {} in: {printed}", line + 1);
        assert!(printed.contains(says) && printed.contains("help:"), "`{says}` not in: {printed}");
    }
}

#[test]
fn contradictory_constraints_hold_the_reference_and_fail_the_verdict() {
    let folder = tempfile::tempdir().expect("folder");
    let text = r#"
        [reference]
        end = 1
        rate = 1
        position.line = { from = [0, 0, 0], to = [1, 0, 0] }
        [[constraint]]
        name = "left"
        approach = 0.1
        shape.half-space = { normal = [1, 0, 0], offset = 0.4 }
        [[constraint]]
        name = "right"
        approach = 0.1
        shape.formula = "0.6 - x"
        [conditioner]
        sampling_period = 1e-3
        push_cutoff = 20
        law.normalised.amplitude = 0.5
    "#;
    std::fs::write(folder.path().join("empty.toml"), text).expect("written");
    let (status, summary) = compare(folder.path(), "empty.toml");
    assert_eq!(status, 1);
    assert!(summary["projection"].is_null());
    for form in ["sliding-mode", "sliding-mode-implicit"] {
        assert!(number(&method(&summary, form)["audit"]["held_share"]) > 0.0, "{form}");
    }
}
