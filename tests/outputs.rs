//! An output that cannot be written ends with 2 and says so, whatever the verb, and leaves no results that look whole.

mod support;

use std::path::Path;
use std::process::{Command, Output, Stdio};
use support::slideway;

/// Every verb, as quick as it can be.
const VERBS: [&str; 11] = [
    "--help",
    "--version",
    "list",
    "show planar-line",
    "init mine.toml",
    "robot puma560 --q 0,0.1,0.2,0.3,0.4,0.5",
    "compare planar-line",
    "compare planar-line --json",
    "sweep planar-line --set control.target_rate=1",
    "claims path-band --cases 1",
    "attack path-band --minutes 0.001",
];

/// Verbs that need longer.
const SLOWER: [&str; 3] =
    ["verify planar-line --trials 1", "tune natural-2r --chattering 0.35 --rate 2000", "study cartesian-2r"];

fn printing_to(folder: &Path, verb: &str, stdout: impl Into<Stdio>) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_slideway"));
    command.args(verb.split(' ')).current_dir(folder).stdout(stdout);
    command.stderr(Stdio::piped()).spawn().expect("starts").wait_with_output().expect("ends")
}

fn assert_refused(verb: &str, output: &Output) {
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{verb}: {said}");
    assert!(said.contains("cannot write to standard output"), "{verb}: {said}");
}

#[test]
#[cfg(target_os = "linux")]
fn every_verb_ends_with_two_where_standard_output_is_full() {
    for verb in VERBS.into_iter().chain(SLOWER) {
        let folder = tempfile::tempdir().expect("folder");
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").expect("opens");
        assert_refused(verb, &printing_to(folder.path(), verb, full));
    }
}

#[test]
fn every_verb_ends_with_two_where_the_reader_has_gone() {
    for verb in VERBS {
        let folder = tempfile::tempdir().expect("folder");
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        assert_refused(verb, &printing_to(folder.path(), verb, writer));
    }
}

#[test]
#[cfg(target_os = "linux")]
fn an_error_that_cannot_be_shown_is_no_panic() {
    let folder = tempfile::tempdir().expect("folder");
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").expect("opens");
    let status = Command::new(env!("CARGO_BIN_EXE_slideway"))
        .args(["compare", "nowhere.toml"])
        .current_dir(folder.path())
        .stderr(full)
        .status();
    assert_eq!(status.expect("runs").code(), Some(2));
}

#[test]
#[cfg(target_os = "linux")]
fn a_summary_never_stands_beside_what_could_not_be_written() {
    for (verb, file, summary) in [
        ("compare planar-line --out out", "trace-sliding-mode.csv", "summary.json"),
        ("compare planar-line --out out", "report.html", "summary.json"),
        ("sweep planar-line --set control.target_rate=1 --out out", "rows.csv", "summary.json"),
        ("verify planar-line --trials 1 --out out", "junit.xml", "verify.json"),
    ] {
        let folder = tempfile::tempdir().expect("folder");
        let out = folder.path().join("out");
        std::fs::create_dir(&out).expect("made");
        // Of an earlier run.
        std::fs::write(out.join(summary), "{}").expect("written");
        // A file on a disk without room: whatever is written into it is refused.
        std::os::unix::fs::symlink("/dev/full", out.join(file)).expect("linked");
        let output = slideway(folder.path(), &verb.split(' ').collect::<Vec<_>>());
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{verb}: {said}");
        assert!(said.contains("cannot write") && said.contains(file), "{verb}: {said}");
        assert!(!out.join(summary).exists(), "{verb}: a summary beside {file}");
        let parts = std::fs::read_dir(&out)
            .expect("listed")
            .filter(|entry| entry.as_ref().expect("an entry").file_name().to_string_lossy().ends_with(".part"));
        assert_eq!(parts.count(), 0, "{verb}: parts are left");
    }
}

#[test]
fn a_line_is_echoed_up_to_200_characters() {
    let folder = tempfile::tempdir().expect("folder");
    let long = "1, ".repeat(5000);
    for (name, text) in [
        ("value", format!("{}\nlimits.speed = [{long}\"x\"]\n", slideway_scenario::TEMPLATE)),
        ("key", format!("{} = 1\n", "k".repeat(5000))),
        ("formula", slideway_scenario::TEMPLATE.replace("end = ", &format!("end = \"{}w\" # ", "1 + ".repeat(2000)))),
    ] {
        std::fs::write(folder.path().join("long.toml"), text).expect("written");
        let output = slideway(folder.path(), &["compare", "long.toml"]);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{name}");
        assert!(said.lines().all(|line| line.chars().count() <= 220), "{name}: {said}");
        assert!(said.chars().count() < 2000, "{name}: {said}");
    }
    let output = slideway(folder.path(), &["compare", &"n".repeat(3000)]);
    assert!(output.stderr.len() < 1000);
}

#[test]
fn names_of_constraints_are_there_differ_and_need_no_quotes() {
    let template = slideway_scenario::CONDITIONING_TEMPLATE;
    let names: Vec<&str> = template.lines().filter(|line| line.starts_with("name = ")).collect();
    assert_eq!(names.len(), 2);
    for (name, says) in
        [("\"\"", "is empty"), ("\"a,b\"", "cannot have"), (&names[0]["name = ".len()..], "stands twice")]
    {
        let folder = tempfile::tempdir().expect("folder");
        let text = template.replace(names[1], &format!("name = {name}"));
        std::fs::write(folder.path().join("mine.toml"), text).expect("written");
        let output = slideway(folder.path(), &["compare", "mine.toml"]);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{name}: {said}");
        assert!(said.contains(says) && said.contains("help:"), "{name}: {said}");
    }
}

#[test]
fn every_field_of_a_trace_is_a_number_a_word_or_empty() {
    let folder = tempfile::tempdir().expect("folder");
    for scenario in ["planar-line", "helix-plane-sphere"] {
        slideway(folder.path(), &["compare", scenario, "--out", scenario]);
        for entry in std::fs::read_dir(folder.path().join(scenario)).expect("listed") {
            let path = entry.expect("an entry").path();
            if path.extension().is_none_or(|kind| kind != "csv") {
                continue;
            }
            let text = std::fs::read_to_string(&path).expect("read");
            for word in text.split([',', '\n']) {
                let word = word.to_lowercase();
                assert!(!["nan", "inf", "-inf", "null", "none"].contains(&word.as_str()), "{}: {word}", path.display());
            }
        }
    }
}
