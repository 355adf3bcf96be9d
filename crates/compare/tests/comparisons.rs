//! Whole comparisons as values, watched and cancelled.

use slideway_compare::{
    CompareError, ConditioningOptions, Progress, SpeedOptions, Stage, compare_conditioning, compare_speed, unwatched,
};
use slideway_lab::conditioning::{ConditioningProblem, PathMethod};
use slideway_lab::{Experiment, Method};
use slideway_scenario::ConditioningScenario;
use slideway_scenario::Scenario;
use std::ops::ControlFlow;

/// One joint from 0 to 1 rad at up to 1 rad/s.
const JOINT: &str = "
    limits.speed = 1
    control = { gain = 10, sampling_period = 1e-3, bandwidth = 10, target_rate = 5 }
    robot.dh = [{ a = 0.5, alpha = 0, d = 0 }]
    path.joints.line = { from = [0], to = [1] }
";

fn joint() -> Experiment {
    Scenario::parse("joint", JOINT).expect("a scenario").experiment().expect("an experiment")
}

fn options() -> SpeedOptions {
    SpeedOptions { grid_points: 100, ..SpeedOptions::named("joint") }
}

fn helix() -> ConditioningProblem {
    let text = slideway_scenario::BUILT_IN.iter().find(|b| b.name == "helix-plane-sphere").expect("built in").text;
    ConditioningScenario::parse("helix-plane-sphere", text).expect("a scenario").problem().expect("a problem")
}

#[test]
fn a_speed_comparison_is_a_value_with_a_certified_optimum_and_a_run_a_method() {
    let experiment = joint();
    let comparison = compare_speed(&experiment, &options(), &mut unwatched).expect("a comparison");
    let summary = &comparison.summary;
    // 1 rad at 1 rad/s.
    assert!(summary.optimum.certified && summary.optimum.lower_s <= 1.0 && 1.0 <= summary.optimum.upper_s);
    let methods: Vec<Method> = comparison.traces.iter().map(|trace| trace.method).collect();
    assert_eq!(methods, experiment.methods());
    assert_eq!(summary.methods.len(), methods.len());
    assert_eq!((summary.verdict.method, summary.verdict.tolerance), (Method::SlidingModeSynchronised, 0.02));
    let json = serde_json::to_value(summary).expect("a value");
    assert_eq!(json["scenario"], "joint");
    assert_eq!(json["verdict"]["sentence"], summary.verdict.sentence.as_str());
}

#[test]
fn a_comparison_counts_up_to_its_last_step_and_begins_each_stage_once() {
    let mut seen: Vec<Progress> = Vec::new();
    let mut watch = |progress| {
        seen.push(progress);
        ControlFlow::Continue(())
    };
    compare_speed(&joint(), &options(), &mut watch).expect("a comparison");
    let done: Vec<usize> = seen.iter().map(|progress| progress.done).collect();
    assert!(done.is_sorted(), "{done:?}");
    let last = seen.last().expect("steps");
    assert_eq!((last.done + 1, last.stage), (last.total, Stage::Variations));
}

#[test]
fn a_speed_comparison_ends_where_its_caller_says() {
    for stop in [Stage::SpeedLaw(Method::SlidingMode), Stage::Optimum, Stage::Variations] {
        let mut after = 0;
        let mut watch = |progress: Progress| {
            after += usize::from(after > 0 || progress.stage == stop);
            if progress.stage == stop { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let ended = compare_speed(&joint(), &options(), &mut watch);
        assert!(matches!(ended, Err(CompareError::Cancelled)), "{stop}");
        assert_eq!(after, 1, "{stop}");
    }
}

#[test]
fn a_conditioning_comparison_is_a_value_and_ends_where_its_caller_says() {
    let options = ConditioningOptions { name: "helix".into(), ..ConditioningOptions::default() };
    let problem = helix();
    let comparison = compare_conditioning(&problem, &options, &mut unwatched).expect("a comparison");
    let methods: Vec<PathMethod> = comparison.traces.iter().map(|trace| trace.method).collect();
    assert_eq!(methods, PathMethod::ALL);
    assert!(comparison.summary.verdict.holds, "{}", comparison.summary.verdict.sentence);
    let mut watch = |progress: Progress| {
        let over = progress.stage == Stage::PathMethod(PathMethod::QpFilter);
        if over { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    assert!(matches!(compare_conditioning(&problem, &options, &mut watch), Err(CompareError::Cancelled)));
}

#[test]
fn options_that_are_no_numbers_are_refused_before_anything_runs() {
    let broken = [
        SpeedOptions { tolerance: f64::NAN, ..options() },
        SpeedOptions { tolerance: -1.0, ..options() },
        SpeedOptions { inter_sample: Some(f64::NAN), ..options() },
        SpeedOptions { inter_sample: Some(0.0), ..options() },
    ];
    for options in broken {
        let refused = compare_speed(&joint(), &options, &mut |_| panic!("something runs"));
        assert!(matches!(refused, Err(CompareError::Option { .. })), "{options:?}");
    }
}
