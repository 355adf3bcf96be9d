//! The `slideway` command as the tests of the whole run it.
#![allow(dead_code, reason = "every test file uses a part of it")]

use std::path::Path;
use std::process::{Command, Output};

/// Runs the command in a folder.
pub(crate) fn slideway(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_slideway")).args(arguments).current_dir(folder).output().expect("runs")
}

/// Standard output of a command, as text.
pub(crate) fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("UTF-8")
}

/// A text that has to be JSON.
pub(crate) fn json(text: &str) -> serde_json::Value {
    serde_json::from_str(text).expect("valid JSON")
}

/// Way-points of two joints.
pub(crate) const WAY_POINTS: &str = "q1,q2\n0,0.5\n0.2,0.7\n0.3,1.1\n0.5,1.2\n";

/// A scenario of an arm with two joints, named by a line, on a joint path whose way-points are in a file.
pub(crate) fn from_files(robot: &str, csv: &str) -> String {
    format!(
        r#"
[robot]
{robot}
[path.joints.spline]
csv = "{csv}"
[limits]
speed = 1
[control]
gain = 10
sampling_period = 1e-3
bandwidth = 50
target_rate = 2
"#
    )
}
