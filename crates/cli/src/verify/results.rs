use crate::keep::files::is_beside;
use crate::verify::journal::{CampaignIdentity, SmallestCase};
use crate::verify::shard::Shard;
use serde::Serialize;
use slideway_verify::{Check, Guarantee, Hypothesis, Trial, number};
use std::collections::BTreeMap;

/// What a campaign came to: a function of the campaign and its trials, so neither of time nor of threads nor of shards.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Results {
    pub(crate) scenario: String,
    pub(crate) method: String,
    pub(crate) seed: u64,
    pub(crate) trials: u64,
    /// Which share of the trials this is about; missing where it is all of them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) shard: Option<Shard>,
    /// Whether every hypothesis holds, every guarantee was kept and at least one was checked.
    pub(crate) holds: bool,
    pub(crate) verdict: String,
    pub(crate) hypotheses: Vec<HypothesisResult>,
    pub(crate) guarantees: Vec<GuaranteeResult>,
    /// What is not guaranteed, and how the numbers were found.
    pub(crate) remarks: Vec<String>,
    /// Trials outside a hypothesis, by its name; those of guarantees that rest on it were not checked there.
    pub(crate) trials_outside: BTreeMap<String, u64>,
    /// Files that the scenario names outside its folder: failing cases need them where they are.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) files_elsewhere: Vec<String>,
}

/// A hypothesis with what follows from its numbers.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct HypothesisResult {
    #[serde(flatten)]
    pub(crate) hypothesis: Hypothesis,
    pub(crate) holds: bool,
    /// Distance from what is needed as a share of it (as it is where nothing is needed); negative where it fails.
    #[serde(with = "number")]
    pub(crate) margin: f64,
}

/// A guarantee in the scenario as it is and in the trials.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct GuaranteeResult {
    pub(crate) name: String,
    pub(crate) unit: String,
    /// What was stated before the trials; null for a guarantee whose bound is each trial's own.
    pub(crate) stated: Option<Guarantee>,
    /// Whether the scenario as it is keeps it; null where it has no such value.
    pub(crate) kept_without_disturbances: Option<bool>,
    pub(crate) trials_checked: u64,
    pub(crate) violations: u64,
    /// The trial with the smallest margin.
    pub(crate) nearest: Option<Measured>,
    /// The first trial in which it failed, with its smallest case.
    pub(crate) failing: Option<Failing>,
}

/// A check and the trial it belongs to.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Measured {
    pub(crate) trial: u64,
    #[serde(with = "number")]
    pub(crate) size: f64,
    #[serde(with = "number")]
    pub(crate) measured: f64,
    #[serde(with = "number")]
    pub(crate) bound: f64,
    #[serde(with = "number")]
    pub(crate) margin: f64,
}

/// A trial in which a guarantee failed.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Failing {
    #[serde(flatten)]
    pub(crate) first: Measured,
    /// The same trial made as small as it can be while it still fails.
    pub(crate) smallest: Trial,
    /// The scenario that gives it, beside the results.
    pub(crate) file: String,
}

impl Results {
    pub(crate) fn new(identity: &CampaignIdentity, trials: &[Trial], smallest: &[SmallestCase]) -> Self {
        let statement = &identity.statement;
        let hypotheses: Vec<_> = statement.hypotheses.iter().map(HypothesisResult::new).collect();
        let names = names(&statement.guarantees, trials);
        let guarantees: Vec<_> =
            names.iter().map(|name| GuaranteeResult::new(name, &statement.guarantees, trials, smallest)).collect();
        let mut trials_outside = BTreeMap::new();
        for name in trials.iter().flat_map(|trial| &trial.outside) {
            *trials_outside.entry(name.clone()).or_insert(0) += 1;
        }
        let mut results = Self {
            scenario: identity.scenario.clone(),
            method: statement.method.clone(),
            seed: identity.seed,
            trials: trials.len() as u64,
            shard: Some(identity.shard).filter(|shard| *shard != Shard::WHOLE),
            holds: hypotheses.iter().all(|h| h.holds)
                && guarantees.iter().all(GuaranteeResult::kept)
                && guarantees.iter().any(GuaranteeResult::checked),
            verdict: String::new(),
            hypotheses,
            guarantees,
            remarks: statement.remarks.clone(),
            trials_outside,
            files_elsewhere: identity.files.keys().filter(|name| !is_beside(name)).cloned().collect(),
        };
        results.verdict = results.sentence();
        results
    }

    /// Whether any guarantee was held against anything.
    pub(crate) fn checked(&self) -> bool {
        self.guarantees.iter().any(GuaranteeResult::checked)
    }

    /// The verdict in words.
    fn sentence(&self) -> String {
        let failed: Vec<String> =
            self.hypotheses.iter().filter(|h| !h.holds).map(HypothesisResult::complaint).collect();
        let violated: Vec<String> =
            self.guarantees.iter().filter(|g| !g.kept()).map(|g| g.complaint(self.trials)).collect();
        let complaints: Vec<String> = failed.into_iter().chain(violated).collect();
        if !complaints.is_empty() {
            return format!("No: {}.", complaints.join("; "));
        }
        let unchecked: Vec<&str> = self.guarantees.iter().filter(|g| !g.checked()).map(|g| g.name.as_str()).collect();
        if unchecked.len() == self.guarantees.len() {
            return "No: no guarantee was checked.".to_owned();
        }
        let checks: u64 = self.guarantees.iter().map(|g| g.trials_checked).sum();
        let rest =
            if unchecked.is_empty() { String::new() } else { format!("; never checked: {}", unchecked.join(", ")) };
        format!(
            "Yes: every hypothesis holds, and every guarantee was kept in the scenario as it is and in {} trials \
             ({checks} checks){rest}.",
            self.trials
        )
    }
}

impl HypothesisResult {
    pub(crate) fn new(hypothesis: &Hypothesis) -> Self {
        Self { holds: hypothesis.holds(), margin: hypothesis.margin(), hypothesis: hypothesis.clone() }
    }

    /// What is wrong and what to do, for one that fails.
    fn complaint(&self) -> String {
        let remedy = self.hypothesis.remedy.as_ref().map_or(String::new(), |remedy| format!(" ({remedy})"));
        format!("the hypothesis {} fails{remedy}", self.hypothesis.name)
    }
}

impl GuaranteeResult {
    fn new(name: &str, stated: &[Guarantee], trials: &[Trial], smallest: &[SmallestCase]) -> Self {
        let stated = stated.iter().find(|g| g.name == name);
        let checks = || checks_of(name, trials);
        let failures = || checks().filter(|(_, check)| !check.kept());
        let unit = stated.map(|g| &g.unit).or_else(|| checks().next().map(|(_, check)| &check.unit));
        let nearest = checks().min_by(|a, b| least(a.1.margin).total_cmp(&least(b.1.margin)));
        let case = |first: Measured| {
            let case = smallest.iter().find(|case| case.guarantee == name)?;
            Some(Failing { first, smallest: case.trial.clone(), file: file_of(name) })
        };
        Self {
            name: name.to_owned(),
            unit: unit.cloned().unwrap_or_default(),
            stated: stated.cloned(),
            kept_without_disturbances: stated.and_then(|g| g.measured.map(|value| g.contains(value))),
            trials_checked: checks().count() as u64,
            violations: failures().count() as u64,
            nearest: nearest.map(Measured::of),
            failing: failures().next().map(Measured::of).and_then(case),
        }
    }

    pub(crate) fn kept(&self) -> bool {
        self.violations == 0 && self.kept_without_disturbances != Some(false)
    }

    pub(crate) fn checked(&self) -> bool {
        self.trials_checked > 0 || self.kept_without_disturbances.is_some()
    }

    fn complaint(&self, trials: u64) -> String {
        let as_it_is = (self.kept_without_disturbances == Some(false)).then(|| "in the scenario as it is".to_owned());
        let first = self.failing.as_ref().map_or(String::new(), |f| format!(" (first in trial {})", f.first.trial));
        let in_trials = (self.violations > 0).then(|| format!("in {} of {trials} trials{first}", self.violations));
        let places: Vec<String> = as_it_is.into_iter().chain(in_trials).collect();
        format!("{} is violated {}", self.name, places.join(" and "))
    }
}

impl Measured {
    fn of((trial, check): (&Trial, &Check)) -> Self {
        let Check { measured, bound, margin, .. } = *check;
        Self { trial: trial.number, size: trial.size, measured, bound, margin }
    }
}

/// A margin for comparing: NaN is the worst there is.
fn least(margin: f64) -> f64 {
    if margin.is_nan() { f64::NEG_INFINITY } else { margin }
}

/// The checks of a guarantee, by trial.
pub(crate) fn checks_of<'a>(name: &'a str, trials: &'a [Trial]) -> impl Iterator<Item = (&'a Trial, &'a Check)> {
    let of_name =
        move |trial: &'a Trial| trial.checks.iter().filter(move |c| c.guarantee == name).map(move |c| (trial, c));
    trials.iter().flat_map(of_name)
}

/// The guarantees stated, and after them those that only trials know, in the order of the trials.
fn names(stated: &[Guarantee], trials: &[Trial]) -> Vec<String> {
    let mut names: Vec<String> = stated.iter().map(|g| g.name.clone()).collect();
    for check in trials.iter().flat_map(|trial| &trial.checks) {
        if !names.contains(&check.guarantee) {
            names.push(check.guarantee.clone());
        }
    }
    names
}

/// The first trial in which each violated guarantee failed.
pub(crate) fn first_failures(trials: &[Trial]) -> Vec<(String, &Trial)> {
    let mut first: Vec<(String, &Trial)> = Vec::new();
    for trial in trials {
        for check in trial.checks.iter().filter(|check| !check.kept()) {
            if !first.iter().any(|(name, _)| *name == check.guarantee) {
                first.push((check.guarantee.clone(), trial));
            }
        }
    }
    first
}

/// Name of the scenario file with the smallest failing case of a guarantee.
pub(crate) fn file_of(guarantee: &str) -> String {
    // Names are kebab case; whatever else one might be, it stays inside the folder.
    let plain: String = guarantee.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
    format!("failing-{plain}.toml")
}
