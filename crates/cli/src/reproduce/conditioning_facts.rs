//! What the figures of `[G12]`'s examples 9.1 to 9.4 say in numbers.

use slideway_conditioner::path::{Reserve, TrapSettings, Walk};
use slideway_lab::conditioning::{ConditioningProblem, MarginChoice, PathMethod, PathMethodSummary, run_conditioner};
use slideway_lab::{Agreement, Published};
use slideway_path::{Fault, ProblemError};
use slideway_scenario::ConditioningScenario;
use slideway_scenario::{BUILT_IN, ScenarioError};
use std::num::NonZeroUsize;

const HALF_A_SECOND: &str = "read as about half a second: to 0.1 s";
const PAPER_WALK: &str = "with the paper's walk, one seed";
const SAFE_WALK: &str = "with the safe walk, the reserve and the margin, which the paper does not have";
const OWN_WALK: &str =
    "the paper shows one walk that keeps it; its own walk, without reserve and margin, does not with every seed";
const OWN_FORM: &str = "the same by the scheme of the paper's appendix";

/// Seeds with which the paper's walk is tried.
const SEEDS: u64 = 200;

pub(super) fn rows() -> Result<Vec<Published>, ScenarioError> {
    let mut rows = Vec::new();
    let helix = summary("helix-plane-sphere")?;
    rows.push(row("[G12] Fig. 4", "9.1", "both constraints active", "s", 0.5, helix.all_active_s, 0.1, HALF_A_SECOND));
    rows.push(yes("[G12] Fig. 3", "9.1", "both constraints kept (1 yes)", is_kept(&helix), ""));
    for (source, case, name) in [
        ("[G12] Fig. 6", "9.2", "trap-ellipsoid"),
        ("[G12] Fig. 8", "9.3", "trap-two-ellipsoids"),
        ("[G12] Fig. 10", "9.4", "trap-booth-oval"),
    ] {
        let trap = summary(name)?;
        let escaped = trap.completed && trap.escape_s.is_some();
        rows.push(yes(source, case, "trapped, and escapes (1 yes)", escaped, "one seed; all of 200 seeds escape"));
        let walk = if case == "9.4" { SAFE_WALK } else { PAPER_WALK };
        rows.push(yes(source, case, "constraints kept (1 yes)", is_kept(&trap), walk));
        if case == "9.3" {
            rows.push(yes(source, case, "both active during the walk (1 yes)", trap.all_active_s > 0.0, ""));
        }
    }
    for (method, remark) in [(PathMethod::SlidingMode, OWN_WALK), (PathMethod::SlidingModePaper, OWN_FORM)] {
        let broken = broken_by_the_papers_walk("trap-booth-oval", method)?;
        let quantity = "of 200 seeds, those that break the constraint with the paper's own walk";
        let known = row("[G12] Fig. 10", "9.4", quantity, "", 0.0, broken, 0.0, remark);
        rows.push(Published { case: format!("example 9.4, {method}"), expected: Agreement::Differs, ..known });
    }
    Ok(rows)
}

/// How many seeds break a constraint where the walk is the paper's, without what this implementation adds to it.
fn broken_by_the_papers_walk(name: &str, method: PathMethod) -> Result<f64, ScenarioError> {
    let problem = problem(name)?;
    let trap = problem.trap.ok_or_else(|| ScenarioError::value("trap", Fault::Missing("no trap avoidance")))?;
    let broken = |seed: u64| -> Result<bool, ProblemError> {
        let trap = Some(TrapSettings { walk: Walk::Paper, seed, ..trap });
        let problem =
            ConditioningProblem { trap, reserve: Reserve::Off, margin: MarginChoice::None, ..problem.clone() };
        let trace = run_conditioner(&problem, method)?;
        Ok(!is_kept(&PathMethodSummary::new(&problem, &trace, None, None)))
    };
    let threads = std::thread::available_parallelism().map_or(1, NonZeroUsize::get) as u64;
    let count =
        |first: u64| (first..=SEEDS).step_by(threads as usize).try_fold(0, |n, seed| Ok(n + u32::from(broken(seed)?)));
    let counts: Result<Vec<u32>, ProblemError> = std::thread::scope(|scope| {
        let started: Vec<_> = (1..=threads).map(|first| scope.spawn(move || count(first))).collect();
        started
            .into_iter()
            .map(|thread| thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
            .collect()
    });
    Ok(counts?.into_iter().map(f64::from).sum())
}

fn is_kept(summary: &PathMethodSummary) -> bool {
    summary.max_sigma_m.iter().all(|sigma| *sigma <= 0.0)
}

fn problem(name: &str) -> Result<ConditioningProblem, ScenarioError> {
    let missing = || ScenarioError::value("scenario", Fault::Missing("no built-in scenario of that name"));
    let text = BUILT_IN.iter().find(|b| b.name == name).ok_or_else(missing)?.text;
    ConditioningScenario::parse(name, text)?.problem()
}

fn summary(name: &str) -> Result<PathMethodSummary, ScenarioError> {
    let problem = problem(name)?;
    let trace = run_conditioner(&problem, PathMethod::SlidingMode)?;
    Ok(PathMethodSummary::new(&problem, &trace, None, None))
}

/// A row about a fact that is so or not.
fn yes(source: &'static str, case: &str, quantity: &'static str, is_so: bool, remark: &'static str) -> Published {
    row(source, case, quantity, "", 1.0, if is_so { 1.0 } else { 0.0 }, 0.0, remark)
}

#[allow(clippy::too_many_arguments)]
fn row(
    source: &'static str,
    case: &str,
    quantity: &'static str,
    unit: &'static str,
    paper: f64,
    ours: f64,
    tolerance: f64,
    remark: &'static str,
) -> Published {
    let (case, ours) = (format!("example {case}"), Some(ours));
    Published { source, case, quantity, unit, paper, ours, tolerance, expected: Agreement::Agrees, remark }
}
