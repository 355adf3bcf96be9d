//! The command, and what it leaves.

use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;

use crate::support::slideway;

/// A scenario whose trials are short.
pub(crate) const SCENARIO: &str = "planar-line";
/// Everything that a campaign leaves and that must not depend on how it was run.
pub(crate) const RESULTS: [&str; 3] = ["verify.json", "junit.xml", "report.html"];

pub(crate) fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("folder")
}

/// Runs the command; its status and what it printed on either stream, unwrapped.
pub(crate) fn run(folder: &Path, arguments: &[&str]) -> (i32, String) {
    let output = slideway(folder, arguments);
    let printed = format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(!printed.contains("panicked"), "{printed}");
    let unwrapped = printed.replace("\n  │ ", " ").replace("\n        ", " ");
    (output.status.code().expect("a status"), unwrapped)
}

/// Runs a campaign whose verdict does not matter.
pub(crate) fn verify(folder: &Path, out: &str, more: &[&str]) -> String {
    let all: Vec<&str> = ["verify", SCENARIO, "--trials", "12", "--out", out].iter().chain(more).copied().collect();
    let (status, printed) = run(folder, &all);
    assert!(status == 0 || status == 1, "{all:?}: {printed}");
    printed
}

/// Runs a command that must be refused for what it is given, with a remedy.
pub(crate) fn refused(folder: &Path, arguments: &[&str], says: &str) {
    let (status, printed) = run(folder, arguments);
    assert_eq!(status, 2, "{arguments:?}: {printed}");
    assert!(printed.contains(says), "{arguments:?}: `{says}` not in: {printed}");
    assert!(printed.contains("help:") || printed.contains("--help"), "no remedy in: {printed}");
}

pub(crate) fn read(folder: &Path, file: &str) -> String {
    std::fs::read_to_string(folder.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

pub(crate) fn same_results(folder: &Path, one: &str, other: &str) {
    for file in RESULTS {
        assert_eq!(read(folder, &format!("{one}/{file}")), read(folder, &format!("{other}/{file}")), "{file}");
    }
    let files = |out: &str| {
        let entries = std::fs::read_dir(folder.join(out)).expect("folder");
        entries.map(|e| e.expect("entry").file_name().into_string().expect("UTF-8")).collect::<BTreeSet<_>>()
    };
    let failing = |out: &str| files(out).into_iter().filter(|f| f.starts_with("failing-")).collect::<Vec<_>>();
    assert_eq!(failing(one), failing(other));
    for file in failing(one) {
        assert_eq!(read(folder, &format!("{one}/{file}")), read(folder, &format!("{other}/{file}")), "{file}");
    }
}

pub(crate) fn parsed(text: &str) -> Value {
    serde_json::from_str(text).expect("valid JSON")
}

pub(crate) fn merge(folder: &Path, shards: &[String], out: &str) -> (i32, String) {
    let all: Vec<&str> = ["merge"].into_iter().chain(shards.iter().map(String::as_str)).chain(["--out", out]).collect();
    run(folder, &all)
}
