use crate::claims::json::{json, proof_in_words};
use crate::say::diagnostic::CliError;
use crate::say::output::{create, withdraw};
use crate::say::page::Page;
use crate::say::table::Table;
use slideway_figures::{Counterexample, FigureError, Rendered, draw_counterexample};
use slideway_proofs::ledger::{Entry, ProofStatus, verdict_in_words};
use slideway_proofs::refuted::{REFUTED, Refutation};
use std::fs;
use std::path::{Path, PathBuf};

/// Writes `claims.json`, a page, and a figure for every statement that does not hold and that one of the claims replaces.
pub(crate) fn write_report(out: &Path, entries: &[Entry], proofs: &[ProofStatus]) -> Result<PathBuf, CliError> {
    let dir = out.join("figures");
    withdraw(&out.join("claims.json"))?;
    fs::create_dir_all(&dir).map_err(|source| CliError::Write { path: dir.clone(), source })?;
    let refuted = REFUTED.iter().filter(|r| entries.iter().any(|entry| entry.claim.name == r.claim));
    let figures = refuted.map(|r| drawn(r, &dir)).collect::<Result<Vec<_>, _>>()?;
    let page = out.join("report.html");
    create(page.clone(), |file| file.write_all(rendered(entries, proofs, &figures).as_bytes()))?;
    create(out.join("claims.json"), |file| file.write_all(json(entries, proofs).as_bytes()))?;
    Ok(page)
}

/// The run of a counterexample, in a folder of the name of the claim that holds instead.
fn drawn(refutation: &Refutation, dir: &Path) -> Result<Rendered, CliError> {
    let run = (refutation.run)().map_err(|_| FigureError::NoTraces)?;
    let example = Counterexample {
        title: &format!("Refuted: {}", refutation.source.replace('`', "")),
        message: run.seen,
        quantity: run.quantity,
        saying: run.saying,
        said: &run.said,
        found: &run.found,
    };
    Ok(draw_counterexample(&example, &dir.join(refutation.claim))?)
}

fn rendered(entries: &[Entry], proofs: &[ProofStatus], figures: &[Rendered]) -> String {
    let header = ["claim", "statement", "source", "the source's statement", "proof", "cases", "smallest margin"];
    let mut table = Table::new(header);
    for (entry, proof) in entries.iter().zip(proofs) {
        table.row(cells(entry, proof));
    }
    let violated: Vec<&str> = entries.iter().filter(|e| e.violated().next().is_some()).map(|e| e.claim.name).collect();
    let failed = proofs.iter().filter(|proof| matches!(proof, ProofStatus::Failed(_))).count();
    let holds = violated.is_empty() && failed == 0;
    let verdict = if holds {
        format!("No violation in {} cases.", entries.iter().map(Entry::tried).sum::<u64>())
    } else {
        format!("Violated: {}. Proofs that fail: {failed}.", violated.join(", "))
    };
    let page = Page {
        title: "Claims",
        description: "What is claimed, what of it is proven, and what random cases on the shipped code measured.",
        holds,
        verdict: &verdict,
        body: table.html(),
        figures,
        scenario: None,
    };
    page.render()
}

fn cells(entry: &Entry, proof: &ProofStatus) -> [String; 7] {
    [
        entry.claim.name.to_owned(),
        entry.claim.statement.to_owned(),
        entry.claim.source.to_owned(),
        verdict_in_words(entry.claim.verdict).to_owned(),
        proof_in_words(proof).to_owned(),
        entry.tried().to_string(),
        entry.margins_in_words(),
    ]
}
