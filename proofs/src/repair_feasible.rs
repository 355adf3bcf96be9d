//! Claim `repair-feasible`: whatever a solver answers, the repaired profile keeps every row and cap.
//!
//! Hypotheses: a program that some positive profile keeps with room to spare. The answer is arbitrary: NaN, infinities, negative
//! numbers, any size.
//!
//! ```text
//! x̃ = repair(x):   0 <= x̃_k <= cap_k,   A x̃ <= c   in outward-rounded arithmetic
//! ```
//!
//! Source: this project.
//!
//! Derivation. A row that `x` exceeds by `v > 0` and an inner profile `w` keeps by `r > 0` holds for `(1 - θ) x + θ w` as soon as
//! `θ >= v / (v + r)`; the box is convex. The code checks the result again and falls back to `w` itself.
//!
//! Dropped hypothesis: the room. With `r = 0` no `θ < 1` mends the row.

use slideway_baselines::time_optimal::{PieceProgram, repair};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop, exactly, worse};
use crate::random_program::{nonsense, random_path};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "repair-feasible",
    statement: "The repaired profile keeps every row and cap whatever the solver answered, nonsense included.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[Script { file: "repair-feasible.smt2", text: include_str!("../smt/repair-feasible.smt2") }],
    twins: &[Twin {
        without: "room",
        script: Script {
            file: "repair-feasible-without-room.smt2",
            text: include_str!("../smt/repair-feasible-without-room.smt2"),
        },
    }],
    engines: &[Engine {
        name: "repaired_nonsense_is_feasible",
        unit: "share of a limit",
        about: About::Other,
        cost: Cost::Run,
        trial: repaired_is_feasible,
    }],
};

/// No slack: rows are re-checked with outward rounding.
fn repaired_is_feasible(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let path = random_path(choices);
    let program = PieceProgram::new(&path, 0).map_err(|_| Stop::Skipped)?;
    let sane = choices.flag();
    let answer: Vec<f64> = program
        .cap
        .iter()
        .map(|cap| if sane { cap * choices.between(0.0, 1.5) } else { nonsense(choices, 2.0 * cap) })
        .collect();
    let profile = repair(&program, &answer).map_err(|_| Stop::Skipped)?;
    let inside = profile.iter().zip(&program.cap).all(|(x, cap)| 0.0 <= *x && x <= cap);
    // A program without rows has no excess.
    Ok(worse(exactly(inside && profile.len() == program.cap.len()), -program.largest_excess(&profile)))
}
