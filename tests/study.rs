//! `slideway study`: every study through the command line, and what it says to wrong input.

use serde_json::Value;
use std::process::{Command, Output};

fn slideway(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_slideway")).args(arguments).output().expect("runs")
}

#[test]
fn every_study_holds_and_leaves_summary_figure_and_report() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("a plain path");
    let output = slideway(&["study", "--all", "--out", out]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stdout));
    let studies = std::fs::read_dir(folder.path()).expect("readable").count();
    assert!(studies >= 1);
    for study in std::fs::read_dir(folder.path()).expect("readable") {
        let study = study.expect("readable").path();
        let summary: Value =
            serde_json::from_slice(&std::fs::read(study.join("summary.json")).expect("written")).expect("valid JSON");
        assert_eq!(summary["holds"], Value::Bool(true));
        assert!(summary["numbers"].as_array().is_some_and(|numbers| !numbers.is_empty()));
        for file in ["figures/chart.svg", "figures/chart.png", "report.html"] {
            assert!(study.join(file).exists(), "{} of {}", file, study.display());
        }
    }
}

#[test]
fn a_study_prints_its_summary_as_json() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("a plain path");
    let output = slideway(&["study", "interrupts", "--json", "--out", out]);
    let printed: Value = serde_json::from_slice(&output.stdout).expect("valid JSON");
    let written: Value = serde_json::from_slice(&std::fs::read(folder.path().join("summary.json")).expect("written"))
        .expect("valid JSON");
    assert_eq!(printed, written);
    assert_eq!(printed["study"], "interrupts");
}

#[test]
fn an_unknown_study_is_refused_with_the_nearest_name() {
    let output = slideway(&["study", "interupts"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("did you mean `interrupts`?"));
    assert_eq!(slideway(&["study"]).status.code(), Some(2));
}
