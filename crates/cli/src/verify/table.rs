//! The statement and the results for a terminal.

use crate::say::table::Table;
use crate::verify::results::{HypothesisResult, Results};
use crate::verify::words::{as_it_is, bound, failing, nearest, needed, percent, stated_bound};
use slideway_verify::Statement;
use std::path::Path;

/// What is known before any trial.
pub(crate) fn statement(scenario: &str, statement: &Statement) -> String {
    let mut hypotheses = Table::new(["hypothesis", "claim", "has; needs", "margin", ""]);
    for result in statement.hypotheses.iter().map(HypothesisResult::new) {
        let h = &result.hypothesis;
        let holds = if result.holds { "holds" } else { "FAILS" };
        hypotheses.row([h.name.clone(), h.claim.clone(), needed(h), percent(result.margin), holds.to_owned()]);
    }
    let mut guarantees = Table::new(["guarantee", "claim", "bound", "in the scenario as it is"]);
    for g in &statement.guarantees {
        guarantees.row([g.name.clone(), g.claim.clone(), stated_bound(g), as_it_is(Some(g))]);
    }
    let remarks: String = statement.remarks.iter().map(|remark| format!("note: {remark}\n")).collect();
    format!(
        "{scenario} - {}\n{}{}{remarks}",
        statement.method,
        hypotheses.terminal_if_any(),
        guarantees.terminal_if_any()
    )
}

/// What the trials came to, with the verdict.
pub(crate) fn results(results: &Results, out: &Path) -> String {
    let mut guarantees = Table::new(["guarantee", "bound", "trials checked", "smallest margin", "violations"]);
    for g in &results.guarantees {
        let counts = [g.trials_checked.to_string(), nearest(g), g.violations.to_string()];
        guarantees.row([g.name.clone(), bound(g)].into_iter().chain(counts));
    }
    let mut text = guarantees.terminal_if_any();
    for (name, trials) in &results.trials_outside {
        text += &format!("{trials} of {} trials lie outside the hypothesis {name}\n", results.trials);
    }
    text + &verdict(results, out)
}

/// The verdict, and the commands that run the failing cases.
pub(crate) fn verdict(results: &Results, out: &Path) -> String {
    let mut text = format!("{}\n", results.verdict);
    for g in results.guarantees.iter().filter(|g| !g.kept()) {
        text += &format!("\n{}\n", failing(g, results.seed).join("\n"));
        if let Some(failing) = &g.failing {
            text += &format!("  slideway compare {}\n", out.join(&failing.file).display());
            for name in &results.files_elsewhere {
                text += &format!(
                    "  it names {name}, which lies outside its folder: put it where that leads from {}\n",
                    out.display()
                );
            }
        }
    }
    text
}
