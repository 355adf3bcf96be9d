use crate::say::diagnostic::CliError;
use crate::say::output::{Outcome, print};
use slideway_proofs::Claim;
use slideway_proofs::engine::{Choices, Stop};
use slideway_proofs::kept::{KeptCase, Replayed};
use slideway_proofs::ledger::{SEED, margin_in_words};
use std::path::Path;

/// Replays a case that was written down.
pub(crate) fn file(path: &Path) -> Result<Outcome, CliError> {
    let failed = |error| CliError::Kept { path: path.to_owned(), error };
    let kept = KeptCase::read(path).map_err(failed)?;
    let outcome = shown(&kept.replay().map_err(failed)?)?;
    print(&kept.margin.map_or_else(String::new, |margin| format!("written   with a margin of {margin:e}\n")))?;
    Ok(outcome)
}

/// Replays a case of the ledger's own sequence, with every property of the claims.
pub(crate) fn case(claims: &[&'static Claim], case: u64) -> Result<Outcome, CliError> {
    let properties = claims.iter().flat_map(|claim| claim.engines.iter().map(move |engine| (*claim, engine)));
    let mut outcome = Outcome::Holds;
    for (claim, engine) in properties {
        if shown(&Replayed::run(claim, engine, Choices::random(SEED, case)))? == Outcome::Fails {
            outcome = Outcome::Fails;
        }
        print("\n")?;
    }
    Ok(outcome)
}

fn shown(replayed: &Replayed) -> Result<Outcome, CliError> {
    let (margin, verdict, outcome) = match &replayed.outcome {
        Ok(margin) if *margin >= 0.0 => (described(*margin, replayed.engine.unit), "holds".to_owned(), Outcome::Holds),
        Ok(margin) => (described(*margin, replayed.engine.unit), "VIOLATED".to_owned(), Outcome::Fails),
        Err(Stop::Skipped) => ("none".to_owned(), "does not meet the hypotheses".to_owned(), Outcome::Holds),
        Err(Stop::Refused(why)) => ("none".to_owned(), format!("VIOLATED: {why}"), Outcome::Fails),
    };
    print(&format!(
        "claim     {}\nstatement {}\nproperty  {}\nchoices   {:?}\nmargin    {margin}\nverdict   {verdict}\n",
        replayed.claim.name, replayed.claim.statement, replayed.engine.name, replayed.used
    ))?;
    Ok(outcome)
}

/// All digits, and in words where they say more.
fn described(margin: f64, unit: &str) -> String {
    match margin_in_words(margin).as_str() {
        words @ ("exact" | "reached") if margin.is_finite() => format!("{margin:e} ({unit}): {words}"),
        "exact" => "exact: nothing is measured".to_owned(),
        _ => format!("{margin:e} ({unit})"),
    }
}
