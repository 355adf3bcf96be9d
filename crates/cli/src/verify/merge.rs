//! Shards of a campaign put together: the same files as of a campaign that ran in one piece.

use crate::args::MergeArguments;
use crate::say::diagnostic::CliError;
use crate::say::failures::verify::VerifyFailure;
use crate::say::output::Outcome;
use crate::verify::journal::{self, CampaignIdentity, Held, SmallestCase, TRIALS};
use crate::verify::output::Finished;
use crate::verify::results::first_failures;
use crate::verify::shard::Shard;
use crate::verify::show;
use slideway_verify::Trial;
use std::fs;
use std::path::{Path, PathBuf};

pub(crate) fn run(arguments: &MergeArguments) -> Result<Outcome, CliError> {
    let parts = arguments.shards.iter().map(|path| Part::read(path)).collect::<Result<Vec<_>, _>>()?;
    let identity = common(&parts)?;
    let trials = whole(&identity, &parts)?;
    let smallest = cases(&parts, &trials)?;
    let out = &arguments.out;
    fs::create_dir_all(out).map_err(|source| CliError::Write { path: out.clone(), source })?;
    let finished = Finished { identity: &identity, trials: &trials, smallest: &smallest };
    let results = finished.results();
    finished.write_all(&results, out)?;
    show(&results, out, arguments.json)
}

/// One journal.
struct Part {
    path: PathBuf,
    identity: CampaignIdentity,
    held: Held,
}

impl Part {
    fn read(path: &Path) -> Result<Self, CliError> {
        let path = if path.is_dir() { path.join(TRIALS) } else { path.to_owned() };
        let (identity, held) = journal::read(&path)?;
        Ok(Self { path, identity, held })
    }

    fn holds(&self, number: u64) -> Option<&Trial> {
        let place = self.identity.shard.place(number, self.identity.trials)?;
        self.held.trials.get(place)?.as_ref()
    }
}

/// The campaign that all parts belong to.
fn common(parts: &[Part]) -> Result<CampaignIdentity, CliError> {
    let Some((first, others)) = parts.split_first() else {
        return Err(VerifyFailure::Missing { missing: 0, trials: 0, first: 0, shards: Vec::new() }.into());
    };
    for other in others {
        if let Some(difference) = first.identity.difference_of_campaigns(&other.identity) {
            let (first, second) = (first.path.clone(), other.path.clone());
            let (what, one, other) = (difference.what, difference.was, difference.now);
            return Err(VerifyFailure::Strangers { first, second, what, one, other }.into());
        }
    }
    Ok(CampaignIdentity { shard: Shard::WHOLE, ..first.identity.clone() })
}

/// Every trial once, in order.
fn whole(identity: &CampaignIdentity, parts: &[Part]) -> Result<Vec<Trial>, CliError> {
    let (mut trials, mut missing) = (Vec::new(), Vec::new());
    for number in 0..identity.trials {
        let mut holders = parts.iter().filter_map(|part| Some((part, part.holds(number)?)));
        match (holders.next(), holders.next()) {
            (Some((first, _)), Some((second, _))) => {
                let (first, second) = (first.path.clone(), second.path.clone());
                return Err(VerifyFailure::Twice { first, second, number }.into());
            }
            (Some((_, trial)), None) => trials.push(trial.clone()),
            (None, _) => missing.push(number),
        }
    }
    match missing.first() {
        None => Ok(trials),
        Some(&first) => {
            let (missing, trials) = (missing.len() as u64, identity.trials);
            Err(VerifyFailure::Missing { missing, trials, first, shards: absent(parts) }.into())
        }
    }
}

/// The shards that were not given, where all that were are of one division.
fn absent(parts: &[Part]) -> Vec<String> {
    let given: Vec<Shard> = parts.iter().map(|part| part.identity.shard).collect();
    let of = given.first().map_or(1, |shard| shard.of());
    if given.iter().any(|shard| shard.of() != of) {
        return Vec::new();
    }
    // A division into more parts than anybody lists by hand is told by its number of trials alone.
    let all = (1..=of.min(1000)).filter_map(|index| Shard::new(index, of));
    all.filter(|shard| !given.contains(shard)).map(|shard| shard.to_string()).collect()
}

/// The smallest cases that the whole campaign would have made: each from the first trial of all that fails.
fn cases(parts: &[Part], trials: &[Trial]) -> Result<Vec<SmallestCase>, CliError> {
    let one = |(guarantee, first): (String, &Trial)| {
        let number = first.number;
        // Every number has its holder: the trials are complete.
        let part = parts.iter().find(|part| part.holds(number).is_some());
        let case = part.and_then(|part| part.held.smallest.iter().find(|case| case.guarantee == guarantee));
        case.cloned().ok_or_else(|| {
            let path = part.map_or_else(PathBuf::new, |part| part.path.clone());
            CliError::from(VerifyFailure::Unfinished { path, guarantee, number })
        })
    };
    first_failures(trials).into_iter().map(one).collect()
}
