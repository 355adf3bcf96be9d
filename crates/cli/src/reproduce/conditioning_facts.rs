//! What the figures of `[G12]`'s examples 9.1 to 9.4 say in numbers.

use slideway_lab::conditioning::{PathMethod, PathMethodSummary, run_conditioner};
use slideway_lab::{Agreement, Published};
use slideway_path::Fault;
use slideway_scenario::ConditioningScenario;
use slideway_scenario::{BUILT_IN, ScenarioError};

const HALF_A_SECOND: &str = "read as about half a second: to 0.1 s";
const SAFE_WALK: &str =
    "with the safe walk; the paper's own walk breaks the constraint of 9.4 in 5 to 10 % of the seeds";

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
        rows.push(yes(source, case, "constraints kept (1 yes)", is_kept(&trap), SAFE_WALK));
        if case == "9.3" {
            rows.push(yes(source, case, "both active during the walk (1 yes)", trap.all_active_s > 0.0, ""));
        }
    }
    Ok(rows)
}

fn is_kept(summary: &PathMethodSummary) -> bool {
    summary.max_sigma_m.iter().all(|sigma| *sigma <= 0.0)
}

fn summary(name: &str) -> Result<PathMethodSummary, ScenarioError> {
    let missing = || ScenarioError::value("scenario", Fault::Missing("no built-in scenario of that name"));
    let text = BUILT_IN.iter().find(|b| b.name == name).ok_or_else(missing)?.text;
    let problem = ConditioningScenario::parse(name, text)?.problem()?;
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
