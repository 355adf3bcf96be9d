use slideway_scenario::{NoKey, TuningError};
use slideway_verify::VerifyError;
use std::path::PathBuf;
use thiserror::Error;

/// Why a campaign cannot be run or put together.
#[derive(Debug, Error)]
pub(crate) enum VerifyFailure {
    /// A trial that cannot be made.
    #[error("{file}{}: {error}", trial.map_or(String::new(), |n| format!(", trial {n}")))]
    Trial { error: Box<VerifyError>, trial: Option<u64>, file: String },
    /// A number of trials that is not possible, in the scenario.
    #[error("{trials} trials; between 1 and {most} are possible")]
    Trials { trials: u64, most: u64 },
    /// Shards of different campaigns.
    #[error("{} and {} belong to different campaigns: the {what} is {one} there and {other} here", first.display(), second.display())]
    Strangers { first: PathBuf, second: PathBuf, what: &'static str, one: String, other: String },
    /// A trial that two shards hold.
    #[error("{} and {} both hold trial {number}", first.display(), second.display())]
    Twice { first: PathBuf, second: PathBuf, number: u64 },
    /// Trials that no shard holds.
    #[error("{missing} of {trials} trials are missing, the first of them {first}")]
    Missing { missing: u64, trials: u64, first: u64, shards: Vec<String> },
    /// A shard whose failing cases have not been made small.
    #[error("{} holds no smallest case of `{guarantee}`, which fails in its trial {number}", path.display())]
    Unfinished { path: PathBuf, guarantee: String, number: u64 },
}

impl VerifyFailure {
    pub(crate) fn remedy(&self) -> String {
        match self {
            Self::Trial { error, .. } => of_campaign(error),
            Self::Trials { .. } => "ask for fewer with --trials, or change `verify.trials` in the scenario".into(),
            Self::Strangers { .. } => {
                "merge shards of one campaign only: same scenario, method, seed, number of trials, version and kind of machine".into()
            }
            Self::Twice { .. } => "give each shard once, and all shards of one division".into(),
            Self::Missing { shards, .. } if shards.is_empty() => {
                "let every shard run to its end: give its command again, and it goes on where it stopped".into()
            }
            Self::Missing { shards, .. } => format!("give the folders of all shards; missing: {}", shards.join(", ")),
            Self::Unfinished { .. } => "let the shard run to its end: give its command again".into(),
        }
    }
}

/// What to do about a scenario that cannot be tuned.
pub(crate) fn of_tuning(error: &TuningError) -> String {
    match error {
        TuningError::Scenario(error) => error.remedy(),
        TuningError::Verify(error) => of_campaign(error),
        TuningError::NoKey(NoKey { key }) => {
            format!("give the scenario a value for `{key}`, for example from `slideway init`")
        }
    }
}

/// What to do about a problem that cannot be verified.
fn of_campaign(error: &VerifyError) -> String {
    match error {
        VerifyError::Problem(error) => error.remedy(),
        VerifyError::NoLimits => "give joint-speed limits below zero and above it".into(),
        VerifyError::Optimum(_) => {
            "give a path that avoids singular configurations, and limits that some motion keeps".into()
        }
        VerifyError::NoClaims { .. } => {
            "choose one of the conditioner's forms with `compare.method` or --method".into()
        }
        VerifyError::NotPositive { .. } => "give a positive finite number".into(),
        VerifyError::NoTrial { .. } => "ask for more trials with --trials".into(),
    }
}
