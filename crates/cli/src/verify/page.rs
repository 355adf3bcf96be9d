//! The results as one page that opens from disk.

use crate::say::page::Page;
use crate::say::table::Table;
use crate::say::words::{escape, short};
use crate::verify::results::{GuaranteeResult, HypothesisResult, Results};
use crate::verify::words::{as_it_is, bound, failing, least, nearest, percent, with_unit};
use slideway_figures::Rendered;

pub(crate) fn render(results: &Results, text: &str, figures: &[Rendered]) -> String {
    let title = format!("What {} guarantees under {}", results.scenario, results.method);
    let description = format!(
        "{} trials around the scenario, each under disturbances of its own drawn from seed {}.",
        results.trials, results.seed
    );
    let page = Page {
        title: &title,
        description: &description,
        holds: results.holds,
        verdict: &results.verdict,
        body: failures(results) + &guarantees(results) + &hypotheses(results) + &remarks(results),
        figures,
        scenario: Some(text),
    };
    page.render()
}

/// A table whose rows have words below them.
fn table<const N: usize>(header: [&str; N], rows: impl Iterator<Item = ([String; N], String)>) -> String {
    let mut table = Table::new(header).numbers(2..N);
    for (cells, words) in rows {
        table.row(cells).words(words);
    }
    table.html()
}

fn hypotheses(results: &Results) -> String {
    if results.hypotheses.is_empty() {
        return String::new();
    }
    let outside = |name: &str| results.trials_outside.get(name).copied().unwrap_or(0).to_string();
    let row = |result: &HypothesisResult| {
        let h = &result.hypothesis;
        let numbers = [
            h.name.clone(),
            least(h),
            with_unit(h.value, &h.unit),
            percent(result.margin),
            if result.holds { "holds".into() } else { "fails".into() },
            outside(&h.name),
        ];
        (numbers, described(&h.text, &h.claim, h.remedy.as_deref()))
    };
    let header = ["hypothesis", "needs", "has", "margin", "", "trials outside"];
    format!("<h2>What the claims ask for</h2>\n{}", table(header, results.hypotheses.iter().map(row)))
}

/// What a hypothesis or guarantee says, the claim it belongs to, and what to do.
fn described(text: &str, claim: &str, remedy: Option<&str>) -> String {
    let remedy = remedy.map_or(String::new(), |remedy| format!("; remedy: {remedy}"));
    format!("{text} (claim {claim}){remedy}")
}

fn guarantees(results: &Results) -> String {
    if results.guarantees.is_empty() {
        return String::new();
    }
    let row = |g: &GuaranteeResult| {
        let stated = g.stated.as_ref();
        let numbers = [
            g.name.clone(),
            bound(g),
            as_it_is(stated),
            g.trials_checked.to_string(),
            nearest(g),
            g.violations.to_string(),
        ];
        (numbers, stated.map_or_else(|| "checked in each trial".to_owned(), |s| described(&s.text, &s.claim, None)))
    };
    let header = ["guarantee", "bound", "scenario as it is", "trials checked", "smallest margin", "violations"];
    let note = "<p class=\"note\">A margin is the distance from the bound as a share of its size. A trial outside a \
                hypothesis is not held against what rests on it.</p>\n";
    format!("<h2>What is guaranteed</h2>\n{}{note}", table(header, results.guarantees.iter().map(row)))
}

/// What is not guaranteed, and how the numbers were found; nothing if there is nothing to say.
fn remarks(results: &Results) -> String {
    let items: String = results.remarks.iter().map(|remark| format!("<li>{}</li>\n", escape(remark))).collect();
    if items.is_empty() { items } else { format!("<h2>Remarks</h2>\n<ul>{items}</ul>\n") }
}

/// The violated guarantees with their smallest cases; nothing if all were kept.
fn failures(results: &Results) -> String {
    let one = |g: &GuaranteeResult| {
        let lines: String = failing(g, results.seed).iter().map(|line| format!("<p>{}</p>\n", escape(line))).collect();
        lines + &g.failing.as_ref().map_or_else(String::new, |f| smallest(&f.smallest, &f.file))
    };
    let all: String = results.guarantees.iter().filter(|g| !g.kept()).map(one).collect();
    if all.is_empty() { all } else { format!("<h2>What was violated</h2>\n{all}") }
}

fn smallest(trial: &slideway_verify::Trial, file: &str) -> String {
    let disturbances = toml::to_string(&trial.disturbances).unwrap_or_default();
    let checks = trial
        .checks
        .iter()
        .filter(|check| !check.kept())
        .map(|check| format!("# {}: {}, bound {}\n", check.guarantee, short(check.measured), short(check.bound)));
    let checks: String = checks.collect();
    format!("<pre>{}</pre>\n", escape(&format!("# slideway compare {file}\n{checks}[disturbances]\n{disturbances}")))
}
