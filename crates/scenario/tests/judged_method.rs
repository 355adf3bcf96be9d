//! Comparison, sweep, campaign and tuning judge the same method where nothing else is chosen.

use rayon::prelude::*;
use slideway_compare::{ConditioningOptions, SpeedOptions, compare_conditioning, compare_speed, unwatched};
use slideway_scenario::sweep::{SweepPlan, SweepRequest};
use slideway_scenario::{AnyScenario, BUILT_IN, BuiltIn, Tuning, TuningError};
use slideway_verify::{Campaign, CampaignRequest, TuneRequest, VerifyError};
use std::error::Error;

type Found<T> = Result<T, Box<dyn Error + Send + Sync>>;

/// The method that a comparison's verdict is about.
fn compared(scenario: &AnyScenario) -> Found<&'static str> {
    Ok(match scenario {
        AnyScenario::Speed(speed) => {
            let judged = speed.judged_method();
            let options = SpeedOptions { grid_points: 20, judged, ..SpeedOptions::named(scenario.name()) };
            compare_speed(&speed.experiment()?, &options, &mut unwatched)?.summary.verdict.method.name()
        }
        AnyScenario::Conditioning(conditioning) => {
            let name = scenario.name().to_owned();
            let options =
                ConditioningOptions { name, tolerance: conditioning.tolerance(), ..ConditioningOptions::default() };
            compare_conditioning(&conditioning.problem()?, &options, &mut unwatched)?.summary.verdict.method.name()
        }
    })
}

/// The method of a sweep's only run.
fn swept(built_in: &BuiltIn) -> Found<String> {
    Ok(SweepPlan::new(SweepRequest::of(built_in.name, built_in.text.to_owned()))?.method().to_owned())
}

/// The method that a campaign states something of.
fn verified(scenario: &AnyScenario) -> Found<String> {
    let (options, grid_points) = (scenario.verify_options()?, scenario.grid_points());
    let request = CampaignRequest { options, grid_points, seed: 1, trials: 1 };
    Ok(Campaign::new(scenario.subject(None)?, request)?.statement().method.clone())
}

/// The method that is tuned; a rate too low to be kept is refused for the method's sake or answered at once.
fn tuned(scenario: &AnyScenario) -> Found<Option<String>> {
    match scenario.tuned(None, TuneRequest { chattering: 0.5, rate: 1000.0 }) {
        Ok(Tuning::Tuned(tuned)) => Ok(Some(tuned.statement.method)),
        Ok(Tuning::Impossible(_)) => Ok(None),
        Err(TuningError::Verify(VerifyError::NoClaims { method })) => Ok(Some(method)),
        Err(error) => Err(error.into()),
    }
}

#[test]
fn every_built_in_scenario_has_one_method_that_is_judged() {
    BUILT_IN.par_iter().for_each(|built_in| {
        let scenario = AnyScenario::parse(built_in.name, built_in.text).expect("valid");
        let all = || -> Found<_> { Ok((compared(&scenario)?, swept(built_in)?, verified(&scenario)?)) };
        let (compared, swept, verified) = all().unwrap_or_else(|error| panic!("{}: {error}", built_in.name));
        assert_eq!([compared, compared], [&swept, &verified], "{}", built_in.name);
    });
}

#[test]
fn tuning_is_of_the_method_that_is_judged() {
    for name in ["planar-line", "planar-bend", "helix-plane-sphere"] {
        let scenario = AnyScenario::built_in(name).expect("there").expect("valid");
        let found = tuned(&scenario).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(found.as_deref(), Some(scenario.subject(None).expect("valid").method()), "{name}");
    }
}
