//! Optima of whole paths that are known from elsewhere: in closed form, or by solving with other means on ten times as many cells.

use slideway_compare::{CertifiedFor, SpeedComparison, SpeedOptions, VerdictStatus, compare_speed, unwatched};
use slideway_lab::Experiment;
use slideway_scenario::Scenario;

fn compared(name: &str, text: &str) -> (Experiment, SpeedComparison) {
    let experiment = Scenario::parse(name, text).expect("a scenario").experiment().expect("an experiment");
    let options = SpeedOptions { grid_points: 100, ..SpeedOptions::named(name) };
    let comparison = compare_speed(&experiment, &options, &mut unwatched).expect("a comparison");
    (experiment, comparison)
}

/// Checks that the bracket is what it says and contains a time known to a share of it.
fn contains(name: &str, text: &str, seconds: f64, known: f64, certified_for: CertifiedFor) {
    let (experiment, comparison) = compared(name, text);
    let optimum = &comparison.summary.optimum;
    println!(
        "{name}: {seconds} in [{}, {}], {:?}, {:?}",
        optimum.lower_s, optimum.upper_s, optimum.cells, optimum.spline
    );
    assert_eq!(optimum.certified_for, certified_for, "{name}: {:?}", optimum.nodes_because);
    assert!(optimum.certified && optimum.gap <= 1e-5, "{name}: {:?}", optimum.stop);
    assert_eq!(optimum.duration_s, optimum.upper_s);
    assert!(optimum.lower_s <= seconds * (1.0 + known), "{name}: {} above {seconds}", optimum.lower_s);
    assert!(optimum.upper_s >= seconds * (1.0 - known), "{name}: {} below {seconds}", optimum.upper_s);
    keeps_the_limits(name, &experiment, &comparison);
}

/// The motion of the upper bound keeps every limit at every sample, ends where the path does and moves as its speeds say.
fn keeps_the_limits(name: &str, experiment: &Experiment, comparison: &SpeedComparison) {
    let motion = comparison.optimum_motion(experiment).expect("a motion");
    let last = motion.samples.last().expect("samples");
    // The upper bound is the time of the profile with what is rounded upwards, under speed limits alone over whole cells.
    let optimum = &comparison.summary.optimum;
    assert!(
        last.t >= optimum.lower_s * (1.0 - 1e-12) && last.t <= optimum.upper_s * (1.0 + 1e-12),
        "{name}: {}",
        last.t
    );
    for sample in &motion.samples {
        let share = sample.limit.as_ref().expect("limited").share;
        assert!(share <= 1.0 + 1e-9, "{name}: {share} of {:?} at {} s", sample.limit, sample.t);
    }
    for joint in 0..motion.joint_names.len() {
        let (mut way, mut apart) = (0.0, 0.0);
        for pair in motion.samples.windows(2) {
            let [a, b] = [&pair[0].joints, &pair[1].joints];
            let moved = b.q[joint] - a.q[joint];
            way += moved.abs();
            apart += (moved - 0.5 * (pair[1].t - pair[0].t) * (a.speed[joint] + b.speed[joint])).abs();
        }
        // Positions and speeds tell of the same motion, but for what accelerations do within samples.
        assert!(apart <= 1e-3 * way + 1e-9, "{name}: joint {joint}: {apart} of {way}");
    }
}

#[test]
fn optima_of_lines_with_blends_and_at_rest_are_bracketed_for_the_whole_path() {
    let path = CertifiedFor::Path;
    contains("blend-0.02", include_str!("planted/blend-0.02.toml"), 5.232_590, 2e-6, path);
    contains("blend-0.002", include_str!("planted/blend-0.002.toml"), 5.522_690, 2e-6, path);
    contains("rest-to-rest", include_str!("planted/rest-to-rest.toml"), 10.001, 1e-9, path);
}

#[test]
fn optima_of_tool_paths_with_kinks_and_standing_parameters_are_bracketed_for_the_spline() {
    let spline = CertifiedFor::Spline;
    contains("kink-abs", include_str!("planted/kink-abs.toml"), 0.581_677, 2e-6, spline);
    contains("path-rate-zero", include_str!("planted/path-rate-zero.toml"), 0.414_110, 2e-6, spline);
}

#[test]
fn the_published_helix_has_its_published_optimum() {
    let text = slideway_scenario::BUILT_IN.iter().find(|b| b.name == "puma-helix").expect("built in").text;
    contains("puma-helix", text, 4.241_20, 2e-6, CertifiedFor::Spline);
}

#[test]
fn a_redundant_arm_takes_the_optimum_of_its_smallest_joint_motion() {
    // Known to 5e-4 from a motion integrated elsewhere.
    let text = include_str!("planted/redundant-four-laps.toml");
    contains("redundant-four-laps", text, 2.7214, 5e-4, CertifiedFor::Spline);
}

#[test]
fn a_tool_path_that_turns_back_takes_twice_the_time_of_one_way_whatever_its_parameter_does() {
    let bounds = |y: &str| {
        let text = format!(
            "robot = {{ model = 'planar-2r', task = 'planar-position', inverse.adjugate.epsilon = 1e-5 }}
             start.near = [0.2, 1.2]
             path = {{ end = 1, position.formula = {{ x = '1.2', y = '{y}', z = '0' }} }}
             limits = {{ speed = 1, acceleration = 2 }}
             control = {{ gain = 10, sampling_period = 1e-3, bandwidth = 50, target_rate = 5 }}
             "
        );
        let (_, comparison) = compared(y, &text);
        let optimum = comparison.summary.optimum;
        assert!(optimum.certified && optimum.certified_for == CertifiedFor::Spline, "{y}: {:?}", optimum.nodes_because);
        [optimum.lower_s, optimum.upper_s]
    };
    let [lower, upper] = bounds("0.1 * (1 - lambda)");
    // Evenly; from a standing start; to a standing end.
    for one_way in ["0.1 * (1 - lambda^2)", "0.1 * (1 - lambda)^3"] {
        let [l, u] = bounds(one_way);
        // Splines through other points of the same line: 1e-6 of its accelerations apart, and so less of its time.
        assert!(l <= upper * (1.0 + 1e-6) && lower <= u * (1.0 + 1e-6), "{one_way}: {l} {u} beside {lower} {upper}");
    }
    // There and back, the parameter standing where the path turns.
    let [l, u] = bounds("0.4 * (lambda - 0.5)^2");
    assert!(l <= 2.0 * upper * (1.0 + 1e-6) && 2.0 * lower <= u * (1.0 + 1e-6), "{l} {u} beside twice {lower} {upper}");
}

#[test]
fn a_bracket_out_of_cells_still_holds_and_names_the_key_and_a_verdict_it_does_not_decide_is_open() {
    let text = include_str!("planted/kink-abs.toml");
    let experiment = Scenario::parse("few", text).expect("a scenario").experiment().expect("an experiment");
    let options = SpeedOptions { grid_points: 100, cells: 300, ..SpeedOptions::named("few") };
    let optimum =
        |options: &SpeedOptions| compare_speed(&experiment, options, &mut unwatched).expect("a comparison").summary;
    let summary = optimum(&options);
    let few = &summary.optimum;
    assert!(!few.certified && few.gap > 1e-5 && few.cells.is_some_and(|cells| cells <= 300), "{few:?}");
    assert!(few.stop.is_some_and(|stop| stop.contains("`optimum.cells`")), "{:?}", few.stop);
    assert!(few.lower_s <= 0.581_677 && 0.581_676 <= few.upper_s, "[{}, {}]", few.lower_s, few.upper_s);
    // A tolerance whose edge is between the ratios of both bounds.
    let (low, high) = (summary.verdict.ratio_lower.expect("arrives"), summary.verdict.ratio_upper.expect("bounded"));
    assert!(low < high && summary.verdict.ratio == Some(low));
    let edge = SpeedOptions { tolerance: 0.5 * (low + high) - 1.0, ..options };
    let verdict = optimum(&edge).verdict;
    assert_eq!((verdict.status, verdict.holds), (VerdictStatus::Open, false), "{}", verdict.sentence);
    assert!(
        verdict.sentence.starts_with("Open: ") && verdict.sentence.contains("`optimum.gap`"),
        "{}",
        verdict.sentence
    );
}

#[test]
fn what_the_whole_path_does_not_take_is_bracketed_at_the_nodes_and_says_why() {
    let joint = "robot.dh = [{ a = 0.5, alpha = 0, d = 0 }]
        path.joints.line = { from = [0], to = [1] }
        control = { gain = 10, sampling_period = 1e-3, bandwidth = 10, target_rate = 5 }
        ";
    for (limits, why) in [
        ("limits = { speed = 1, tool_speed = 0.4 }", "limits of the tool"),
        ("limits.speed = '1 + 0.1 * lambda'", "limits that vary along the path"),
        ("limits = { speed = [2], speed_lower = [-1] }", "differ between both senses"),
        ("limits = { speed = 1, acceleration = 1, end_rate = 0.5 }", "begins or ends in motion"),
    ] {
        let (_, comparison) = compared("nodes", &format!("{joint}{limits}\n"));
        let optimum = &comparison.summary.optimum;
        assert_eq!(optimum.certified_for, CertifiedFor::Nodes);
        assert!(optimum.nodes_because.as_ref().is_some_and(|said| said.contains(why)), "{:?}", optimum.nodes_because);
        assert_eq!([optimum.lower_s, optimum.upper_s], [optimum.on_grid.lower_s, optimum.on_grid.upper_s]);
        assert!(comparison.whole.is_none() && optimum.cells.is_none());
    }
}
