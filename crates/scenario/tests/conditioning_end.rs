//! Where a conditioned run ends if its sampling period does not divide the duration of its reference.

use slideway_lab::conditioning::{ConditionedTrace, PathMethod, Phase, run_conditioner};
use slideway_scenario::ConditioningScenario;

/// A wall along a sine that is cut off where the wall holds it, 2.6 s long, with this course of `x`.
fn run(method: PathMethod, period: &str, x: &str, max_duration: &str) -> ConditionedTrace {
    let text = format!(
        r#"
        [reference]
        end = 2.6
        rate = 1
        max_duration = {max_duration}
        position.formula = {{ x = "{x}", y = "0.1 * sin(lambda)", z = "0" }}
        [[constraint]]
        name = "wall"
        approach = 0.1
        shape.half-space = {{ normal = [0, 1, 0], offset = 0.02 }}
        [conditioner]
        sampling_period = {period}
        push_cutoff = 20
        law.normalised.amplitude = 0.1
        "#
    );
    let problem = ConditioningScenario::parse("end", &text).and_then(|s| s.problem()).expect("a scenario");
    run_conditioner(&problem, method).expect("a run")
}

const FORMS: [PathMethod; 3] = [PathMethod::SlidingMode, PathMethod::SlidingModePaper, PathMethod::SlidingModeImplicit];

#[test]
fn every_sample_of_a_run_is_a_whole_period_after_the_one_before() {
    for method in FORMS {
        // 2.6 s are 866.67 periods, and 2600.
        for (period, step, count) in [("3e-3", 3e-3, 867), ("1e-3", 1e-3, 2601)] {
            let trace = run(method, period, "0.1 * lambda", "5");
            assert_eq!(trace.samples.len(), count, "{method} {period}");
            for pair in trace.samples.windows(2) {
                // Sums of thousands of periods.
                let (time, parameter) = (pair[1].t - pair[0].t, pair[1].lambda - pair[0].lambda);
                assert!(
                    (time - step).abs() < 1e-12 && (parameter - step).abs() < 1e-12,
                    "{method} {period}: {parameter}"
                );
            }
            assert!((trace.finish_s.expect("finished") - 2.6).abs() < 1e-9, "{method} {period}: {:?}", trace.finish_s);
        }
    }
}

#[test]
fn the_last_sample_is_as_smooth_as_those_before() {
    let sigma: Vec<f64> =
        run(PathMethod::SlidingModeImplicit, "3e-3", "0.1 * lambda", "5").samples.iter().map(|s| s.sigma[0]).collect();
    let changes: Vec<f64> = sigma.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
    let (last, before) = changes.split_last().expect("samples");
    // The wall is slid along for the last second: over ten samples, 0.03 s, nothing there doubles.
    let usual = before[before.len() - 10..].iter().copied().fold(0.0, f64::max);
    assert!(*last <= 2.0 * usual, "σ changes by {last:e} at the end and by {usual:e} before it");
}

#[test]
fn a_reference_is_not_asked_for_beyond_its_end() {
    for method in FORMS {
        // Not a number beyond 2.6005, while the next sample would be at 2.601.
        let trace = run(method, "3e-3", "sqrt(2.6005 - lambda)", "5");
        assert!(trace.samples.iter().all(|s| s.phase != Phase::Held && s.sigma[0].is_finite()), "{method}");
        assert!(trace.finish_s.is_some());
    }
}

#[test]
fn an_end_between_two_samples_is_reached_if_it_is_within_the_longest_duration() {
    for (max_duration, finished) in [("2.6", true), ("2.599", false), ("2.5", false)] {
        let trace = run(PathMethod::SlidingModeImplicit, "3e-3", "0.1 * lambda", max_duration);
        assert_eq!(trace.finish_s.is_some(), finished, "{max_duration}");
    }
}
