use crate::args::AttackArguments;
use crate::claims::chosen;
use crate::say::diagnostic::CliError;
use crate::say::output::{Outcome, create, print_answer, progress};
use slideway_proofs::Claim;
use slideway_proofs::engine::{Attack, Engine, Found};
use slideway_proofs::kept::KeptCase;
use slideway_proofs::ledger::margin_in_words;
use slideway_proofs::subject::Subject;
use std::path::Path;
use std::time::Duration;

/// Moves between two restarts.
const RESTART: u32 = 2_000;

/// Longest search, a week: beyond it a duration may not be representable.
const LONGEST_MIN: f64 = 7.0 * 24.0 * 60.0;

pub(crate) fn run(arguments: &AttackArguments) -> Result<Outcome, CliError> {
    if !(arguments.minutes > 0.0 && arguments.minutes <= LONGEST_MIN) {
        let remedy = "choose a positive number of minutes, a week at most";
        return Err(CliError::Option { option: "minutes", value: arguments.minutes, remedy });
    }
    let claims = chosen(arguments.claim.as_deref())?;
    if let Some(out) = &arguments.out {
        std::fs::create_dir_all(out).map_err(|source| CliError::Write { path: out.clone(), source })?;
    }
    let engines: Vec<(&Claim, &Engine)> =
        claims.iter().flat_map(|claim| claim.engines.iter().map(|engine| (*claim, engine))).collect();
    let share = Duration::from_secs_f64(60.0 * arguments.minutes / engines.len().max(1) as f64);
    let attack = Attack { seed: arguments.seed, restart: RESTART, limit: share };
    let bar = progress(engines.len() as u64);
    let mut outcome = Outcome::Holds;
    for (claim, engine) in engines {
        let found = attack.run(engine, Subject::Shipped, |tried, margin| {
            bar.set_message(format!("{}: {tried} cases, margin {}", claim.name, margin_in_words(margin)));
        });
        bar.inc(1);
        let line = described(claim.name, engine, &found);
        bar.suspend(|| print_answer(&line, if found.violation.is_some() { &line } else { "" }))?;
        if let Some(out) = &arguments.out {
            write(out, &KeptCase::found(claim, engine, &found))?;
        }
        if found.violation.is_some() {
            outcome = Outcome::Fails;
        }
    }
    bar.finish_and_clear();
    Ok(outcome)
}

fn write(out: &Path, case: &KeptCase) -> Result<(), CliError> {
    create(out.join(case.file_name()), |file| {
        serde_json::to_writer_pretty(&mut *file, case)?;
        file.write_all(b"\n")
    })
}

fn described(claim: &str, engine: &Engine, found: &Found) -> String {
    let margin = margin_in_words(found.margin);
    let head = format!("{claim:24} {:64} {:>9} cases, margin {margin}\n", engine.name, found.tried);
    match &found.violation {
        None => head,
        Some(what) => format!("{head}  VIOLATED: {what}\n  choices: {:?}\n", found.choices),
    }
}
