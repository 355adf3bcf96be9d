//! The statement and the results for a terminal.

use crate::output::new_table;
use crate::verify_results::{HypothesisResult, Results};
use crate::verify_words::{as_it_is, bound, failing, nearest, needed, percent, stated_bound};
use comfy_table::Table;
use slideway_verify::Statement;
use std::path::Path;

/// What is known before any trial.
pub(crate) fn statement(scenario: &str, statement: &Statement) -> String {
    let mut hypotheses = table(&["hypothesis", "claim", "has; needs", "margin", ""]);
    for result in statement.hypotheses.iter().map(HypothesisResult::new) {
        let h = &result.hypothesis;
        let holds = if result.holds { "holds" } else { "FAILS" };
        hypotheses.add_row([&h.name, &h.claim, &needed(h), &percent(result.margin), holds]);
    }
    let mut guarantees = table(&["guarantee", "claim", "bound", "in the scenario as it is"]);
    for g in &statement.guarantees {
        guarantees.add_row([g.name.clone(), g.claim.clone(), stated_bound(g), as_it_is(Some(g))]);
    }
    let remarks: String = statement.remarks.iter().map(|remark| format!("note: {remark}\n")).collect();
    format!("{scenario} - {}\n{}{}{remarks}", statement.method, shown(&hypotheses), shown(&guarantees))
}

/// What the trials came to, and the commands that run the failing cases.
pub(crate) fn results(results: &Results, out: &Path) -> String {
    let mut guarantees = table(&["guarantee", "bound", "trials checked", "smallest margin", "violations"]);
    for g in &results.guarantees {
        let counts = [g.trials_checked.to_string(), nearest(g), g.violations.to_string()];
        guarantees.add_row([g.name.clone(), bound(g)].into_iter().chain(counts));
    }
    let mut text = shown(&guarantees);
    for (name, trials) in &results.trials_outside {
        text += &format!("{trials} of {} trials lie outside the hypothesis {name}\n", results.trials);
    }
    text += &format!("{}\n", results.verdict);
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

fn table(header: &[&str]) -> Table {
    let mut table = new_table();
    table.set_header(header);
    table
}

/// A table without rows is not shown.
fn shown(table: &Table) -> String {
    if table.row_count() == 0 { String::new() } else { format!("{table}\n") }
}
