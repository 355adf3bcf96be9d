//! The `slideway` command as the tests of the whole run it.
#![allow(dead_code, reason = "every test file uses a part of it")]

use std::path::Path;
use std::process::{Command, Output};

/// Runs the command in a folder.
pub(crate) fn slideway(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_slideway")).args(arguments).current_dir(folder).output().expect("runs")
}

/// What it printed.
pub(crate) fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("UTF-8")
}

/// A text that has to be JSON.
pub(crate) fn json(text: &str) -> serde_json::Value {
    serde_json::from_str(text).expect("valid JSON")
}
