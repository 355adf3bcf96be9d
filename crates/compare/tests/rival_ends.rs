//! Rivals and conditioner end at the same sample, whether or not the sampling period divides the reference's duration.

use slideway_compare::rivals::{potential_field_trace, projection_trace, qp_filter_trace};
use slideway_lab::conditioning::{PathMethod, distances, run_conditioner};
use slideway_scenario::ConditioningScenario;

#[test]
fn every_rival_has_the_samples_of_the_conditioner() {
    // 866.67 periods; 1300, whose sum is off by rounding; a quotient of 2 whose product falls short of the duration.
    for (period, count) in [("3e-3", 867), ("2e-3", 1301), ("1.3", 3)] {
        let text = format!(
            r#"
            [reference]
            end = 2.6
            rate = 1
            position.formula = {{ x = "0.1 * lambda", y = "0.1 * sin(lambda)", z = "0" }}
            [[constraint]]
            name = "wall"
            approach = 2
            shape.half-space = {{ normal = [0, 1, 0], offset = 0.2 }}
            [conditioner]
            sampling_period = {period}
            push_cutoff = 0.5
            law.normalised.amplitude = 0.1
            "#
        );
        let problem = ConditioningScenario::parse("end", &text).and_then(|s| s.problem()).expect("a scenario");
        let conditioned = run_conditioner(&problem, PathMethod::SlidingModeImplicit).expect("a run");
        assert_eq!(conditioned.samples.len(), count, "{period}");
        let projected = projection_trace(&problem).expect("a wall").trace;
        for rival in [qp_filter_trace(&problem), potential_field_trace(&problem), projected] {
            assert!(distances(&conditioned, &rival).is_some(), "{}, {period}: other samples", rival.method);
            let apart = (conditioned.finish_s.expect("finished") - rival.finish_s.expect("finished")).abs();
            assert!(apart < 1e-9, "{}, {period}: other ends, {apart}", rival.method);
        }
    }
}
