//! Constant speed, natural motion, sliding mode and the optimum on the same path under the same joint-speed limits.

use slideway_baselines::time_optimal::time_optimum;
use slideway_lab::natural::{NaturalProblem, Survey, TABLE_1_INTERVAL, limb_problem, pa10_problem};
use slideway_lab::{Method, MethodSummary};
use slideway_path::{CartesianPath, ProblemError};
use slideway_robot::augmented::SpeedFactor;
use slideway_scenario::{Scenario, ScenarioError};
use std::f64::consts::PI;

/// Seconds that one cycle takes under each law.
struct Cycle {
    optimum: f64,
    sliding: [MethodSummary; 2],
    natural: f64,
    constant: f64,
}

/// Robot and tool path of a built-in scenario, with the robot's masses if it has any.
fn natural<const N: usize>(name: &str, factor: SpeedFactor) -> Result<NaturalProblem<N, CartesianPath>, ScenarioError> {
    let problem = scenario(name)?.problem::<N>()?;
    let natural = NaturalProblem::of(&problem.path, factor)?;
    Ok(problem.dynamics.into_iter().fold(natural, NaturalProblem::with_dynamics))
}

fn scenario(name: &str) -> Result<Scenario, ScenarioError> {
    Scenario::built_in(name).expect("built in")
}

fn cycle<const N: usize>(name: &str, limit: f64, survey: &Survey<N>) -> Result<Cycle, ScenarioError> {
    let experiment = scenario(name)?.experiment()?;
    let optimum = time_optimum(&experiment.sample(1000, 3)?).expect("solved");
    assert!(optimum.is_certified(), "{}", optimum.gap());
    let run = |method| -> Result<MethodSummary, ScenarioError> { Ok(MethodSummary::new(&experiment.run(method)?)) };
    Ok(Cycle {
        optimum: optimum.duration_s,
        sliding: [run(Method::SlidingMode)?, run(Method::SlidingModeImplicit)?],
        natural: survey.duration(survey.b_for_speed(limit)),
        constant: 2.0 * PI / survey.path_speed_for_speed(limit),
    })
}

fn close(found: f64, wanted: f64, share: f64) -> bool {
    (found - wanted).abs() <= share * wanted
}

/// The order of the laws, and how near the sliding mode comes to the optimum.
fn assert_order(cycle: &Cycle) {
    for summary in &cycle.sliding {
        let travel = summary.travel_s().expect("arrives");
        assert!(travel >= cycle.optimum * (1.0 - 1e-3), "{travel}: faster than the optimum is off the path");
        assert!(travel <= 1.01 * cycle.optimum, "{travel} {}", cycle.optimum);
        assert!(travel < cycle.natural && cycle.natural < cycle.constant);
        // Desired joint speeds leave the limits by no more than the rigorous bound on one sample's change.
        let bound = 1.0 + summary.chattering.expect("regulated").bound;
        assert!(summary.limit_ratio_peak <= bound, "{} {bound}", summary.limit_ratio_peak);
    }
}

#[test]
fn on_the_limbs_circle_sliding_mode_is_within_a_hundredth_of_the_optimum_and_faster_than_natural_motion()
-> Result<(), ScenarioError> {
    let problem = natural::<2>("natural-2r", SpeedFactor::Determinant)?;
    assert!(problem.dynamics().is_some());
    let cycle = cycle("natural-2r", 2.9, &problem.survey(8.0 * PI / 3.0)?)?;
    // Values of an independent simulation.
    assert!(close(cycle.optimum, 1.759, 0.001), "{}", cycle.optimum);
    assert!(close(cycle.natural, 2.450, 0.003), "{}", cycle.natural);
    assert!(close(cycle.constant, 8.052, 0.003), "{}", cycle.constant);
    assert_order(&cycle);
    Ok(())
}

#[test]
fn on_the_pa10s_circle_sliding_mode_is_within_a_hundredth_of_the_optimum_and_faster_than_natural_motion()
-> Result<(), ScenarioError> {
    let factor = SpeedFactor::Arm { scale: 0.45 * 0.5 };
    let problem = natural::<6>("natural-pa10", factor)?;
    let cycle = cycle("natural-pa10", 0.803, &problem.survey(3.0 * PI)?)?;
    assert!(close(cycle.optimum, 4.635, 0.001), "{}", cycle.optimum);
    assert!(close(cycle.natural, 7.507, 0.003), "{}", cycle.natural);
    assert!(close(cycle.constant, 22.88, 0.003), "{}", cycle.constant);
    assert_order(&cycle);
    Ok(())
}

/// The scenarios are written with numbers; the tables' problems compute them. Both begin at the same place and go the same way.
#[test]
fn scenarios_are_the_problems_of_the_tables() -> Result<(), ScenarioError> {
    let limb = natural::<2>("natural-2r", SpeedFactor::Determinant)?;
    let table = limb_problem().expect("built in");
    let end = limb.start().parameter + 0.1 * TABLE_1_INTERVAL;
    let last = |points: &[slideway_lab::natural::SurveyPoint<2>]| points.last().map(|p| p.place.q).expect("points");
    let (a, b) = (last(&limb.survey(end)?.points), last(&table.survey(end)?.points));
    // The scenario's start comes from iterated inverse kinematics, to 1e-9 or better.
    assert!((a - b).norm() <= 1e-8, "{a} {b}");
    let factor = SpeedFactor::Arm { scale: 0.45 * 0.5 };
    let arm = natural::<6>("natural-pa10", factor)?;
    let table = pa10_problem().expect("built in");
    let last = |points: &[slideway_lab::natural::SurveyPoint<6>]| points.last().map(|p| p.place.q).expect("points");
    let (a, b) = (last(&arm.survey(4.0)?.points), last(&table.survey(4.0)?.points));
    assert!((a - b).norm() <= 1e-8, "{a} {b}");
    Ok(())
}

#[test]
fn lock_of_a_joint_that_is_not_there_points_at_its_key() {
    let text = scenario("natural-pa10").expect("parses").text().replace("joint3", "joint9");
    let refused = Scenario::parse("test", &text).expect("parses").experiment().expect_err("no such joint");
    assert_eq!(refused.key(), Some("robot.locked.joint9"));
}

#[test]
fn natural_motion_of_an_arm_with_a_joint_too_many_is_refused() {
    let text =
        scenario("puma-helix-on-path").expect("parses").text().replace("[robot]", "[robot]\ntask = \"position\"");
    let text = text.replace("[robot.inverse.adjugate]\nepsilon = 1e-5", "[robot.inverse.truncated-svd]\ncutoff = 1e-3");
    let scenario = Scenario::parse("test", &text).expect("parses");
    let path = scenario.problem::<6>().expect("valid").path;
    let refused = NaturalProblem::of(&path, SpeedFactor::Determinant);
    assert!(matches!(refused, Err(ProblemError::Value { key, .. }) if key == "robot.task"));
}
