//! `slideway tune` as a user meets it.

mod support;

use support::{slideway, stdout};

#[test]
fn a_proposal_is_written_as_a_scenario_that_keeps_its_comments() {
    let folder = tempfile::tempdir().expect("folder");
    let asked = ["tune", "natural-2r", "--chattering", "0.35", "--rate", "2000", "--out", "mine.toml"];
    let output = slideway(folder.path(), &asked);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let text = stdout(&output);
    for part in
        ["control.bandwidth = ", "control.sampling_period = 0.0005 s (was 2e-4)", "time-over-optimum", "mine.toml"]
    {
        assert!(text.contains(part), "{part}: {text}");
    }
    let written = std::fs::read_to_string(folder.path().join("mine.toml")).expect("written");
    assert!(
        written.contains("sampling_period = 0.0005\n")
            && written.contains("# The peak joint speed of constant-speed tracking")
    );
    // What was written needs no more tuning.
    let again = slideway(folder.path(), &["tune", "mine.toml", "--chattering", "0.35", "--rate", "2000", "--json"]);
    let outcome: serde_json::Value = serde_json::from_str(&stdout(&again)).expect("valid JSON");
    assert!(outcome["tuned"]["predictions"].is_array() && outcome["tuned"]["statement"]["hypotheses"].is_array());
    assert_eq!(outcome["tuned"]["changes"], serde_json::json!([]));
}

#[test]
fn an_impossible_wish_ends_with_one_and_says_what_would_do() {
    let folder = tempfile::tempdir().expect("folder");
    let output = slideway(
        folder.path(),
        &["tune", "planar-line", "--chattering", "0.01", "--rate", "200", "--out", "mine.toml"],
    );
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    let text = stdout(&output);
    assert!(text.starts_with("No: ") && text.contains(" Hz would do") && text.contains("has to be allowed"), "{text}");
    assert!(!folder.path().join("mine.toml").exists());
}

#[test]
fn wrong_input_ends_with_two_and_a_remedy() {
    let folder = tempfile::tempdir().expect("folder");
    for (arguments, part) in [
        (["tune", "planar-line", "--chattering", "0", "--rate", "200"], "give a positive number"),
        (["tune", "planar-line", "--chattering", "0.1", "--rate", "-5"], "give a positive number"),
        (["tune", "planar-bend", "--chattering", "0.1", "--rate", "1000"], "compare.method"),
        (["tune", "nowhere", "--chattering", "0.1", "--rate", "1000"], "slideway list"),
    ] {
        let output = slideway(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        let error = String::from_utf8_lossy(&output.stderr).replace(['\n', '│'], " ");
        let error = error.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(error.contains(part), "{arguments:?}: {error}");
    }
}
