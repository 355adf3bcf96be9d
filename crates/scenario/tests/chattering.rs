//! The bound on the change of the desired joint speed holds whatever cuts the path rate.

use slideway_lab::{Method, Sample, Trace};
use slideway_scenario::Scenario;

const ARM: &str = "robot.dh = [{ a = 0.5, alpha = 0, d = 0 }, { a = 0.4, alpha = 0, d = 0 }]\n";

/// At full rate from the first sample: nothing but the tool's limit ever changes the path rate.
const CAPPED_ALL_ALONG: &str = "
    path.joints.line = { from = [0, 3.1], to = [12.4, 0] }
    limits = { speed = 50, tool_speed = 1, start_rate = 0.35 }
    control = { gain = 10, sampling_period = 2e-3, bandwidth = 0.5, target_rate = 0.35 }
";

/// From rest, the joints' limits and the tool's in turn.
const CAPPED_BY_TURNS: &str = "
    path.joints.spline = { points = [[0, 0.9], [0.9, -1], [1.4, 0.3], [2.5, 0.8]], spacing = 'uniform' }
    limits = { speed = 1, tool_speed = 0.6 }
    control = { gain = 10, sampling_period = 1e-3, bandwidth = 50, target_rate = 3 }
";

fn run(text: &str, method: Method) -> (Trace, f64) {
    let scenario = Scenario::parse("test", &format!("{ARM}{text}")).expect("parses");
    let experiment = scenario.experiment().expect("valid");
    (experiment.run(method).expect("runs"), experiment.control().target_rate)
}

/// By how much rounding may lift a measured change over its bound: every term is rounded a few times, none is larger than the sizes of
/// `A` and `B` at both samples. The limits are at least 1 rad/s, so shares of them are no larger.
fn rounding(pair: &[Sample]) -> f64 {
    let size =
        |s: &Sample| s.split.feedback.iter().chain(&s.split.feedforward).fold(0.0_f64, |most, v| most.max(v.abs()));
    16.0 * f64::EPSILON * (size(&pair[0]) + size(&pair[1]))
}

#[test]
fn the_chattering_bound_holds_at_every_sample_at_which_the_tool_s_limit_caps_the_path_rate() {
    for text in [CAPPED_ALL_ALONG, CAPPED_BY_TURNS] {
        for method in [Method::SlidingMode, Method::SlidingModeSynchronised, Method::SlidingModeImplicit] {
            let (trace, target) = run(text, method);
            let capped = |s: &Sample| s.path_rate < 0.999 * s.direction_factor * s.factor * target;
            assert!(trace.samples.iter().filter(|s| capped(s) && s.chatter.is_some()).count() > 500, "{method}");
            for pair in trace.samples.windows(2) {
                let Some(chatter) = pair[1].chatter else { continue };
                let (measured, bound) = (chatter.measured, chatter.bound);
                assert!(measured <= bound + rounding(pair), "{method} at {} s: {measured} > {bound}", pair[1].t);
            }
        }
    }
}

#[test]
fn a_change_of_the_cap_alone_is_the_whole_of_its_bound() {
    // No tracking error and a straight line of the joints: A = 0 and B constant, so the bound is |B Δg| and nothing is given away.
    let (trace, _) = run(CAPPED_ALL_ALONG, Method::SlidingModeImplicit);
    let chatters: Vec<_> = trace.samples.iter().filter_map(|s| s.chatter).filter(|c| c.measured > 1e-6).collect();
    assert!(chatters.len() > 500);
    // The lag that rounding leaves in A is 1e-12 of a limit at most, a millionth of what is looked at.
    assert!(chatters.iter().all(|c| c.bound <= c.measured * (1.0 + 1e-6)));
}
