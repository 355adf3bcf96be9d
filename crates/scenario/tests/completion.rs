//! A run is completed where its path parameter is at the path's end, whatever the method.

use slideway_lab::Method;
use slideway_scenario::{AnyScenario, BUILT_IN, Scenario};

/// Every method of a scenario: those that completed are at the end, to a millionth of the path.
fn completed(name: &str, text: &str) -> Vec<Method> {
    let experiment = Scenario::parse(name, text).and_then(|s| s.experiment()).expect("an experiment");
    let length = experiment.path_length();
    let mut completed = Vec::new();
    for method in experiment.methods() {
        let trace = experiment.run(method).expect("runs");
        let (first, last) = (trace.samples[0], trace.samples[trace.samples.len() - 1]);
        if trace.finish_s.is_some() {
            // A run that ends with its reference has its last sample less than a period before.
            let ahead = last.path_rate * trace.sampling_period;
            let missing = length - (last.lambda - first.lambda) - ahead;
            assert!(missing <= 1e-6 * length, "{name} {method}: {missing} of {length} is left");
            completed.push(method);
        }
        assert!(
            trace.arrival_s.is_none() || trace.finish_s.is_some(),
            "{name} {method}: arrived without its reference"
        );
    }
    completed
}

#[test]
fn what_is_completed_is_at_the_end_in_every_built_in_scenario() {
    for b in BUILT_IN.iter().filter(|b| matches!(AnyScenario::parse(b.name, b.text), Ok(AnyScenario::Speed(_)))) {
        completed(b.name, b.text);
    }
}

#[test]
fn natural_motion_that_turns_back_at_a_wrist_singularity_is_not_completed() {
    let text = BUILT_IN.iter().find(|b| b.name == "puma-wrist-singularity").expect("built in").text;
    let found = completed("wrist", &format!("{text}\n[natural]\nfactor = \"determinant\"\n"));
    assert!(!found.contains(&Method::NaturalMotion) && found.contains(&Method::SlidingMode), "{found:?}");
}
