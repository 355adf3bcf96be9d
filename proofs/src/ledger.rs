//! The ledger: every claim with what a run of its engines measured, as Markdown.

use std::fmt::Write as _;

use crate::CLAIMS;
use crate::claim::{Claim, Verdict};
use crate::engine::{About, Engine, Report, campaign};
use crate::refuted::REFUTED;
use crate::subject::{Fault, Subject};
use crate::z3::{self, Answer, Z3Error};

/// Cases per engine at the level that every change must pass.
pub const SMOKE: u64 = 100_000;

/// Cases per engine at night.
pub const NIGHTLY: u64 = 10_000_000;

/// Seed of the ledger's own run.
pub const SEED: u64 = 1;

/// Cases within which a broken regulator has to be caught.
pub const CATCH: u64 = 1_000;

/// An engine and what it measured.
#[derive(Clone, Debug)]
pub struct Measured {
    /// The engine.
    pub engine: &'static Engine,
    /// Its report.
    pub report: Report,
}

/// A claim and what its engines measured.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The claim.
    pub claim: &'static Claim,
    /// Engine by engine.
    pub measured: Vec<Measured>,
}

impl Entry {
    /// Runs every engine of a claim on the shipped code; `progress` is told which one, and how many cases it has tried.
    #[must_use]
    pub fn measure(claim: &'static Claim, seed: u64, cases: u64, mut progress: impl FnMut(&Engine, u64)) -> Self {
        let mut measured = Vec::new();
        for engine in claim.engines {
            progress(engine, 0);
            let report = campaign(engine, Subject::Shipped, seed, cases, |tried| progress(engine, tried));
            measured.push(Measured { engine, report });
        }
        Self { claim, measured }
    }

    /// Cases tried, all engines together.
    #[must_use]
    pub fn tried(&self) -> u64 {
        self.measured.iter().map(|m| m.report.tried).sum()
    }

    /// The smallest margin of every engine, with its unit where there is something to count in it.
    #[must_use]
    pub fn margins_in_words(&self) -> String {
        let one =
            |m: &Measured| format!("{} {}", margin_in_words(m.report.smallest), unit_in_words(m)).trim().to_owned();
        self.measured.iter().map(one).collect::<Vec<_>>().join("; ")
    }

    /// The engines with a violation.
    pub fn violated(&self) -> impl Iterator<Item = &Measured> {
        self.measured.iter().filter(|m| m.report.violation.is_some())
    }
}

/// A margin in words: what is below 1e-9 is rounding, the bound was reached.
#[must_use]
pub fn margin_in_words(margin: f64) -> String {
    match margin {
        m if m == f64::INFINITY => "exact".to_owned(),
        m if (0.0..1e-9).contains(&m) => "reached".to_owned(),
        m => format!("{m:.1e}"),
    }
}

/// Status of the proof of a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ProofStatus {
    /// Every negation is unsatisfiable, every twin satisfiable.
    Proven,
    /// A script has another answer than it should.
    Failed(String),
    /// There was no solver to ask.
    Unchecked(String),
}

/// Hands every script of a claim to z3.
#[must_use]
pub fn prove(claim: &Claim) -> ProofStatus {
    let negations = claim.negations.iter().map(|script| (*script, true));
    let twins = claim.twins.iter().map(|twin| (twin.script, false));
    for (script, impossible) in negations.chain(twins) {
        match z3::run(script.text) {
            Ok(Answer::Unsat) if impossible => {}
            Ok(Answer::Sat(_)) if !impossible => {}
            Ok(other) => return ProofStatus::Failed(format!("{}: {other:?}", script.file)),
            Err(error @ Z3Error::Missing { .. }) => return ProofStatus::Unchecked(error.to_string()),
            Err(error) => return ProofStatus::Failed(format!("{}: {error}", script.file)),
        }
    }
    ProofStatus::Proven
}

/// Engines that catch a broken regulator within [`CATCH`] cases: claim, engine, and the first case that does.
#[must_use]
pub fn catches(fault: Fault) -> Vec<Catch> {
    let engines = CLAIMS.iter().flat_map(|claim| claim.engines.iter().map(move |engine| (claim.name, engine)));
    engines
        .filter(|(_, engine)| engine.about == About::SpeedRegulator)
        .filter_map(|(claim, engine)| {
            let report = campaign(engine, Subject::Broken(fault), SEED, CATCH, |_| ());
            report.violation.map(|violation| Catch { claim, engine: engine.name, case: violation.case })
        })
        .collect()
}

/// A broken regulator caught.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Catch {
    /// The claim that is violated.
    pub claim: &'static str,
    /// The engine that found out.
    pub engine: &'static str,
    /// Its first violating case.
    pub case: u64,
}

/// Words for the verdict on the source's statement.
#[must_use]
pub fn verdict_in_words(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Holds => "holds",
        Verdict::HoldsWithCorrection => "holds with correction",
        Verdict::Refuted => "refuted",
        Verdict::Ours => "none; ours",
    }
}

fn scripts_in_words(claim: &Claim) -> String {
    let twins: Vec<&str> = claim.twins.iter().map(|twin| twin.without).collect();
    format!("{} unsat; sat without {}", claim.negations.len(), twins.join(", "))
}

/// Everything `proofs/CLAIMS.md` says that does not depend on a run, claim by claim. A `|` in a statement would end a cell.
#[must_use]
pub fn row_head(claim: &Claim) -> String {
    let cell = |text: &str| text.replace('|', "\\|");
    format!(
        "| `{}` | {} | {} | {} | {} |",
        claim.name,
        cell(claim.statement),
        cell(claim.source),
        verdict_in_words(claim.verdict),
        scripts_in_words(claim)
    )
}

/// The ledger as Markdown.
#[must_use]
pub fn markdown(entries: &[Entry], cases: u64) -> String {
    let mut text = format!(
        "# Claims\n\nGenerated by `slideway claims --markdown`; the tests and `.ci/run` check that it is current. The derivations are in the \
         documentation of `proofs/src`, one module a claim.\n\n\
         *Proof*: scripts that z3 must find unsatisfiable (the negated claim), and the hypotheses each of which, dropped, must leave a \
         counterexample. *Cases*: random cases that met the hypotheses, seed {SEED}, {cases} for every property. *Margin*: the smallest distance \
         from the bound, slack for rounding included; `reached` is below 1e-9, `exact` a claim that holds to the last bit or not at all. \
         `regressions` keeps the closest case that a search of a minute a claim has found (`slideway attack`); the tests replay them.\n\n\
         | claim | statement | source | the source's statement | proof | cases | margin |\n|---|---|---|---|---|---|---|\n"
    );
    for entry in entries {
        let _ = writeln!(text, "{} {} | {} |", row_head(entry.claim), entry.tried(), entry.margins_in_words());
    }
    text.push_str(&refuted());
    text.push_str(&broken());
    text
}

fn unit_in_words(measured: &Measured) -> &'static str {
    let plain =
        measured.report.smallest < 1e-9 || measured.report.smallest == f64::INFINITY || measured.engine.unit == "1";
    if plain { "" } else { measured.engine.unit }
}

/// The statements that do not hold as printed, each with its smallest counterexample, replayed on the shipped code.
#[must_use]
pub fn refuted() -> String {
    let mut text = "\n## Refuted as printed\n\n| statement | source | counterexample | said | found | what holds | run |\n|---|---|---|---|---|---|---|\n".to_owned();
    for refutation in REFUTED {
        let found = (refutation.replay)().map_or_else(|stop| format!("{stop:?}"), |found| format!("{found:.4}"));
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {found} | `{claim}` | [figure](figures/{claim}/counterexample.svg) |",
            refutation.statement.replace('|', "\\|"),
            refutation.source,
            refutation.numbers,
            refutation.said,
            claim = refutation.claim
        );
    }
    text
}

/// The broken regulators and who catches them.
#[must_use]
pub fn broken() -> String {
    let mut text = format!(
        "\n## Broken on purpose\n\nEach of these regulators makes one mistake; the claims that notice it within {CATCH} cases, with the first case \
         that does.\n\n| mistake | caught by |\n|---|---|\n"
    );
    for fault in Fault::ALL {
        let mut caught: Vec<(&str, u64)> = Vec::new();
        for found in catches(fault) {
            match caught.iter_mut().find(|(claim, _)| *claim == found.claim) {
                Some((_, case)) => *case = found.case.min(*case),
                None => caught.push((found.claim, found.case)),
            }
        }
        let names: Vec<String> = caught.iter().map(|(claim, case)| format!("`{claim}` ({case})")).collect();
        let _ = writeln!(text, "| {} | {} |", fault.description(), names.join(", "));
    }
    text
}
