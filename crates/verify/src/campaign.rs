use crate::error::VerifyError;
use crate::statement::Statement;
use crate::trial::draw::Draw;
use crate::trial::path::PathSubject;
use crate::trial::smallest::smallest;
use crate::trial::speed::SpeedSubject;
use crate::trial::{Judgement, Trial};
use slideway_lab::Method;
use slideway_lab::conditioning::PathMethod;
use slideway_scenario::ConditioningScenario;
use slideway_scenario::{AnyScenario, Scenario, ScenarioError, VerifyOptions};
use std::path::PathBuf;
use toml::{Table, Value};

/// What a campaign is asked to do. Everything that a trial depends on.
#[derive(Clone, Debug, PartialEq)]
pub struct CampaignRequest {
    /// Name of the scenario.
    pub name: String,
    /// Its text.
    pub text: String,
    /// Its file, if it has one: files that the scenario names lie beside it.
    pub file: Option<PathBuf>,
    /// The method; without one the one that `compare` judges.
    pub method: Option<String>,
    /// Seed of the disturbances.
    pub seed: u64,
    /// How many trials.
    pub trials: u64,
}

/// Numbered trials around a scenario.
#[derive(Clone, Debug)]
pub struct Campaign {
    request: CampaignRequest,
    statement: Statement,
    subject: Subject,
}

/// What is run.
#[derive(Clone, Debug)]
enum Subject {
    Speed(Box<SpeedSubject>),
    Path(Box<PathSubject>),
}

/// What the table `[verify]` of a scenario asks for, which the number of trials and the seed of a request may be taken from.
///
/// # Errors
///
/// A text that is no scenario, or a greatest disturbance that no scenario may have.
pub fn verify_options(name: &str, text: &str) -> Result<VerifyOptions, VerifyError> {
    Ok(AnyScenario::parse(name, text)?.verify_options()?)
}

impl Campaign {
    /// Reads the scenario, states what is guaranteed, makes no trial.
    ///
    /// To the statement's guarantees it adds those that hold whatever disturbs the loop, under the names of their claims.
    ///
    /// # Errors
    ///
    /// A scenario that cannot be used, a method that there is not.
    pub fn new(request: CampaignRequest) -> Result<Self, VerifyError> {
        let scenario = AnyScenario::parse(&request.name, &request.text)?;
        let scenario = match &request.file {
            Some(file) => scenario.in_folder_of(file),
            None => scenario,
        };
        let (subject, statement) = match scenario {
            AnyScenario::Speed(scenario) => speed(&scenario, request.method.as_deref())?,
            AnyScenario::Conditioning(scenario) => conditioning(&scenario, request.method.as_deref())?,
        };
        Ok(Self { request, statement, subject })
    }

    /// What was asked for.
    #[must_use]
    pub fn request(&self) -> &CampaignRequest {
        &self.request
    }

    /// What is known before any trial.
    #[must_use]
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// Makes one trial: a function of the campaign and the number alone.
    ///
    /// A trial is held against the guarantees of the statement whose hypotheses it keeps, and against those that hold whatever disturbs
    /// the loop. Beside the statement's hypotheses it may break what every statement takes for granted: `period-as-counted` (times, under
    /// jitter), `joints-as-seen` (arrival of joints that are misread), `constraints-seen-in-time` (constraints that move, seen late),
    /// `start-inside` (an initial error that leaves the allowed set) and `distances-as-they-are` (noise, where what it does to a bound is
    /// not derived).
    ///
    /// # Errors
    ///
    /// A number beyond the last; a scenario that cannot be run under the trial's disturbances.
    pub fn trial(&self, number: u64) -> Result<Trial, VerifyError> {
        if number >= self.request.trials {
            return Err(VerifyError::NoTrial { number, trials: self.request.trials });
        }
        self.made(number, &self.draw(number))
    }

    /// A failing trial made as small as it can be while every guarantee fails that it broke: less of each disturbance, fewer kinds. One
    /// that breaks nothing stays as it is.
    ///
    /// # Errors
    ///
    /// As [`Campaign::trial`].
    pub fn smallest(&self, failing: &Trial) -> Result<Trial, VerifyError> {
        let violated = failing.violated();
        if violated.is_empty() {
            return Ok(failing.clone());
        }
        let had = |key: &str| failing.disturbances.contains_key(key);
        let draw = self.draw(failing.number).at(failing.size).with_only(|kind| had(kind.key()));
        self.made(failing.number, &smallest(&draw, &violated, |draw| self.judge(draw))?)
    }

    /// A trial as a scenario that `slideway compare` runs: the scenario's text with the trial's disturbances, written anew. Files that it
    /// names keep their names, so it has to lie where the scenario does; the second line says so where it matters.
    ///
    /// # Errors
    ///
    /// The scenario's text cannot carry the table.
    pub fn scenario_of(&self, trial: &Trial) -> Result<String, VerifyError> {
        let unreadable = |message: String| ScenarioError::Syntax { message, span: None };
        let mut document: Table = self.request.text.parse().map_err(|e: toml::de::Error| unreadable(e.to_string()))?;
        document.remove("disturbances");
        if !trial.disturbances.is_empty() {
            document.insert("disturbances".into(), Value::Table(trial.disturbances.clone()));
        }
        if let Subject::Speed(subject) = &self.subject {
            let compare = document.entry("compare").or_insert_with(|| Value::Table(Table::new()));
            if let Value::Table(compare) = compare {
                compare.insert("method".into(), subject.method().name().into());
            }
        }
        let text = toml::to_string(&document).map_err(|error| unreadable(error.to_string()))?;
        Ok(self.heading(trial, &document) + &text)
    }

    fn heading(&self, trial: &Trial, document: &Table) -> String {
        let CampaignRequest { name, seed, .. } = &self.request;
        let shown: String = name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        let (number, size) = (trial.number, trial.size);
        let mut heading =
            format!("# Trial {number} of the campaign around {shown} with seed {seed}, at size {size}.\n");
        if names_files(&Value::Table(document.clone())) {
            heading += "# It names files relative to its own folder: keep it beside the scenario it was made from.\n";
        }
        heading
    }

    fn draw(&self, number: u64) -> Draw {
        match &self.subject {
            Subject::Speed(subject) => subject.draw(self.request.seed, number),
            Subject::Path(subject) => subject.draw(self.request.seed, number),
        }
    }

    fn judge(&self, draw: &Draw) -> Result<Judgement, VerifyError> {
        match &self.subject {
            Subject::Speed(subject) => subject.judge(&draw.for_speed(), &self.statement),
            Subject::Path(subject) => subject.judge(&draw.for_conditioning(), &self.statement),
        }
    }

    fn made(&self, number: u64, draw: &Draw) -> Result<Trial, VerifyError> {
        let Judgement { outside, checks } = self.judge(draw)?;
        Ok(Trial { number, size: draw.size(), disturbances: draw.table(), outside, checks })
    }
}

fn speed(scenario: &Scenario, method: Option<&str>) -> Result<(Subject, Statement), VerifyError> {
    let unknown = |name: &str| VerifyError::unknown_method(name, Method::ALL.map(Method::name).to_vec());
    let known = |name: &str| Method::ALL.into_iter().find(|m| m.name() == name).ok_or_else(|| unknown(name));
    let (subject, statement) = SpeedSubject::new(scenario, method.map(known).transpose()?)?;
    Ok((Subject::Speed(Box::new(subject)), statement))
}

fn conditioning(scenario: &ConditioningScenario, method: Option<&str>) -> Result<(Subject, Statement), VerifyError> {
    let forms = || PathMethod::ALL.into_iter().filter(|m| m.is_conditioner());
    let unknown = |name: &str| VerifyError::unknown_method(name, forms().map(PathMethod::name).collect());
    let known = |name: &str| forms().find(|m| m.name() == name).ok_or_else(|| unknown(name));
    let method = method.map_or(Ok(PathMethod::SlidingMode), known)?;
    let (subject, statement) = PathSubject::new(scenario, method)?;
    Ok((Subject::Path(Box::new(subject)), statement))
}

/// Whether a scenario names files.
fn names_files(value: &Value) -> bool {
    match value {
        Value::Table(table) => {
            table.iter().any(|(key, value)| matches!(key.as_str(), "csv" | "urdf") || names_files(value))
        }
        Value::Array(list) => list.iter().any(names_files),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideway_lab::MethodSummary;
    use slideway_lab::conditioning::run_conditioner;
    use slideway_scenario::BUILT_IN;

    fn campaign(name: &str, method: &str) -> Campaign {
        let text = BUILT_IN.iter().find(|b| b.name == name).expect("built in").text.to_owned();
        let request =
            CampaignRequest { name: name.into(), text, file: None, method: Some(method.into()), seed: 3, trials: 1000 };
        Campaign::new(request).expect("valid")
    }

    /// The upper bound of a guarantee put where a little more than the run without disturbances reaches it.
    fn broken(mut campaign: Campaign, name: &str) -> (Campaign, f64) {
        let guarantee = campaign.statement.guarantees.iter_mut().find(|g| g.name == name).expect("stated");
        let bound = 1.001 * guarantee.measured.expect("measured");
        guarantee.upper = Some(bound);
        guarantee.rests_on.clear();
        (campaign, bound)
    }

    fn first_failing(campaign: &Campaign) -> Trial {
        (0..200).map(|n| campaign.trial(n).expect("runs")).find(|t| !t.kept()).expect("one fails")
    }

    #[test]
    fn a_broken_guarantee_is_found_made_small_and_reproduced_by_its_scenario() {
        let (campaign, bound) = broken(campaign("planar-line", "sliding-mode-synchronised"), "chattering");
        let failing = first_failing(&campaign);
        assert_eq!(failing.violated(), ["chattering"]);
        let smallest = campaign.smallest(&failing).expect("runs");
        assert_eq!(smallest.violated(), ["chattering"]);
        assert!(smallest.size < failing.size && smallest.size > 0.0, "{} {}", smallest.size, failing.size);
        assert!(smallest.disturbances.keys().all(|key| failing.disturbances.contains_key(key)));
        assert!(smallest.disturbances.iter().filter(|(key, _)| *key != "seed").count() >= 1);
        assert_eq!(campaign.smallest(&failing).expect("runs"), smallest);

        let text = campaign.scenario_of(&smallest).expect("writes");
        let scenario = Scenario::parse("failing", &text).expect("parses");
        let experiment = scenario.experiment().expect("valid");
        let judged = experiment.judged_method(scenario.judged_method()).expect("a method");
        let trace = experiment.run(judged).expect("runs");
        let found = MethodSummary::new(&trace).chattering.expect("chatters").measured;
        assert!(found > bound && smallest.checks.iter().any(|check| check.measured == found), "{found} {bound}");
    }

    #[test]
    fn a_guarantee_that_fails_without_disturbances_is_smallest_without_them() {
        let (mut campaign, bound) = broken(campaign("planar-line", "sliding-mode"), "demand");
        let guarantee = campaign.statement.guarantees.iter_mut().find(|g| g.name == "demand").expect("stated");
        guarantee.upper = Some(0.5 * bound);
        let smallest = campaign.smallest(&campaign.trial(0).expect("runs")).expect("runs");
        assert_eq!(smallest.size, 0.0);
        assert!(smallest.disturbances.is_empty() && !smallest.kept());
    }

    #[test]
    fn what_cannot_be_measured_fails_and_still_fits_into_json() {
        for value in [f64::NAN, f64::INFINITY] {
            let check = crate::Check::at_most("g", value, 1.0, "1");
            assert!(!check.kept());
            let text = serde_json::to_string(&check).expect("writes");
            assert_eq!(serde_json::from_str::<crate::Check>(&text).expect("reads"), check);
        }
    }

    /// `{:?}` writes the shortest decimal that reads back to the same bits.
    #[test]
    fn the_scenario_of_a_trial_runs_the_very_trace_that_was_judged() {
        for (name, method) in [("planar-line", "sliding-mode"), ("panda-line", "sliding-mode-implicit")] {
            let campaign = campaign(name, method);
            let Subject::Speed(subject) = &campaign.subject else { panic!("about speed") };
            for number in 0..4 {
                let judged = subject.run(&campaign.draw(number).for_speed()).expect("runs");
                let text = campaign.scenario_of(&campaign.trial(number).expect("runs")).expect("writes");
                let scenario = Scenario::parse("again", &text).expect("parses");
                let again = scenario.experiment().expect("valid").run(subject.method()).expect("runs");
                assert_eq!(format!("{judged:?}"), format!("{again:?}"), "{text}");
            }
        }
        let campaign = campaign("helix-plane-sphere", "sliding-mode-implicit");
        let Subject::Path(subject) = &campaign.subject else { panic!("about conditioning") };
        for number in 0..4 {
            let judged = subject.run(&campaign.draw(number).for_conditioning()).expect("runs");
            let text = campaign.scenario_of(&campaign.trial(number).expect("runs")).expect("writes");
            let problem = ConditioningScenario::parse("again", &text).expect("parses").problem().expect("valid");
            let again = run_conditioner(&problem, PathMethod::SlidingModeImplicit).expect("runs");
            assert_eq!(format!("{judged:?}"), format!("{again:?}"), "{text}");
        }
    }

    #[test]
    fn a_scenario_that_names_files_says_where_to_keep_its_trials() {
        let campaign = campaign("planar-line", "sliding-mode");
        let trial = campaign.trial(0).expect("runs");
        let text = campaign.scenario_of(&trial).expect("writes");
        assert!(text.starts_with("# Trial 0 of the campaign around planar-line with seed 3, at size "), "{text}");
        let named: Table = "path.position.spline.csv = 'points.csv'".parse().expect("TOML");
        assert!(campaign.heading(&trial, &named).contains("keep it beside") && !text.contains("keep it beside"));
    }
}
