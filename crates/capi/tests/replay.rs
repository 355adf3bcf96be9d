//! The same bits: what the core decides, C and C++ decide through this interface, to the last bit.

mod support;

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use support::{Recording, cases, paths};

fn of_joints<const N: usize>(recording: &mut Recording) {
    for law in 0..3 {
        for saturation in 0..2 {
            cases::speed::<N>(recording, law, saturation, 250);
        }
    }
    for braking in [false, true] {
        cases::acceleration::<N>(recording, braking, 150);
    }
    for form in 0..4 {
        paths::path::<N, 1>(recording, form, form == 2, 150);
        paths::path::<N, 2>(recording, form, form == 2, 150);
    }
}

fn recording() -> Recording {
    let mut recording = Recording::default();
    of_joints::<1>(&mut recording);
    of_joints::<2>(&mut recording);
    of_joints::<6>(&mut recording);
    of_joints::<12>(&mut recording);
    recording
}

/// The static library, which cargo builds beside the tests.
fn library() -> PathBuf {
    let test = std::env::current_exe().expect("the test's own path");
    test.parent().expect("a folder").join("libslideway_capi.a")
}

/// Compiles a program against the header and the library, and gives it the recording.
fn replay(compiler: &str, standard: &str, source: &str, input: &Path) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let program = Path::new(env!("CARGO_TARGET_TMPDIR")).join(source.replace('.', "-"));
    let status = Command::new(compiler)
        .args([standard, "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror", "-o"])
        .arg(&program)
        .arg(format!("-I{}", root.join("include").display()))
        .arg(root.join("tests/native").join(source))
        .arg(library())
        .args(["-lpthread", "-ldl", "-lm"])
        .status()
        .unwrap_or_else(|error| panic!("{compiler}: {error}; a C and a C++ compiler are needed (build-essential)"));
    assert!(status.success(), "{source} does not compile");
    let input = std::fs::File::open(input).expect("the recording");
    let run = Command::new(&program).stdin(input).stderr(Stdio::inherit()).output().expect("the program runs");
    assert!(run.status.success(), "{source}: {}", run.status);
    String::from_utf8(run.stdout).expect("text")
}

fn assert_same(source: &str, printed: &str, expected: &str) {
    for (number, (is, should)) in printed.lines().zip(expected.lines()).enumerate() {
        assert_eq!(is.trim_end(), should.trim_end(), "{source}: line {} of the replay", number + 1);
    }
    assert_eq!(printed.lines().count(), expected.lines().count(), "{source}: lines of the replay");
}

#[test]
fn c_and_cpp_replay_the_core_to_the_last_bit() {
    let recording = recording();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let input = folder.join("recording.txt");
    std::fs::write(&input, &recording.input).expect("a writable folder");
    std::fs::write(folder.join("expected.txt"), &recording.output).expect("a writable folder");
    for (compiler, standard, source) in [("cc", "-std=c11", "replay.c"), ("c++", "-std=c++17", "replay.cpp")] {
        assert_same(source, &replay(compiler, standard, source, &input), &recording.output);
    }
}

#[test]
fn the_recording_makes_the_laws_act_and_hold() {
    let output = recording().output;
    // The words at the end of a line, after its numbers: outcome, cause, constraint and phase of a path, the keeping of a regulator.
    let met = |first: &str, count: usize| {
        output.lines().any(|line| {
            let words: Vec<&str> = line.split(' ').filter(|word| word.len() != 16 && !word.is_empty()).collect();
            words.len() == count && words.first() == Some(&first)
        })
    };
    for outcome in ["0", "1", "3"] {
        assert!(met(outcome, 4), "no outcome {outcome}");
    }
    for keeping in ["0", "1", "2"] {
        assert!(met(keeping, 1), "no keeping {keeping}");
    }
}
