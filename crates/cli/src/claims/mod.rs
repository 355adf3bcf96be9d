pub(crate) mod attack;
mod json;
mod replay;
mod report;

use crate::args::{ClaimsArguments, Level};
use crate::claims::json::{json, proof_in_words};
use crate::claims::report::write_report;
use crate::say::diagnostic::{CliError, Named};
use crate::say::loudness::Loudness;
use crate::say::output::{Outcome, print, print_answer, print_error, progress};
use crate::say::table::Table;
use crate::say::words::nearest;
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
    if let Some(file) = &arguments.replay {
        return replay::file(file);
    }
    let claims = chosen(arguments.claim.as_deref())?;
    if let Some(case) = arguments.case {
        return replay::case(&claims, case);
    }
    let cases = arguments.cases.map_or(level, std::num::NonZeroU64::get);
    let entries = measured(&claims, cases);
    let proofs: Vec<ProofStatus> = entries.iter().map(|entry| prove(entry.claim)).collect();
    if arguments.markdown {
        print(&markdown(&entries, cases))?;
    } else if arguments.json {
        print(&json(&entries, &proofs))?;
    } else {
        print_answer(&table(&entries, &proofs), &failed_proofs(&entries, &proofs))?;
    }
    if let Some(out) = &arguments.out {
        let page = write_report(out, &entries, &proofs)?;
        if Loudness::chosen() != Loudness::Quiet {
            print_error(&format!("wrote {}", page.display()));
        }
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
    let nearest = nearest(name, CLAIMS.iter().map(|claim| claim.name));
    Err(CliError::Unknown { what: Named::Claim, name: name.to_owned(), nearest })
}

/// Runs every property, with a step of the bar for each and its cases beside it.
fn measured(claims: &[&'static Claim], cases: u64) -> Vec<Entry> {
    let bar = progress(claims.iter().map(|claim| claim.engines.len() as u64).sum());
    let mut entries = Vec::new();
    for claim in claims {
        let done = bar.position();
        let mut properties = 0;
        entries.push(Entry::measure(claim, SEED, cases, |engine, tried| {
            properties += u64::from(tried == 0);
            bar.set_position(done + properties - 1);
            bar.set_message(format!("{}: {tried} of {cases}, {}", claim.name, engine.name));
        }));
        bar.set_position(done + properties);
    }
    bar.finish_and_clear();
    entries
}

fn table(entries: &[Entry], proofs: &[ProofStatus]) -> String {
    let mut table = Table::new(["claim", "source", "its statement", "proof", "cases", "smallest margin"]);
    for (entry, proof) in entries.iter().zip(proofs) {
        let margins: Vec<String> = entry.measured.iter().map(|m| margin_in_words(m.report.smallest)).collect();
        table.row([
            entry.claim.name,
            entry.claim.source,
            verdict_in_words(entry.claim.verdict),
            proof_in_words(proof),
            &entry.tried().to_string(),
            &margins.join("\n"),
        ]);
    }
    let mut text = table.terminal() + "\n" + &failed_proofs(entries, proofs);
    if let Some(ProofStatus::Unchecked(why)) = proofs.iter().find(|p| matches!(p, ProofStatus::Unchecked(_))) {
        text.push_str(&format!("{why}\n"));
    }
    text
}

/// Proofs that do not go through, a line each.
fn failed_proofs(entries: &[Entry], proofs: &[ProofStatus]) -> String {
    let line = |(entry, proof): (&Entry, &ProofStatus)| match proof {
        ProofStatus::Failed(why) => Some(format!("{}: {why}\n", entry.claim.name)),
        _ => None,
    };
    entries.iter().zip(proofs).filter_map(line).collect()
}

/// Violations go to the error stream, with what is needed to see them again.
fn violations(entries: &[Entry]) {
    for entry in entries {
        for measured in entry.violated() {
            if let Some(violation) = &measured.report.violation {
                print_error(&format!(
                    "{name}, {}: violated by case {case} of seed {SEED}: {}; see it again with `slideway claims {name} --case {case}`",
                    measured.engine.name,
                    violation.what,
                    name = entry.claim.name,
                    case = violation.case
                ));
            }
        }
    }
}
