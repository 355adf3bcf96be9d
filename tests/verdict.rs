//! What the verdict of `compare` says is so.

mod support;

use support::slideway;

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

/// What is said of a scenario that cannot be compared.
fn refused(scenario: &str) -> String {
    let folder = tempfile::tempdir().expect("folder");
    std::fs::write(folder.path().join("mine.toml"), scenario).expect("written");
    let output = slideway(folder.path(), &["compare", "mine.toml"]);
    assert_eq!(output.status.code(), Some(2));
    // The report wraps its lines.
    String::from_utf8_lossy(&output.stderr).split_whitespace().filter(|word| *word != "│").collect::<Vec<_>>().join(" ")
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
