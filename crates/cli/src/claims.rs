use crate::args::{ClaimsArguments, Level};
use crate::diagnostic::CliError;
use crate::loaded::edit_distance;
use crate::output::{Outcome, print};
use comfy_table::{ContentArrangement, Table, presets};
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use slideway_proofs::ledger::{
    Entry, NIGHTLY, ProofStatus, SEED, SMOKE, margin_in_words, markdown, prove, verdict_in_words,
};
use slideway_proofs::{CLAIMS, Claim};

/// Cases per property where nothing else is asked for.
const QUICK: u64 = 2_000;

pub(crate) fn run(arguments: &ClaimsArguments) -> Result<Outcome, CliError> {
    let level = match arguments.level {
        Level::Quick => QUICK,
        Level::Smoke => SMOKE,
        Level::Nightly => NIGHTLY,
    };
    let cases = arguments.cases.map_or(level, std::num::NonZeroU64::get);
    let entries = measured(&chosen(arguments.claim.as_deref())?, cases);
    let proofs: Vec<ProofStatus> = entries.iter().map(|entry| prove(entry.claim)).collect();
    if arguments.markdown {
        print(&markdown(&entries, cases));
    } else if arguments.json {
        print(&json(&entries, &proofs));
    } else {
        print(&table(&entries, &proofs));
    }
    violations(&entries);
    let holds = entries.iter().all(|entry| entry.violated().next().is_none());
    let proven = !proofs.iter().any(|status| matches!(status, ProofStatus::Failed(_)));
    Ok(if holds && proven { Outcome::Holds } else { Outcome::Fails })
}

/// All claims, or the one that is asked for.
pub(crate) fn chosen(name: Option<&str>) -> Result<Vec<&'static Claim>, CliError> {
    let Some(name) = name else { return Ok(CLAIMS.iter().collect()) };
    if let Some(claim) = CLAIMS.iter().find(|claim| claim.name == name) {
        return Ok(vec![claim]);
    }
    let nearest = CLAIMS.iter().map(|claim| (edit_distance(name, claim.name), claim.name)).min();
    let nearest = nearest.filter(|(distance, name)| 3 * distance <= name.len()).map(|(_, name)| name);
    Err(CliError::UnknownClaim { name: name.to_owned(), nearest })
}

/// A bar on the error stream, hidden where that is no terminal.
pub(crate) fn bar(length: u64) -> ProgressBar {
    let bar = ProgressBar::new(length);
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}") {
        bar.set_style(style);
    }
    bar
}

fn measured(claims: &[&'static Claim], cases: u64) -> Vec<Entry> {
    let bar = bar(claims.len() as u64);
    let entries = claims
        .iter()
        .map(|claim| {
            bar.set_message(claim.name);
            let entry = Entry::measure(claim, SEED, cases);
            bar.inc(1);
            entry
        })
        .collect();
    bar.finish_and_clear();
    entries
}

fn proof_in_words(status: &ProofStatus) -> &str {
    match status {
        ProofStatus::Proven => "proven",
        ProofStatus::Failed(_) => "FAILED",
        ProofStatus::Unchecked(_) => "no z3",
    }
}

fn table(entries: &[Entry], proofs: &[ProofStatus]) -> String {
    let mut table = Table::new();
    table.load_style(presets::UTF8_HORIZONTAL_ONLY).set_content_arrangement(ContentArrangement::Dynamic);
    table.set_header(["claim", "source", "its statement", "proof", "cases", "smallest margin"]);
    for (entry, proof) in entries.iter().zip(proofs) {
        let margins: Vec<String> = entry.measured.iter().map(|m| margin_in_words(m.report.smallest)).collect();
        let tried = if entry.measured.is_empty() { "tests only".to_owned() } else { entry.tried().to_string() };
        table.add_row([
            entry.claim.name,
            entry.claim.source,
            verdict_in_words(entry.claim.verdict),
            proof_in_words(proof),
            &tried,
            &margins.join("\n"),
        ]);
    }
    let mut text = format!("{table}\n");
    for (entry, proof) in entries.iter().zip(proofs) {
        if let ProofStatus::Failed(why) = proof {
            text.push_str(&format!("{}: {why}\n", entry.claim.name));
        }
    }
    if let Some(ProofStatus::Unchecked(why)) = proofs.iter().find(|p| matches!(p, ProofStatus::Unchecked(_))) {
        text.push_str(&format!("{why}\n"));
    }
    text
}

/// Violations go to the error stream, with what is needed to see them again.
fn violations(entries: &[Entry]) {
    for entry in entries {
        for measured in entry.violated() {
            if let Some(violation) = &measured.report.violation {
                eprintln!(
                    "{}, {}: violated by case {} of seed {SEED}: {}; choices {:?}",
                    entry.claim.name, measured.engine.name, violation.case, violation.what, violation.choices
                );
            }
        }
    }
}

#[derive(Serialize)]
struct ClaimEntry<'a> {
    name: &'a str,
    statement: &'a str,
    source: &'a str,
    verdict: &'a str,
    proof: &'a str,
    negations: Vec<&'a str>,
    twins: Vec<&'a str>,
    properties: Vec<PropertyEntry<'a>>,
}

#[derive(Serialize)]
struct PropertyEntry<'a> {
    name: &'a str,
    unit: &'a str,
    seed: u64,
    cases: u64,
    skipped: u64,
    /// Null where nothing is measured: the claim is exact.
    smallest_margin: Option<f64>,
    closest_case: u64,
    violation: Option<ViolationEntry<'a>>,
}

#[derive(Serialize)]
struct ViolationEntry<'a> {
    case: u64,
    what: &'a str,
    choices: &'a [f64],
}

fn json(entries: &[Entry], proofs: &[ProofStatus]) -> String {
    let list: Vec<ClaimEntry> = entries.iter().zip(proofs).map(|(entry, proof)| claim_entry(entry, proof)).collect();
    // Strings and finite numbers: nothing that JSON cannot hold.
    serde_json::to_string_pretty(&list).map(|text| text + "\n").unwrap_or_default()
}

fn claim_entry<'a>(entry: &'a Entry, proof: &'a ProofStatus) -> ClaimEntry<'a> {
    let property = |m: &'a slideway_proofs::ledger::Measured| PropertyEntry {
        name: m.engine.name,
        unit: m.engine.unit,
        seed: SEED,
        cases: m.report.tried,
        skipped: m.report.skipped,
        smallest_margin: m.report.smallest.is_finite().then_some(m.report.smallest),
        closest_case: m.report.closest,
        violation: m.report.violation.as_ref().map(|v| ViolationEntry {
            case: v.case,
            what: &v.what,
            choices: &v.choices,
        }),
    };
    ClaimEntry {
        name: entry.claim.name,
        statement: entry.claim.statement,
        source: entry.claim.source,
        verdict: verdict_in_words(entry.claim.verdict),
        proof: proof_in_words(proof),
        negations: entry.claim.negations.iter().map(|script| script.file).collect(),
        twins: entry.claim.twins.iter().map(|twin| twin.without).collect(),
        properties: entry.measured.iter().map(property).collect(),
    }
}
