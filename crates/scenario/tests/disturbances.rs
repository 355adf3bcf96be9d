//! The table `[disturbances]`: without it nothing changes, with it the trace tells the truth and the seed tells the run.

use slideway_lab::conditioning::{ConditionedTrace, PathMethod, run_conditioner};
use slideway_lab::{Disturbances, Method, MethodSummary, Trace};
use slideway_scenario::ConditioningScenario;
use slideway_scenario::sweep::{SweepError, SweepPlan, SweepRequest};
use slideway_scenario::{BUILT_IN, Scenario, ScenarioError};

fn text(name: &str) -> &'static str {
    BUILT_IN.iter().find(|b| b.name == name).expect("built in").text
}

fn run(text: &str, method: Method) -> Trace {
    Scenario::parse("test", text).expect("parses").experiment().expect("valid").run(method).expect("runs")
}

fn conditioned(text: &str, method: PathMethod) -> ConditionedTrace {
    let scenario = ConditioningScenario::parse("test", text).expect("parses");
    run_conditioner(&scenario.problem().expect("valid"), method).expect("runs")
}

/// Every bit of a trace. `{:?}` writes the shortest decimal that reads back to the same bits, and tells -0 from 0 and NaN from numbers.
fn bits(trace: &impl std::fmt::Debug) -> String {
    format!("{trace:?}")
}

const ZEROS: &str = "\n[disturbances]\nseed = 9\njoint_noise = 0\ndelay = 0\njitter = 0\n";

#[test]
fn without_disturbances_every_bit_is_what_it_was() {
    for (name, joints) in [("puma-helix", 6), ("planar-bend", 2), ("tiny-motion", 6), ("panda-line", 7)] {
        let none = vec![0.0; joints];
        let zeros =
            format!("{}{ZEROS}initial_error = {none:?}\njoint_offset = {none:?}\nspeed_error = {none:?}\n", text(name));
        let [plain, zeros] =
            [text(name), &zeros].map(|text| Scenario::parse(name, text).expect("parses").experiment().expect("valid"));
        for method in plain.methods() {
            let [before, after] = [&plain, &zeros].map(|experiment| experiment.run(method).expect("runs"));
            assert_eq!(bits(&before), bits(&after), "{name} {method}");
        }
    }
    for name in ["helix-plane-sphere", "trap-ellipsoid"] {
        let zeros = format!("{}{ZEROS}", text(name)).replace("joint_noise", "distance_noise");
        for method in PathMethod::ALL.into_iter().filter(|m| m.is_conditioner()) {
            assert_eq!(bits(&conditioned(text(name), method)), bits(&conditioned(&zeros, method)), "{name} {method}");
        }
    }
}

/// Every disturbance on its own, as the line of the table that asks for it.
const SPEED_LINES: [&str; 6] = [
    "initial_error = [0.01, -0.02]",
    "joint_noise = 1e-3",
    "joint_offset = [1e-3, 0]",
    "speed_error = [0.02, -0.01]",
    "delay = 3",
    "jitter = 0.4",
];

#[test]
fn every_disturbance_changes_the_run_and_a_seed_repeats_it() {
    let plain = text("planar-bend");
    let undisturbed = run(plain, Method::SlidingMode);
    for line in SPEED_LINES {
        let disturbed = |seed: u64| format!("{plain}\n[disturbances]\nseed = {seed}\n{line}\n");
        let [one, again, other] = [1, 1, 2].map(|seed| run(&disturbed(seed), Method::SlidingMode));
        assert_ne!(one, undisturbed, "{line}");
        assert_eq!(bits(&one), bits(&again), "{line}");
        let random = line.starts_with("joint_noise") || line.starts_with("jitter");
        assert_eq!(one != other, random, "{line}");
    }
}

#[test]
fn a_disturbed_experiment_runs_what_the_scenario_with_the_table_runs() {
    let plain = text("planar-bend");
    let experiment = Scenario::parse("test", plain).expect("parses").experiment().expect("valid");
    let disturbances = Disturbances {
        seed: 3,
        initial_error: vec![0.01, 0.0],
        joint_noise: 1e-3,
        joint_offset: vec![-1e-3, 2e-3],
        speed_error: vec![0.0, -0.02],
        delay: 1,
        jitter: 0.2,
    };
    let table = "\n[disturbances]\nseed = 3\ninitial_error = [0.01, 0]\njoint_noise = 1e-3\njoint_offset = [-1e-3, 2e-3]\nspeed_error = [0, -0.02]\ndelay = 1\njitter = 0.2\n";
    let other = experiment.with_disturbances(&disturbances).expect("valid");
    for method in experiment.methods() {
        assert_eq!(bits(&other.run(method).expect("runs")), bits(&run(&format!("{plain}{table}"), method)), "{method}");
    }
}

/// The naive twin: positions are re-integrated from commands, drives and true times, of which the trace has all but the drives.
#[test]
fn true_positions_follow_from_commands_drives_and_true_times() {
    let table =
        "\n[disturbances]\nseed = 4\njoint_noise = 1e-3\nspeed_error = [0.05, -0.03]\ndelay = 2\njitter = 0.5\n";
    let trace = run(&format!("{}{table}", text("planar-bend")), Method::SlidingModeSynchronised);
    let mut shortest = f64::INFINITY;
    let mut longest = 0.0_f64;
    for pair in trace.samples.windows(2) {
        let elapsed = pair[1].t - pair[0].t;
        (shortest, longest) = (shortest.min(elapsed), longest.max(elapsed));
        for (i, drive) in [1.05, 0.97].into_iter().enumerate() {
            let expected = pair[0].q[i] + pair[0].commanded[i] * drive * elapsed;
            // Times are differences of numbers up to 10 s: 2e-15 s each, at speeds up to 10 rad/s; positions up to 4 rad round at 1e-15.
            assert!((pair[1].q[i] - expected).abs() < 1e-13, "{expected} {}", pair[1].q[i]);
        }
    }
    let period = trace.sampling_period;
    assert!(shortest >= 0.5 * period - 1e-14 && longest <= 1.5 * period + 1e-14);
    assert!(shortest < 0.6 * period && longest > 1.4 * period);
}

/// Under a sensor that is off the controller holds what it sees on the path; the error that counts is what is.
#[test]
fn errors_and_arrival_are_judged_on_the_truth() {
    let noisy = format!("{}\n[disturbances]\njoint_noise = 0.02\n", text("planar-bend"));
    let summary = MethodSummary::new(&run(&noisy, Method::SlidingModeSynchronised));
    let plain = MethodSummary::new(&run(text("planar-bend"), Method::SlidingModeSynchronised));
    assert!(summary.peak_path_error_m > 2.0 * plain.peak_path_error_m, "{}", summary.peak_path_error_m);
    // Each command moves a joint by Kp Ts of the noise: an arrival within 0.1 mm is a coincidence that has to be waited for, and the
    // controller itself, seeing the reference 0.02 rad off, would never call it one.
    let experiment = Scenario::parse("test", &noisy).expect("parses").experiment().expect("valid");
    let trace = experiment.run(Method::SlidingModeSynchronised).expect("runs");
    let last = trace.samples.last().expect("samples");
    let distance = last.error[..3].iter().map(|e| e * e).sum::<f64>().sqrt();
    assert_eq!(trace.arrival_s.is_some(), distance <= slideway_lab::ARRIVAL_POSITION);
}

/// It sees itself at the end where it is off by what its zeros are off: there it stands, and nothing is left to wait for.
#[test]
fn a_robot_whose_zeros_are_off_comes_to_rest_beside_the_end_and_its_run_ends() {
    let (plain, offset) = (text("planar-bend"), [0.01, -0.02]);
    let off = format!("{plain}\n[disturbances]\njoint_offset = {offset:?}\n");
    let experiment = Scenario::parse("test", &off).expect("parses").experiment().expect("valid");
    let end = *experiment.tool_path(2).last().expect("an end");
    let judged = [Method::SlidingMode, Method::SlidingModeImplicit, Method::AccelerationLookAhead];
    for method in judged {
        let mut trace = experiment.run(method).expect("runs");
        let (last, finish) = (trace.samples.last_mut().expect("samples"), trace.finish_s.expect("the reference ends"));
        assert!(trace.arrival_s.is_none(), "{method}");
        // ln(1e8) time constants of 0.05 s, and as much again.
        assert!(last.t < finish + 2.0, "{method}: {} {finish}", last.t);
        // Less than 1e-9 rad over tens of seconds is commanded with less than 1e-10 rad to go, on links of 1 m.
        last.q.iter_mut().zip(offset).for_each(|(q, offset)| *q += offset);
        let seen = *experiment.tool_trace(&trace).last().expect("samples");
        assert!(seen.iter().zip(end).all(|(p, e)| (p - e).abs() < 1e-9), "{method}: {seen:?} {end:?}");
    }
}

#[test]
fn the_parts_of_a_demand_are_those_the_controller_saw() {
    let table = "\n[disturbances]\njoint_noise = 1e-3\ndelay = 1\n";
    let trace = run(&format!("{}{table}", text("planar-bend")), Method::SlidingMode);
    let last = trace.following().len() - 1;
    for sample in &trace.following()[..last] {
        for (desired, sum) in sample.desired.iter().zip(sample.split.at(sample.factor)) {
            // Two orders of two products and a sum, of speeds up to 20 rad/s.
            assert!((desired - sum).abs() < 1e-14, "{desired} {sum}");
        }
    }
}

#[test]
fn every_disturbance_of_a_conditioned_run_changes_it_and_a_seed_repeats_it() {
    let plain = format!("{}\n", text("helix-plane-sphere"));
    let moving = plain.replacen(
        "[conditioner]",
        "[constraint.motion.oscillation]\namplitude = [0.01, 0, 0]\nfrequency = 3\n\n[conditioner]",
        1,
    );
    let undisturbed = conditioned(&moving, PathMethod::SlidingMode);
    for line in ["initial_error = [0.01, 0, -0.01]", "distance_noise = 1e-3", "delay = 20", "jitter = 0.4"] {
        let table = |seed: u64| format!("{moving}\n[disturbances]\nseed = {seed}\n{line}\n");
        let [one, again, other] = [1, 1, 2].map(|seed| conditioned(&table(seed), PathMethod::SlidingMode));
        assert_ne!(one, undisturbed, "{line}");
        assert_eq!(bits(&one), bits(&again), "{line}");
        let random = line.starts_with("distance_noise") || line.starts_with("jitter");
        assert_eq!(one != other, random, "{line}");
    }
}

/// The noise is what the conditioner is told; σ in the trace is that of the constraint at the position in the trace.
#[test]
fn a_conditioned_trace_tells_the_true_distance() {
    let noisy = format!("{}\n[disturbances]\ndistance_noise = 1e-3\n", text("helix-plane-sphere"));
    let scenario = ConditioningScenario::parse("test", &noisy).expect("parses");
    let problem = scenario.problem().expect("valid");
    let trace = run_conditioner(&problem, PathMethod::SlidingModeImplicit).expect("runs");
    let mut beyond = f64::NEG_INFINITY;
    for s in &trace.samples {
        let motion = slideway_conditioner::path::Motion { time: s.t, position: s.position, velocity: [0.0; 3] };
        let [plane, ball] = problem.sample::<2>(&motion).map(|s| s.value);
        assert_eq!([plane, ball], [s.sigma[0], s.sigma[1]]);
        beyond = beyond.max(plane).max(ball);
    }
    // The implicit form keeps what it sees: the truth is broken, and by no more than the noise (rounding 1e-9).
    assert!(beyond > 0.0 && beyond <= 1e-3 + 1e-9, "{beyond}");
}

#[test]
fn seeds_of_a_sweep_are_those_of_the_disturbances() {
    let sweep = |table: &str| {
        let text = format!("{}\n[disturbances]\n{table}\n", text("planar-bend"));
        SweepPlan::new(SweepRequest { seeds: Some(2), ..SweepRequest::of("mine", text) })
    };
    let plan = sweep("joint_noise = 1e-3").expect("valid");
    let rows = [0, 1, 0].map(|run| plan.run(run).expect("runs").values);
    assert!(rows[0] != rows[1] && rows[0] == rows[2]);
    // Seed 1 is the scenario's own.
    let own = format!("{}\n[disturbances]\nseed = 1\njoint_noise = 1e-3\n", text("planar-bend"));
    let own = SweepPlan::new(SweepRequest::of("mine", own)).expect("valid").run(0).expect("runs").values;
    assert_eq!(own, rows[0]);
    assert!(matches!(sweep("delay = 2"), Err(SweepError::NothingRandom { .. })));
}

#[test]
fn disturbances_that_cannot_be_meant_are_refused_with_their_key() {
    let refused = |name: &str, line: &str| -> String {
        let (table, entry) = line.split_once('.').expect("a table and a key");
        let text = format!("{}\n[{table}]\n{entry}\n", text(name));
        let error = match name {
            "helix-plane-sphere" => ConditioningScenario::parse("test", &text).and_then(|s| s.problem()).err(),
            _ => Scenario::parse("test", &text).and_then(|s| s.experiment()).err(),
        };
        let error: ScenarioError = error.unwrap_or_else(|| panic!("`{line}` was accepted"));
        assert!(!error.remedy().is_empty());
        error.to_string()
    };
    for (line, says) in [
        ("disturbances.initial_error = [0.1]", "`disturbances.initial_error`: 1 numbers given, 2 needed"),
        ("disturbances.joint_offset = [1, 1.5]", "`disturbances.joint_offset.1`: 1.5 is outside"),
        ("disturbances.speed_error = []", "`disturbances.speed_error`: 0 numbers given, 2 needed"),
        ("disturbances.speed_error = [0, -1]", "`disturbances.speed_error.1`: -1 is outside"),
        ("disturbances.joint_noise = -1e-3", "`disturbances.joint_noise`: -0.001 is outside"),
        ("disturbances.joint_noise = nan", "not a finite number"),
        ("disturbances.delay = -1", "u32"),
        ("disturbances.delay = 2000", "`disturbances.delay`: 2000 is outside"),
        ("disturbances.jitter = 1", "`disturbances.jitter`: 1 is outside"),
        ("disturbances.distance_noise = 1e-3", "unknown field"),
        ("verify.jitter = 1.5", "`verify.jitter`: 1.5 is outside"),
        ("verify.trials = 0", "`verify.trials`: 0 is not positive"),
        ("verify.distance_noise = 1e-3", "unknown field"),
    ] {
        let found = refused("planar-bend", line);
        assert!(found.contains(says), "{line}: {found}");
    }
    for (line, says) in [
        ("disturbances.initial_error = [0.1]", "length 3"),
        ("disturbances.distance_noise = -1e-3", "`disturbances.distance_noise`: -0.001 is outside"),
        ("disturbances.jitter = 1", "`disturbances.jitter`: 1 is outside"),
        ("disturbances.joint_noise = 1e-3", "unknown field"),
        ("verify.delay = 5000", "`verify.delay`: 5000 is outside"),
    ] {
        let found = refused("helix-plane-sphere", line);
        assert!(found.contains(says), "{line}: {found}");
    }
}
