//! Claim `farkas`: a problem that has a profile is never proven to have none.
//!
//! Hypotheses: the profile keeps the program's rows and caps; at cusps of the path, where the joints nearly stand, the caps are lower than
//! the speed limits, and a path may then have a profile although its program is rightly refused. A refusal [`slideway_baselines::time_optimal::OptimumError::Infeasible`] with `proven` rests on multipliers `μ >= 0` with
//!
//! ```text
//! min over the box of (Aᵀμ)·x  >  μ·c      in outward-rounded arithmetic
//! ```
//!
//! Source: Farkas' lemma; the certificate's construction from the sweep is this project's.
//!
//! Derivation. A profile `x` in the box with `A x <= c` would have `(Aᵀμ)·x <= μ·c`, below the minimum over the box.
//!
//! Dropped hypothesis: that the multipliers are at least 0. The shipped check takes negative ones for 0.

use slideway_baselines::time_optimal::{OptimumError, PieceProgram};
use slideway_path::{EndRate, PathSample};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop, exactly};
use crate::random_program::path_of;
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "farkas",
    statement: "A problem for which a profile is known is never refused with a proof that it has none; multipliers >= 0 with min (Aᵀμ)x > μc exclude every profile of the box.",
    source: "Farkas' lemma",
    verdict: Verdict::Holds,
    negations: &[Script { file: "farkas.smt2", text: include_str!("../smt/farkas.smt2") }],
    twins: &[Twin {
        without: "signs",
        script: Script { file: "farkas-without-signs.smt2", text: include_str!("../smt/farkas-without-signs.smt2") },
    }],
    engines: &[Engine {
        name: "no_feasible_problem_is_proven_infeasible",
        unit: "yes or no",
        about: About::Other,
        cost: Cost::Run,
        trial: feasible_is_not_refused,
    }],
};

/// Limits are put around a random profile, from just enough (a part in 1e9: the rows are rounded) to ample. The ends are given, so
/// that the sweep has to find the way between them.
fn feasible_is_not_refused(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let nodes = 3 + choices.below(7);
    let (mut s, mut samples, mut b) = (0.0, Vec::new(), Vec::new());
    let ends = choices.share();
    for node in 0..nodes {
        s += choices.between(0.05, 0.5);
        let first = vec![choices.between(0.1, 1.0), choices.between(-1.0, 1.0)];
        let second = choices.numbers::<2>(-2.0, 2.0).to_vec();
        samples.push(PathSample { s, lambda: s, first, second, ..PathSample::default() });
        b.push(if node == 0 || node + 1 == nodes { ends * ends } else { choices.between(0.0, 2.0) });
    }
    let room = 1.0 + choices.pick([1e-9, 1e-3, 0.3]);
    let (mut speed, mut acceleration) = (vec![0.0_f64; 2], vec![0.0_f64; 2]);
    for k in 0..nodes - 1 {
        let pace = (b[k + 1] - b[k]) / (2.0 * (samples[k + 1].s - samples[k].s));
        for end in [k, k + 1] {
            for joint in 0..2 {
                let (first, second) = (samples[end].first[joint], samples[end].second[joint]);
                speed[joint] = speed[joint].max(first.abs() * b[end].sqrt());
                acceleration[joint] = acceleration[joint].max((first * pace + second * b[end]).abs());
            }
        }
    }
    let widened = |limits: Vec<f64>| -> Vec<f64> { limits.iter().map(|x| (x * room).max(1e-6)).collect() };
    let path = path_of(samples, widened(speed), Some(widened(acceleration)), EndRate::Given(ends));
    // At a cusp, where the joints nearly stand, the program's own caps are lower than the speed limits; it is the program that is
    // proven to have no profile.
    let program = PieceProgram::sampled(&path, 0, &[]).map_err(|_| Stop::Skipped)?;
    if b.iter().zip(&program.cap).any(|(b, cap)| !(b <= cap)) {
        return Err(Stop::Skipped);
    }
    let refused = matches!(PieceProgram::new(&path, 0), Err(OptimumError::Infeasible { proven: true, .. }));
    Ok(exactly(!refused))
}
