#![allow(dead_code)] // Each test binary uses its part.
//! Scenarios made into subjects, statements and campaigns.

use slideway_lab::Subject;
use slideway_scenario::{AnyScenario, BUILT_IN, ScenarioError};
use slideway_verify::{Campaign, CampaignRequest, Statement, VerifyError};

/// Text of a built-in scenario.
pub(crate) fn text(name: &str) -> String {
    BUILT_IN.iter().find(|b| b.name == name).expect("built in").text.to_owned()
}

/// The statement about a scenario, for the method of that name or the one judged.
pub(crate) fn statement(scenario: &AnyScenario, method: Option<&str>) -> Result<Statement, Box<dyn std::error::Error>> {
    Ok(match scenario.subject(method)? {
        Subject::Speed { experiment, method } => Statement::for_speed(*experiment, method, scenario.grid_points())?,
        Subject::Conditioning { problem, method } => Statement::for_conditioning(*problem, method)?,
    })
}

/// A campaign around a text.
pub(crate) fn campaign(text: &str, method: &str, seed: u64, trials: u64) -> Result<Campaign, VerifyError> {
    let scenario = AnyScenario::parse("mine", text).expect("a scenario");
    let options = scenario.verify_options().expect("valid");
    let subject = subject(&scenario, method).expect("valid");
    Campaign::new(subject, CampaignRequest { options, grid_points: scenario.grid_points(), seed, trials })
}

pub(crate) fn subject(scenario: &AnyScenario, method: &str) -> Result<Subject, ScenarioError> {
    scenario.subject(Some(method))
}
