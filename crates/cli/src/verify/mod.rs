mod journal;
mod junit;
pub(crate) mod merge;
mod output;
mod page;
mod results;
pub(crate) mod shard;
mod table;
mod words;

use crate::args::{VerifyArguments, VerifyLevel};
use crate::keep::files;
use crate::keep::journal::Journal;
use crate::keep::parallel::{Work, jobs};
use crate::say::diagnostic::CliError;
use crate::say::failures::verify::VerifyFailure;
use crate::say::loaded::{load, scenario_error};
use crate::say::output::{Outcome, print_answer, print_json, tell};
use crate::verify::journal::{CampaignIdentity, Held, SmallestCase, TRIALS};
use crate::verify::output::Finished;
use crate::verify::results::{Results, first_failures};
use crate::verify::shard::{MAX_TRIALS, Shard};
use slideway_lab::in_parallel;
use slideway_scenario::AnyScenario;
use slideway_verify::{Campaign, CampaignRequest, Trial, VerifyError};
use std::fs;
use std::num::NonZeroUsize;
use std::path::Path;

/// Seed of the disturbances where neither the command nor the scenario gives one.
const SEED: u64 = 1;

/// States what is guaranteed and holds it against random trials.
pub(crate) fn run(arguments: &VerifyArguments) -> Result<Outcome, CliError> {
    let scenario = load(&arguments.scenario)?;
    let campaign = campaign(arguments, &scenario)?;
    let files = files::read(scenario.text(), &arguments.scenario)?;
    let name = scenario.name();
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("out").join(format!("verify-{name}")));
    fs::create_dir_all(&out).map_err(|source| CliError::Write { path: out.clone(), source })?;
    let identity = CampaignIdentity {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        scenario: name.to_owned(),
        text: scenario.text().to_owned(),
        files,
        method: arguments.method.clone(),
        seed: campaign.request().seed,
        trials: campaign.request().trials,
        shard: arguments.shard.unwrap_or(Shard::WHOLE),
        statement: campaign.statement().clone(),
    };
    let (journal, held) = journal::open(&out.join(TRIALS), &identity)?;
    if !arguments.json {
        tell(&table::statement(name, campaign.statement()))?;
    }
    let work = Campaigning { campaign: &campaign, scenario: &scenario, journal: &journal, file: &arguments.scenario };
    let (trials, smallest) = work.finish(&identity, held, jobs(arguments.jobs))?;
    let finished = Finished { identity: &identity, trials: &trials, smallest: &smallest };
    let results = finished.results();
    if identity.shard == Shard::WHOLE {
        finished.write_all(&results, &out)?;
        show(&results, &out, arguments.json)
    } else {
        finished.write_failing(&out)?;
        show_shard(&results, identity.shard, &out, arguments.json)
    }
}

/// Prints the results of a whole campaign, and what they mean for the exit status.
pub(crate) fn show(results: &Results, out: &Path, json: bool) -> Result<Outcome, CliError> {
    if json {
        print_json(results)?;
    } else {
        let whole = format!("{}wrote {}\n", table::results(results, out), out.join("report.html").display());
        print_answer(&whole, &table::verdict(results, out))?;
    }
    Ok(if results.holds { Outcome::Holds } else { Outcome::Fails })
}

fn show_shard(results: &Results, shard: Shard, out: &Path, json: bool) -> Result<Outcome, CliError> {
    if json {
        return show(results, out, json);
    }
    let next = format!(
        "wrote {}; once all {} shards have run, put them together with `slideway merge`\n",
        out.join(TRIALS).display(),
        shard.of()
    );
    print_answer(&format!("shard {shard}\n{}{next}", table::results(results, out)), &table::verdict(results, out))?;
    Ok(if results.holds { Outcome::Holds } else { Outcome::Fails })
}

fn campaign(arguments: &VerifyArguments, scenario: &AnyScenario) -> Result<Campaign, CliError> {
    let unusable = |error| scenario_error(error, &arguments.scenario, Some(scenario.text().to_owned()));
    let options = scenario.verify_options().map_err(unusable)?;
    let request = CampaignRequest {
        options,
        grid_points: scenario.grid_points(),
        seed: arguments.seed.or(options.seed).unwrap_or(SEED),
        trials: trials(arguments, options.trials)?,
    };
    let subject = scenario.subject(arguments.method.as_deref()).map_err(unusable)?;
    Campaign::new(subject, request).map_err(|error| pointed(error, None, &arguments.scenario, scenario.text()))
}

/// What the command asks for, else the scenario, else the quick level.
fn trials(arguments: &VerifyArguments, own: Option<u64>) -> Result<u64, CliError> {
    let asked = arguments.trials.or(arguments.level.map(VerifyLevel::trials)).or(own);
    let trials = asked.unwrap_or(VerifyLevel::Quick.trials());
    if (1..=MAX_TRIALS).contains(&trials) {
        Ok(trials)
    } else {
        Err(VerifyFailure::Trials { trials, most: MAX_TRIALS }.into())
    }
}

/// An error of the scenario points at its place in the text; others say in which trial they came up.
fn pointed(error: VerifyError, trial: Option<u64>, file: &str, text: &str) -> CliError {
    match (error, trial) {
        (VerifyError::Problem(error), None) => scenario_error(error, file, Some(text.to_owned())),
        (VerifyError::Optimum(error), None) => error.into(),
        (error, trial) => VerifyFailure::Trial { error: Box::new(error), trial, file: file.to_owned() }.into(),
    }
}

/// A campaign under way.
struct Campaigning<'a> {
    campaign: &'a Campaign,
    scenario: &'a AnyScenario,
    journal: &'a Journal,
    /// What the user called the scenario.
    file: &'a str,
}

impl Campaigning<'_> {
    /// Makes the trials and smallest cases that the journal does not hold yet; all of them, in order.
    fn finish(
        &self,
        identity: &CampaignIdentity,
        held: Held,
        jobs: NonZeroUsize,
    ) -> Result<(Vec<Trial>, Vec<SmallestCase>), CliError> {
        let Held { mut trials, smallest, .. } = held;
        let numbers: Vec<u64> = identity.shard.numbers(identity.trials).collect();
        let pending: Vec<(usize, u64)> =
            numbers.into_iter().enumerate().filter(|&(place, _)| trials[place].is_none()).collect();
        let work = Work { journal: self.journal, done: &trials, failed: |trial: &Trial| !trial.kept() };
        let made = work.finish(|sink| {
            in_parallel(&pending, jobs, |&(_, number)| {
                let trial = self.campaign.trial(number).map_err(|error| self.in_trial(error, number))?;
                sink(&trial)?;
                Ok::<_, CliError>(trial)
            })
        })?;
        for ((place, _), trial) in pending.into_iter().zip(made) {
            trials[place] = Some(trial);
        }
        let trials: Vec<Trial> = trials.into_iter().flatten().collect();
        let smallest = self.smallest(&trials, smallest)?;
        Ok((trials, smallest))
    }

    /// The smallest case of each violated guarantee, in the order of the trials.
    fn smallest(&self, trials: &[Trial], known: Vec<SmallestCase>) -> Result<Vec<SmallestCase>, CliError> {
        let one = |(guarantee, first): (String, &Trial)| {
            if let Some(case) = known.iter().find(|case| case.guarantee == guarantee) {
                return Ok(case.clone());
            }
            let in_trial = |error| self.in_trial(error, first.number);
            let found = self.campaign.smallest(first).map_err(in_trial)?;
            // A smaller case that fails in another way is no case of this guarantee.
            let fails = |trial: &Trial| trial.checks.iter().any(|c| c.guarantee == guarantee && !c.kept());
            let trial = if fails(&found) { found } else { first.clone() };
            let method = &self.campaign.statement().method;
            let text = self.scenario.of_trial(&trial, method, self.campaign.request().seed);
            let scenario = text.map_err(|error| scenario_error(error, self.file, None))?;
            let case = SmallestCase { guarantee, trial, scenario };
            self.journal.append(&case)?;
            Ok(case)
        };
        first_failures(trials).into_iter().map(one).collect()
    }

    fn in_trial(&self, error: VerifyError, trial: u64) -> CliError {
        pointed(error, Some(trial), self.file, self.scenario.text())
    }
}
