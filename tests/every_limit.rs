//! Every kind of limit that a scenario can give, against closed forms planted in simple motions.

use slideway_baselines::time_optimal::{TimeOptimum, refine_optimum, time_optimum};
use slideway_lab::{Experiment, Method};
use slideway_path::LimitKind;
use slideway_scenario::Scenario;

/// A planar two-joint arm of 1 m links whose joints go straight from `from` to `to`, with the given limits.
fn joint_line(from: &str, to: &str, limits: &str) -> String {
    format!(
        "[robot]\nmodel = \"planar-2r\"\n[path]\nend = 1\njoints.line = {{ from = {from}, to = {to} }}\n[limits]\n{limits}\n\
         [control]\ngain = 10\nsampling_period = 1e-3\nbandwidth = 200\ntarget_rate = 5\n"
    )
}

/// The same arm with its tool going along the x axis from 1.5 m to 1 m.
fn tool_line(limits: &str) -> String {
    format!(
        "[robot]\nmodel = \"planar-2r\"\ntask = \"planar-position\"\ninverse.adjugate.epsilon = 1e-9\n[start]\nnear = [-0.7, 1.4]\n\
         [path]\nend = 1\nposition.line = {{ from = [1.5, 0, 0], to = [1.0, 0, 0] }}\n[limits]\n{limits}\n\
         [control]\ngain = 10\nsampling_period = 1e-3\nbandwidth = 200\ntarget_rate = 5\n"
    )
}

fn experiment(text: &str) -> Experiment {
    let scenario = Scenario::parse("test", text).expect("parses");
    scenario.experiment().unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn optimum(text: &str) -> TimeOptimum {
    let path = experiment(text).sample(400, 3).expect("sampled");
    let optimum = time_optimum(&path).expect("solved");
    assert!(optimum.is_certified(), "{}", optimum.gap());
    optimum
}

/// Error of the grid on a trapezoid: within an interval `b` is linear, so stretches of constant acceleration are exact and only the
/// interval with a corner is off, by less than `a Δs² / v³` in time: 4 · (1/400)² / 0.5³ = 2e-4 s of 2.2 s at the hardest corner here, as a
/// share 1e-4.
const GRID: f64 = 1e-4;

#[test]
fn braking_harder_than_speeding_up_makes_a_lopsided_trapezoid() {
    let text = joint_line("[0, 0]", "[1, 0]", "speed = 0.5\nacceleration = 2\nacceleration_lower = -4");
    // D / v + v / (2 a) + v / (2 d).
    let expected = 1.0 / 0.5 + 0.5 / 4.0 + 0.5 / 8.0;
    let found = optimum(&text).duration_s;
    assert!((found - expected).abs() < GRID * expected, "{found} for {expected}");
    // Backwards the same joint brakes with its upper limit.
    let text = joint_line("[1, 0]", "[0, 0]", "speed = 0.5\nacceleration = 2\nacceleration_lower = -4");
    let found = optimum(&text).duration_s;
    assert!((found - expected).abs() < GRID * expected, "{found} for {expected}");
}

#[test]
fn a_speed_limit_that_grows_along_the_path_gives_a_logarithm() {
    let text = joint_line("[0, 0]", "[1, 0]", "speed = [\"1 + lambda\", 1]");
    let experiment = experiment(&text);
    let path = experiment.sample(400, 0).expect("sampled");
    let found = time_optimum(&path).expect("solved").duration_s;
    // ∫ dλ / (1 + λ) = ln 2; the trapezoidal rule is off by h² / 12 times the change of the derivative, (1 - 1/4) / 400² / 12 < 4e-7.
    assert!((found - 2.0_f64.ln()).abs() < 1e-6, "{found}");
    // The law follows the limit on line: at most one sample of limit drift (a share of Ts) beyond it, and the filter's lag behind it.
    let trace = experiment.run(Method::SlidingModeImplicit).expect("runs");
    let uses = experiment.limit_use(&trace);
    assert_eq!(uses.len(), 1);
    assert_eq!(uses[0].kind, LimitKind::JointSpeed);
    assert!(uses[0].share <= 1.0 + 1e-9, "{uses:?}");
    let ratio = trace.arrival_s.expect("arrives") / found;
    assert!((1.0..1.02).contains(&ratio), "{ratio}");
}

#[test]
fn a_tool_speed_limit_alone_takes_length_over_speed() {
    let text = tool_line("speed = 100\ntool_speed = 0.2");
    let found = optimum(&text).duration_s;
    assert!((found - 0.5 / 0.2).abs() < 1e-9, "{found}");
    let experiment = experiment(&text);
    let trace = experiment.run(Method::SlidingModeSynchronised).expect("runs");
    let uses = experiment.limit_use(&trace);
    let tool = uses.iter().find(|u| u.kind == LimitKind::ToolSpeed).expect("there is one");
    // The joint speed is held over a sample while the arm turns: off by about Ts |q̇| = 1e-3 · 0.5 at most.
    assert!(tool.share <= 1.0 + 5e-4, "{tool:?}");
    assert!((trace.arrival_s.expect("arrives") - 2.5).abs() < 0.02);
}

#[test]
fn a_tool_acceleration_limit_alone_takes_twice_the_root_of_length_over_acceleration() {
    // The direction of motion is the normal of a side of the inscribed polygon with 32 sides.
    let bound = 2.0 * (std::f64::consts::PI / 32.0).cos();
    let expected = 2.0 * (0.5 / bound).sqrt();
    let found = optimum(&tool_line("speed = 100\ntool_acceleration = 2")).duration_s;
    assert!((found - expected).abs() < GRID * expected, "{found} for {expected}");
}

#[test]
fn moving_ends_leave_nothing_to_speed_up() {
    let limits = "speed = 0.5\nacceleration = 2\nstart_rate = 0.5\nend_rate = 0.5";
    let found = optimum(&joint_line("[0, 0]", "[1, 0]", limits)).duration_s;
    assert!((found - 2.0).abs() < 1e-9, "{found}");
    let limits = "speed = 0.5\nacceleration = 2\nstart_rate = 0.5";
    let found = optimum(&joint_line("[0, 0]", "[1, 0]", limits)).duration_s;
    assert!((found - (2.0 + 0.5 / 4.0)).abs() < GRID * found, "{found}");
}

#[test]
fn a_torque_limit_binds_where_inverse_dynamics_says() {
    let limits = "speed = 20\ntorque = [6, 3]";
    let text = joint_line("[0.2, 0.5]", "[1.2, 1.5]", limits);
    let experiment = experiment(&text);
    let path = experiment.sample(300, 3).expect("sampled");
    let refined = refine_optimum(&path, 1e-6).expect("refined").result;
    assert!(refined.is_certified());
    assert!(refined.between.torque <= 1e-6);
    // Somewhere on every interval a drive works at its limit (bang-bang), so the largest use over each node is 1.
    let piece = &path.pieces[0];
    let b = &refined.pieces[0].b;
    let mut tight = 0;
    for k in 0..b.len() - 1 {
        let s_acceleration = (b[k + 1] - b[k]) / (2.0 * (piece.nodes[k + 1].s - piece.nodes[k].s));
        let ends = [(&piece.nodes[k], b[k]), (&piece.nodes[k + 1], b[k + 1])];
        let rows = ends.iter().flat_map(|(node, b)| node.limits.iter().map(move |l| l.excess(s_acceleration, *b)));
        let worst = rows.fold(f64::NEG_INFINITY, f64::max);
        assert!(worst <= 1e-9, "{worst}");
        tight += usize::from(worst > -1e-4);
    }
    assert!(tight + 5 > b.len(), "{tight} of {}", b.len());
}

#[test]
fn what_a_limit_cannot_be_is_told_with_its_key() {
    let cases = [
        ("speed = [1, 0]", "limits.speed.1"),
        ("speed = \"1 - 2 * lambda\"", "limits.speed"),
        ("speed = \"1 / (lambda - 0.5)\"", "limits.speed"),
        ("speed = [1, \"1 + mu + lambda\"]", "limits.speed.1"),
        ("speed = 1\nacceleration = [1, 2, 3]", "limits.acceleration"),
        ("speed = 1\nacceleration = 1\nacceleration_lower = 1", "limits.acceleration_lower"),
        ("speed = 1\nacceleration_lower = -1", "limits.acceleration_lower"),
        ("speed = 1\ntorque = 1\ntorque_lower = 2", "limits.torque"),
        ("speed = 1\ntorque = \"robot\"", "limits.torque"),
        ("speed = 1\ntool_speed = 0", "limits.tool_speed"),
        ("speed = 1\ntool_acceleration = -1", "limits.tool_acceleration"),
        ("speed = 1\nstart_rate = -1", "limits.start_rate"),
    ];
    for (limits, expected) in cases {
        let scenario = Scenario::parse("test", &joint_line("[0, 0]", "[1, 0]", limits)).expect("parses");
        match scenario.experiment() {
            Err(error) => {
                assert_eq!(error.key(), Some(expected), "{limits}: {error}");
                assert!(!error.remedy().is_empty());
            }
            other => panic!("{limits}: {:?}", other.map(|_| "accepted")),
        }
    }
}

#[test]
fn torque_limits_need_masses() {
    let text = joint_line("[0, 0]", "[1, 0]", "speed = 1\ntorque = 1")
        .replace("model = \"planar-2r\"", "dh = [{ a = 1, alpha = 0, d = 0 }, { a = 1, alpha = 0, d = 0 }]");
    let scenario = Scenario::parse("test", &text).expect("parses");
    let error = scenario.experiment().expect_err("no masses");
    assert_eq!(error.key(), Some("limits.torque"), "{error}");
}

#[test]
fn a_path_that_leaves_the_range_of_a_joint_is_told_where_it_is_farthest_outside() {
    let text = joint_line("[0, 0]", "[1, -0.5]", "speed = 1\nposition = [[-0.5, 0.8], [-1, 1]]");
    let excesses = experiment(&text).position_excesses();
    assert_eq!(excesses.len(), 1);
    assert_eq!((excesses[0].joint, excesses[0].lambda, excesses[0].position), (0, 1.0, 1.0));
    let inside = joint_line("[0, 0]", "[1, -0.5]", "speed = 1\nposition = [[-0.5, 1], [-1, 1]]");
    assert!(experiment(&inside).position_excesses().is_empty());
}
