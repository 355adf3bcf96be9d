use std::collections::HashSet;
use std::path::Path;

use slideway_proofs::ledger::{broken, catches, refuted, row_head};
use slideway_proofs::refuted::REFUTED;
use slideway_proofs::subject::Fault;
use slideway_proofs::z3::{self, Z3Error};
use slideway_proofs::{CLAIMS, Script};

#[test]
fn every_claim_has_a_name_of_its_own_a_proof_a_twin_and_an_engine() {
    let names: HashSet<_> = CLAIMS.iter().map(|claim| claim.name).collect();
    assert_eq!(names.len(), CLAIMS.len());
    for claim in CLAIMS {
        assert!(!claim.negations.is_empty() && !claim.twins.is_empty() && !claim.engines.is_empty(), "{}", claim.name);
    }
}

#[test]
fn every_script_on_disk_belongs_to_a_claim() -> Result<(), std::io::Error> {
    let used: HashSet<&str> = CLAIMS
        .iter()
        .flat_map(|claim| claim.negations.iter().copied().chain(claim.twins.iter().map(|twin| twin.script)))
        .map(|script: Script| script.file)
        .collect();
    let mut kept = 0;
    for entry in std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("smt"))? {
        let name = entry?.file_name();
        assert!(name.to_str().is_some_and(|name| used.contains(name)), "{} proves nothing", name.display());
        kept += 1;
    }
    assert_eq!(kept, used.len());
    Ok(())
}

#[test]
fn a_missing_solver_is_an_error_that_names_the_remedy() {
    let answer = z3::run_program(Path::new("no-such-solver"), "(check-sat)");
    assert!(matches!(&answer, Err(Z3Error::Missing { .. })));
    let message = answer.map_or_else(|error| error.to_string(), |answer| format!("{answer:?}"));
    assert!(message.contains("apt-get install z3") && message.contains("pip install z3-solver"), "{message}");
}

#[test]
fn a_script_the_solver_refuses_is_an_error() {
    assert!(matches!(z3::run("(assert missing)\n(check-sat)\n"), Err(Z3Error::Script { .. })));
}

/// The columns that a run measures are checked where there is time for it, in `.ci/run`.
#[test]
fn the_ledger_in_the_repository_is_current() -> Result<(), std::io::Error> {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("CLAIMS.md"))?;
    let remedy = "write it again: slideway claims --level smoke --markdown > proofs/CLAIMS.md";
    for claim in CLAIMS {
        assert!(text.contains(&row_head(claim)), "{}: {remedy}", claim.name);
    }
    let (claims, _) = text.split_once("## Refuted").unwrap_or((&text, ""));
    assert_eq!(claims.lines().filter(|line| line.starts_with("| `")).count(), CLAIMS.len(), "{remedy}");
    assert!(text.contains(&refuted()) && text.contains(&broken()), "{remedy}");
    Ok(())
}

#[test]
fn every_broken_regulator_is_caught() {
    for fault in Fault::ALL {
        assert!(!catches(fault).is_empty(), "{}", fault.description());
    }
}

#[test]
fn every_refuted_statement_is_contradicted_by_the_shipped_code() {
    for refutation in REFUTED {
        // Far above the rounding of the two or four samples in each.
        assert!((refutation.excess)().is_ok_and(|excess| excess > 0.01), "{}", refutation.statement);
        assert!(CLAIMS.iter().any(|claim| claim.name == refutation.claim), "{}", refutation.claim);
    }
}
