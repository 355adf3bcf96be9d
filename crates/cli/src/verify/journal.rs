//! `trials.jsonl`: the journal of a campaign, a line per trial, and after them a line per violated guarantee with its smallest
//! failing case.

use crate::keep::files::{self, NamedFiles};
use crate::keep::journal::{Identity, Journal, foreign, read_journal};
use crate::say::diagnostic::CliError;
use crate::say::failures::difference::Difference;
use crate::verify::shard::{MAX_TRIALS, Shard};
use serde::{Deserialize, Serialize};
use slideway_verify::{Statement, Trial};
use std::path::Path;

/// Name of the journal in a campaign's folder.
pub(crate) const TRIALS: &str = "trials.jsonl";

/// Everything that the trials depend on, with what is stated before them, and which of them are here.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct CampaignIdentity {
    pub(crate) version: String,
    pub(crate) scenario: String,
    pub(crate) text: String,
    pub(crate) files: NamedFiles,
    pub(crate) method: Option<String>,
    pub(crate) seed: u64,
    pub(crate) trials: u64,
    pub(crate) shard: Shard,
    pub(crate) statement: Statement,
}

/// The smallest case in which a guarantee fails, made from the first trial in which it does.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SmallestCase {
    pub(crate) guarantee: String,
    pub(crate) trial: Trial,
    /// A scenario that `slideway compare` runs.
    pub(crate) scenario: String,
}

/// One line after the first.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
enum Entry {
    Trial(Trial),
    Smallest(SmallestCase),
}

/// What a journal holds.
#[derive(Clone, Debug)]
pub(crate) struct Held {
    shard: Shard,
    count: u64,
    /// By place in the shard.
    pub(crate) trials: Vec<Option<Trial>>,
    pub(crate) smallest: Vec<SmallestCase>,
}

impl CampaignIdentity {
    /// The first thing in which two campaigns differ, whatever their shards.
    pub(crate) fn difference_of_campaigns(&self, now: &Self) -> Option<Difference> {
        let method = |method: &Option<String>| method.clone().unwrap_or_else(|| "not given".into());
        let [list_of_files, texts_of_files] = files::differences(&self.files, &now.files);
        Difference::first([
            ("version of the program", self.version.clone(), now.version.clone()),
            ("scenario", self.scenario.clone(), now.scenario.clone()),
            Difference::of_texts("scenario's text", &self.text, &now.text),
            list_of_files,
            texts_of_files,
            ("--method", method(&self.method), method(&now.method)),
            ("seed", self.seed.to_string(), now.seed.to_string()),
            ("number of trials", self.trials.to_string(), now.trials.to_string()),
            Difference::of_texts("statement", &in_lines(&self.statement), &in_lines(&now.statement)),
        ])
    }
}

/// A statement with a number a line; numbers that are none can be told apart, unlike by comparing them.
fn in_lines(statement: &Statement) -> String {
    serde_json::to_string_pretty(statement).unwrap_or_else(|error| error.to_string())
}

impl Identity for CampaignIdentity {
    const WRITER: &'static str = "campaign";

    fn difference(&self, now: &Self) -> Option<Difference> {
        let shards = || Difference::first([("shard", self.shard.to_string(), now.shard.to_string())]);
        self.difference_of_campaigns(now).or_else(shards)
    }
}

impl Held {
    fn nothing(shard: Shard, count: u64) -> Self {
        let trials = shard.numbers(count).map(|_| None).collect();
        Self { shard, count, trials, smallest: Vec::new() }
    }

    fn take(&mut self, entry: Entry) -> Result<(), String> {
        match entry {
            Entry::Smallest(case) => self.smallest.push(case),
            Entry::Trial(trial) => {
                let number = trial.number;
                let none = || format!("there is no trial {number} in shard {} of {} trials", self.shard, self.count);
                let slot = self.shard.place(number, self.count).and_then(|place| self.trials.get_mut(place));
                *slot.ok_or_else(none)? = Some(trial);
            }
        }
        Ok(())
    }
}

/// Opens the journal of a campaign, new or begun.
pub(crate) fn open(path: &Path, identity: &CampaignIdentity) -> Result<(Journal, Held), CliError> {
    let mut held = Held::nothing(identity.shard, identity.trials);
    let journal = Journal::open(path, identity, |entry| held.take(entry))?;
    Ok((journal, held))
}

/// Reads the journal of a shard.
pub(crate) fn read(path: &Path) -> Result<(CampaignIdentity, Held), CliError> {
    let mut entries = Vec::new();
    let identity: CampaignIdentity = read_journal(path, |entry: Entry| {
        entries.push(entry);
        Ok(())
    })?;
    let foreign = |line, reason| foreign::<CampaignIdentity>(path, line, reason);
    if identity.trials > MAX_TRIALS {
        return Err(foreign(1, format!("{} trials; {MAX_TRIALS} at most are possible", identity.trials)));
    }
    let mut held = Held::nothing(identity.shard, identity.trials);
    for (i, entry) in entries.into_iter().enumerate() {
        held.take(entry).map_err(|reason| foreign(i + 2, reason))?;
    }
    Ok((identity, held))
}
