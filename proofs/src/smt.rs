//! Runs z3 on the text of a claim.

use std::io::Write;
use std::process::{Command, Stdio};

/// The solver's verdict on an SMT-LIB text, first word of its answer.
pub(crate) fn verdict(text: &str) -> String {
    let mut solver = Command::new("z3")
        .args(["-in", "-T:60"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("z3 has to be installed to check the proofs");
    solver.stdin.take().expect("a piped input").write_all(text.as_bytes()).expect("z3 reads its input");
    let output = solver.wait_with_output().expect("z3 ends");
    String::from_utf8_lossy(&output.stdout).lines().next().unwrap_or_default().to_owned()
}

/// Asserts that the claim holds and that its twin, with a hypothesis dropped, does not.
pub(crate) fn assert_proved(claim: &str, twin: &str) {
    assert_eq!(verdict(claim), "unsat", "the claim has a counterexample or was not decided");
    assert_eq!(verdict(twin), "sat", "the twin without the hypothesis should have a counterexample");
}
