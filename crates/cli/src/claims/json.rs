use serde::Serialize;
use slideway_proofs::ledger::{Entry, Measured, ProofStatus, SEED, verdict_in_words};

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

/// The ledger as JSON.
pub(crate) fn json(entries: &[Entry], proofs: &[ProofStatus]) -> String {
    let list: Vec<ClaimEntry> = entries.iter().zip(proofs).map(|(entry, proof)| claim_entry(entry, proof)).collect();
    // Strings and finite numbers: nothing that JSON cannot hold.
    serde_json::to_string_pretty(&list).map(|text| text + "\n").unwrap_or_default()
}

/// Whether a proof stands, in a word or two.
pub(crate) fn proof_in_words(status: &ProofStatus) -> &str {
    match status {
        ProofStatus::Proven => "proven",
        ProofStatus::Failed(_) => "FAILED",
        ProofStatus::Unchecked(_) => "no z3",
    }
}

fn claim_entry<'a>(entry: &'a Entry, proof: &'a ProofStatus) -> ClaimEntry<'a> {
    let property = |m: &'a Measured| PropertyEntry {
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
