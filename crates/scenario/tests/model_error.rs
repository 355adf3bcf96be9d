//! Laws followed by computed torque with a right and a wrong model.

use slideway_lab::{Course, Experiment, Method};
use slideway_scenario::{Scenario, ScenarioError};

const LAWS: [Method; 3] = [Method::ConstantSpeed, Method::NaturalMotion, Method::SlidingModeImplicit];

fn experiment(name: &str) -> Result<Experiment, ScenarioError> {
    Scenario::built_in(name).expect("built in")?.experiment()
}

fn course(experiment: &Experiment, law: Method) -> Result<Course, ScenarioError> {
    Ok(experiment.course(&experiment.run(law)?))
}

fn peak(experiment: &Experiment, course: &Course, share: f64) -> Result<f64, ScenarioError> {
    Ok(experiment.follow_with_wrong_masses(course, share)?.expect("masses and no corner").peak())
}

#[test]
fn with_the_right_masses_the_tool_stays_where_the_law_has_it() -> Result<(), ScenarioError> {
    let experiment = experiment("natural-2r")?;
    for law in LAWS {
        // Between two samples the course is a parabola, which Runge-Kutta integrates exactly: only rounding is left. The
        // accelerations, at most 1e4 rad/s² (the start from rest), pass through the mass matrix and back with 1e-16 times its
        // condition, below 100, and the loop answers with a hundredth: 1e-12 rad. Positions of a few rad are rounded
        // once a step, of which the loop remembers some 500: 5e-13 rad. The tool's lever is 2 m.
        let peak = peak(&experiment, &course(&experiment, law)?, 0.0)?;
        assert!(peak <= 1e-11, "{law}: {peak}");
    }
    Ok(())
}

#[test]
fn error_grows_in_proportion_to_a_small_share_whatever_its_sign() -> Result<(), ScenarioError> {
    let experiment = experiment("natural-2r")?;
    for law in LAWS {
        let course = course(&experiment, law)?;
        let one = peak(&experiment, &course, 1e-5)?;
        // What is left out is of the order of the share times the mass matrix' condition, below 100: 1e-3.
        for (share, times) in [(2e-5, 2.0), (-1e-5, 1.0)] {
            let found = peak(&experiment, &course, share)?;
            assert!((found - times * one).abs() <= 4e-3 * times * one, "{law}: {found} {one}");
        }
    }
    Ok(())
}

#[test]
fn motion_in_another_time_has_the_same_way_and_speeds_in_proportion() -> Result<(), ScenarioError> {
    let experiment = experiment("natural-2r")?;
    let course = course(&experiment, Method::NaturalMotion)?;
    let slow = course.in_time(3.0 * course.seconds());
    // Sums of thousands of intervals, each rounded to 1e-16 of the sum.
    assert!((slow.seconds() - 3.0 * course.seconds()).abs() <= 1e-11 * slow.seconds());
    let ends = |c: &Course| {
        let run = experiment.follow_with_wrong_masses(c, 0.0).expect("follows").expect("masses");
        run.samples.last().expect("samples").lambda
    };
    assert!((ends(&course) - ends(&slow)).abs() <= 1e-11);
    for (fast, slow) in course.samples.iter().zip(&slow.samples) {
        assert!((slow.speed[1] * 3.0 - fast.speed[1]).abs() <= 1e-14 * fast.speed[1].abs());
        assert!((slow.acceleration[1] * 9.0 - fast.acceleration[1]).abs() <= 1e-14 * fast.acceleration[1].abs());
    }
    Ok(())
}

#[test]
fn arm_without_masses_is_not_followed_and_one_left_without_them_is_refused() -> Result<(), ScenarioError> {
    let (limb, pa10) = (experiment("natural-2r")?, experiment("natural-pa10")?);
    let followed = pa10.follow_with_wrong_masses(&course(&pa10, Method::NaturalMotion)?, 0.1)?;
    assert!(followed.is_none());
    assert!(limb.follow_with_wrong_masses(&course(&limb, Method::NaturalMotion)?, 1.5).is_err());
    Ok(())
}

#[test]
fn joint_speed_that_jumps_is_not_followed() -> Result<(), ScenarioError> {
    let limb = experiment("natural-2r")?;
    let mut course = course(&limb, Method::NaturalMotion)?;
    course.samples[100].speed[0] += 1e-3;
    assert!(limb.follow_with_wrong_masses(&course, 0.1)?.is_none());
    Ok(())
}
