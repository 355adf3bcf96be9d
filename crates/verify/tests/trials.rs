//! Trials of a campaign: what they depend on, and what holds in every one of them.

mod support;

use rayon::prelude::*;
use slideway_lab::conditioning::{ConditioningProblem, PathMethod, run_conditioner};
use slideway_lab::{Experiment, Method, MethodSummary};
use slideway_scenario::{AnyScenario, ConditioningScenario, Scenario, ScenarioError};
use slideway_verify::{Campaign, Trial, TrialDisturbances, VerifyError};
use support::text;

fn campaign(name: &str, method: &str) -> Campaign {
    support::campaign(&text(name), method, 11, 100_000).expect("valid")
}

fn trials(campaign: &Campaign, count: u64) -> Vec<Trial> {
    (0..count).map(|number| campaign.trial(number).expect("runs")).collect()
}

#[test]
fn a_trial_depends_on_its_campaign_and_its_number_alone() {
    for (name, method) in [("planar-line", "sliding-mode"), ("helix-plane-sphere", "sliding-mode-implicit")] {
        let one = trials(&campaign(name, method), 16);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("two threads");
        let other = campaign(name, method);
        let backwards: Vec<u64> = (0..16).rev().collect();
        let mut again: Vec<Trial> =
            pool.install(|| backwards.par_iter().map(|&n| other.trial(n).expect("runs")).collect());
        again.reverse();
        assert_eq!(one, again);
        // Through JSON to the bit, as a journal keeps them.
        let json = serde_json::to_string(&one).expect("writes");
        assert_eq!(serde_json::from_str::<Vec<Trial>>(&json).expect("reads"), one);
        let seeded = support::campaign(&text(name), method, 12, 100_000).expect("valid");
        assert_ne!(trials(&seeded, 1), one[..1]);
    }
}

#[test]
fn no_disturbance_breaks_what_holds_whatever_disturbs_the_loop() {
    for (name, method, expected) in [
        ("planar-line", "sliding-mode", vec!["command", "factor-range", "chattering-band", "signal-band"]),
        (
            "planar-line",
            "sliding-mode-synchronised",
            vec!["command", "factor-range", "chattering-band", "signal-band", "synchronised-advance"],
        ),
        ("planar-line", "sliding-mode-implicit", vec!["command", "factor-range", "chattering-band", "implicit-band"]),
        ("planar-bend", "acceleration-look-ahead", vec!["command", "command-acceleration", "factor-range"]),
        ("helix-plane-sphere", "sliding-mode-implicit", vec!["path-implicit"]),
        ("trap-booth-oval", "sliding-mode", vec!["path-reserve"]),
    ] {
        let campaign = campaign(name, method);
        let count = if name == "planar-line" { 60 } else { 15 };
        for trial in trials(&campaign, count) {
            for guarantee in &expected {
                let check = trial.checks.iter().find(|check| check.guarantee == *guarantee);
                let check = check.unwrap_or_else(|| panic!("{name} {method}: {guarantee} not checked in {trial:?}"));
                assert!(check.kept(), "{name} {method} {}: {check:?}", trial.number);
            }
        }
    }
}

#[test]
fn every_guarantee_whose_hypotheses_a_trial_keeps_is_kept() {
    for (name, method, stated) in [
        ("planar-line", "sliding-mode", "demand"),
        ("planar-line", "sliding-mode-implicit", "demand"),
        ("puma-helix-on-path", "sliding-mode-synchronised", "demand"),
        ("helix-plane-sphere", "sliding-mode", "penetration"),
    ] {
        let campaign = campaign(name, method);
        let found = trials(&campaign, 10);
        for trial in &found {
            assert!(trial.kept(), "{name} {method}: {:?} in {trial:?}", trial.violated());
        }
        assert!(found.iter().any(|trial| !trial.outside.is_empty()), "some trial breaks a hypothesis");
        assert!(found.iter().any(|trial| trial.checks.iter().any(|check| check.guarantee == stated)));
    }
}

#[test]
fn the_table_of_a_scenario_says_how_large_disturbances_get() {
    let table = "\n[verify]\ntrials = 40\nseed = 5\ninitial_error = 0\njoint_noise = 0\njoint_offset = 0\nspeed_error = 0\ndelay = 0\njitter = 0.5\n";
    let text = format!("{}{table}", text("planar-line"));
    let options = AnyScenario::parse("mine", &text).and_then(|scenario| scenario.verify_options()).expect("reads");
    assert_eq!((options.trials, options.seed, options.jitter), (Some(40), Some(5), Some(0.5)));
    let campaign = support::campaign(&text, "sliding-mode", 11, 40).expect("valid");
    let mut most = 0.0_f64;
    for trial in trials(&campaign, 40) {
        let TrialDisturbances { jitter, seed, .. } = trial.disturbances;
        assert_eq!(trial.disturbances, TrialDisturbances { jitter, seed, ..TrialDisturbances::default() });
        most = most.max(jitter.expect("a number"));
    }
    // Half the trials have the range times their size: all 40 below half the range with a probability of less than 0.75^40.
    assert!(most > 0.25 && most <= 0.5, "{most}");
}

/// Noise of up to `n` on `σ` shifts what the conditioner keeps of `φ` by up to `n`: more than the statement says without noise, and no more
/// than that with it.
#[test]
fn noise_shifts_the_band_of_a_conditioner_by_its_size() {
    let table = "\n[verify]\ninitial_error = 0\ndistance_noise = 1e-3\ndelay = 0\njitter = 0\n";
    let text = format!("{}{table}", text("helix-plane-sphere"));
    let campaign = support::campaign(&text, "sliding-mode-implicit", 11, 10).expect("valid");
    let stated =
        campaign.statement().guarantees.iter().find(|g| g.name == "phi").and_then(|g| g.upper).expect("stated");
    for trial in trials(&campaign, 10) {
        let noise = trial.disturbances.distance_noise.expect("a number");
        let check = trial.checks.iter().find(|check| check.guarantee == "phi").expect("checked");
        assert!(check.kept() && check.bound == stated + noise, "{check:?}");
        // Of thousands of samples at the boundary one has nearly all of the noise.
        assert!(check.measured > stated + 0.9 * noise, "{check:?} {noise}");
    }
}

/// A reference that begins 1 mm behind a wall: most starts that are off by up to 5 mm are behind it too, and noise, delay and jitter change
/// nothing. The weak push leaves the way back to the reserve.
#[test]
fn trials_that_start_outside_are_held_against_the_way_back() {
    for (method, keys) in [("sliding-mode-implicit", "recovery_rate = 0.5"), ("sliding-mode", "reserve_rate = 0.5")] {
        let text = text("helix-plane-sphere")
            .replace("offset = 0 ", "offset = -0.176 ")
            .replace("amplitude = 0.1", "amplitude = 0.001");
        let text = text.replace("push_cutoff = 20", &format!("push_cutoff = 20\n{keys}"));
        let text = format!("{text}\n[verify]\ninitial_error = 5e-3\n");
        let campaign = support::campaign(&text, method, 11, 40).expect("valid");
        let found = trials(&campaign, 40);
        let checks: Vec<_> =
            found.iter().flat_map(|trial| &trial.checks).filter(|check| check.guarantee == "recovery").collect();
        assert!(checks.len() >= 20, "{method}: {}", checks.len());
        assert!(checks.iter().all(|check| check.kept() && check.measured > 0.0), "{method}: {checks:?}");
    }
}

#[test]
fn numbers_and_methods_that_there_are_not_are_refused() {
    let campaign = campaign("planar-line", "sliding-mode");
    assert!(matches!(campaign.trial(100_000), Err(VerifyError::NoTrial { number: 100_000, trials: 100_000 })));
    for name in ["planar-line", "helix-plane-sphere"] {
        let refused = support::subject(&AnyScenario::parse(name, &text(name)).expect("valid"), "qp-filter");
        assert!(matches!(refused, Err(ScenarioError::UnknownMethod { .. })), "{name}");
    }
}

/// The upper bound of a guarantee put at a share of what the run without disturbances reaches.
fn broken(campaign: Campaign, name: &str, share: f64) -> (Campaign, f64) {
    let mut statement = campaign.statement().clone();
    let guarantee = statement.guarantees.iter_mut().find(|g| g.name == name).expect("stated");
    let bound = share * guarantee.measured.expect("measured");
    guarantee.upper = Some(bound);
    guarantee.rests_on.clear();
    (campaign.against(statement), bound)
}

fn first_failing(campaign: &Campaign) -> Trial {
    (0..200).map(|n| campaign.trial(n).expect("runs")).find(|t| !t.kept()).expect("one fails")
}

#[test]
fn a_broken_guarantee_is_found_made_small_and_reproduced_by_its_scenario() {
    let (campaign, bound) = broken(campaign("planar-line", "sliding-mode-synchronised"), "chattering", 1.001);
    let failing = first_failing(&campaign);
    assert_eq!(failing.violated(), ["chattering"]);
    let smallest = campaign.smallest(&failing).expect("runs");
    assert_eq!(smallest.violated(), ["chattering"]);
    assert!(smallest.size < failing.size && smallest.size > 0.0, "{} {}", smallest.size, failing.size);
    let kinds = |trial: &Trial| {
        serde_json::to_value(&trial.disturbances).expect("writes").as_object().expect("a table").clone()
    };
    assert!(kinds(&smallest).keys().all(|key| kinds(&failing).contains_key(key)));
    assert!(kinds(&smallest).keys().any(|key| key != "seed"));
    assert_eq!(campaign.smallest(&failing).expect("runs"), smallest);

    let base = AnyScenario::parse("base", &text("planar-line")).expect("valid");
    let text = base.of_trial(&smallest, "sliding-mode-synchronised", 11).expect("writes");
    let scenario = Scenario::parse("failing", &text).expect("parses");
    let experiment = scenario.experiment().expect("valid");
    let judged = experiment.judged_method(scenario.judged_method()).expect("a method");
    let trace = experiment.run(judged).expect("runs");
    let found = MethodSummary::new(&trace).chattering.expect("chatters").measured;
    assert!(found > bound && smallest.checks.iter().any(|check| check.measured == found), "{found} {bound}");
}

#[test]
fn a_guarantee_that_fails_without_disturbances_is_smallest_without_them() {
    let (campaign, _) = broken(campaign("planar-line", "sliding-mode"), "demand", 0.5);
    let smallest = campaign.smallest(&campaign.trial(0).expect("runs")).expect("runs");
    assert_eq!(smallest.size, 0.0);
    assert!(smallest.disturbances == TrialDisturbances::default() && !smallest.kept());
}

/// `{:?}` writes the shortest decimal that reads back to the same bits.
#[test]
fn the_scenario_of_a_trial_runs_the_very_trace_that_was_judged() {
    for (name, method) in [("planar-line", Method::SlidingMode), ("panda-line", Method::SlidingModeImplicit)] {
        let campaign = campaign(name, method.name());
        let base = AnyScenario::parse(name, &text(name)).expect("valid");
        let experiment =
            |text: &str| -> Experiment { Scenario::parse("again", text).expect("parses").experiment().expect("valid") };
        for trial in trials(&campaign, 4) {
            let disturbances = trial.disturbances.for_speed();
            let judged = experiment(&text(name)).with_disturbances(&disturbances).expect("valid").run(method);
            let written = base.of_trial(&trial, method.name(), 11).expect("writes");
            let again = experiment(&written).run(method);
            assert_eq!(format!("{judged:?}"), format!("{again:?}"), "{written}");
        }
    }
    let (name, method) = ("helix-plane-sphere", PathMethod::SlidingModeImplicit);
    let base = AnyScenario::parse(name, &text(name)).expect("valid");
    let problem = |text: &str| ConditioningScenario::parse("again", text).expect("parses").problem().expect("valid");
    for trial in trials(&campaign(name, method.name()), 4) {
        let disturbances = trial.disturbances.for_conditioning();
        let judged = run_conditioner(&ConditioningProblem { disturbances, ..problem(&text(name)) }, method);
        let written = base.of_trial(&trial, method.name(), 11).expect("writes");
        assert_eq!(format!("{judged:?}"), format!("{:?}", run_conditioner(&problem(&written), method)), "{written}");
    }
}
