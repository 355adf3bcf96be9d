//! What runs cost the drives: scaling laws of natural motion, agreement with the law's own metrics, and what is left out.

use slideway_lab::natural::{NaturalProblem, Ramp, Run, SpeedLaw};
use slideway_lab::{Effort, Experiment, Method};
use slideway_path::ProblemError;
use slideway_robot::augmented::SpeedFactor;
use slideway_scenario::{Scenario, ScenarioError};
use std::f64::consts::PI;

fn experiment(table: &str) -> Result<Experiment, ScenarioError> {
    let scenario = Scenario::built_in("natural-2r").expect("built in")?;
    Scenario::parse("test", &scenario.text().replace("factor = \"determinant\"", table))?.experiment()
}

fn effort(table: &str, method: Method) -> Result<Effort, ScenarioError> {
    let experiment = experiment(table)?;
    Ok(experiment.course(&experiment.run(method)?).effort().expect("moves"))
}

fn close(found: f64, wanted: f64, share: f64) -> bool {
    (found - wanted).abs() <= share * wanted.abs()
}

#[test]
fn at_half_the_speed_torque_energy_and_acceleration_are_a_quarter() -> Result<(), ScenarioError> {
    for method in [Method::NaturalMotion, Method::ConstantSpeed] {
        let (whole, half) = (effort("share = 1", method)?, effort("share = 0.5", method)?);
        assert!(close(half.peak_joint_speed, 0.5 * whole.peak_joint_speed, 1e-4));
        assert!(close(half.rms_acceleration, 0.25 * whole.rms_acceleration, 1e-4));
        // Differences over 1 ms of a motion that changes at some 10 rad/s: (0.01)² / 24 of the acceleration, and no more
        // than ten times that where it peaks.
        assert!(close(half.peak_torque.expect("masses"), 0.25 * whole.peak_torque.expect("masses"), 1e-4));
        assert!(close(half.energy.expect("masses"), 0.25 * whole.energy.expect("masses"), 1e-4));
    }
    Ok(())
}

#[test]
fn effort_from_samples_is_that_of_the_law_itself() -> Result<(), ScenarioError> {
    let scenario = Scenario::built_in("natural-2r").expect("built in")?;
    let problem = scenario.problem::<2>()?;
    let natural = NaturalProblem::of(&problem.path, SpeedFactor::Determinant)?;
    let problem = natural.with_dynamics(problem.dynamics.expect("rods have masses"));
    let survey = problem.survey(8.0 * PI / 3.0)?;
    let b = survey.b_for_speed(2.9);
    let seconds = survey.duration(b);
    let run = Run { law: SpeedLaw::Natural { b }, ramp: Ramp::new(0.0, seconds)?, steps: 20_000 };
    let exact = problem.follow(&run)?.metrics();
    let found = effort("factor = \"determinant\"", Method::NaturalMotion)?;
    // Samples of 1 ms miss a peak by less than (0.005)² of it, where it lies inside, and at an end, as here, by half a
    // sample's change: 0.5 ms at 10 rad/s.
    assert!(close(found.peak_joint_speed, exact.peak_joint_speed, 5e-3));
    assert!(close(found.peak_torque.expect("masses"), exact.peak_torque.expect("masses"), 5e-3));
    assert!(close(found.energy.expect("masses"), exact.mean_power.expect("masses") * seconds, 1e-3));
    Ok(())
}

#[test]
fn start_from_rest_of_a_regulated_method_is_left_out() -> Result<(), ScenarioError> {
    let experiment = experiment("factor = \"determinant\"")?;
    let course = experiment.course(&experiment.run(Method::SlidingModeImplicit)?);
    let change = |a: &[f64]| a.iter().map(|x| x * x).sum::<f64>().sqrt();
    let all = course.samples.iter().map(|s| change(&s.acceleration)).fold(0.0, f64::max);
    let counted = course.under_way().map(|s| change(&s.acceleration)).fold(0.0, f64::max);
    assert!(course.settled_s > 0.0 && counted < 0.5 * all, "{counted} {all}");
    Ok(())
}

#[test]
fn limits_scaled_scale_the_speed_of_every_law() -> Result<(), ScenarioError> {
    let whole = experiment("factor = \"determinant\"")?;
    let half = whole.with_speed_limits_scaled(0.5)?;
    for method in [Method::ConstantSpeed, Method::NaturalMotion] {
        let seconds = |e: &Experiment| Ok::<_, ScenarioError>(e.run(method)?.finish_s.expect("ends"));
        // The survey is the same to its last bit but for one division.
        assert!(close(seconds(&half)?, 2.0 * seconds(&whole)?, 1e-12));
    }
    assert!(whole.with_speed_limits_scaled(0.0).is_err() && whole.with_speed_limits_scaled(f64::NAN).is_err());
    Ok(())
}

#[test]
fn without_the_table_the_laws_are_not_among_the_methods_and_cannot_be_run() -> Result<(), ScenarioError> {
    let scenario = Scenario::built_in("puma-helix-on-path").expect("built in")?;
    let experiment = scenario.experiment()?;
    assert!(!experiment.methods().iter().any(|m| m.surveys_the_path()));
    let refused = experiment.run(Method::NaturalMotion);
    assert!(matches!(refused, Err(ProblemError::Value { key, .. }) if key == "natural"));
    Ok(())
}
