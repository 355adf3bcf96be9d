//! Closed loops around natural motion and constant speed, with right and wrong models.

use slideway_lab::natural::{
    Circle, ControlRun, Controller, NaturalProblem, PathPlace, Ramp, Run, SpeedLaw, TrackingError, limb_problem,
    pa10_problem,
};
use slideway_path::ProblemError;
use slideway_robot::augmented::SpeedFactor;
use slideway_robot::{DynamicsError, InverseMethod, Task};

const NATURAL: SpeedLaw = SpeedLaw::Natural { b: 1.2 };
const CONSTANT: SpeedLaw = SpeedLaw::Constant { path_speed: 0.78 };

fn problem() -> NaturalProblem<2, Circle> {
    limb_problem().expect("built in")
}

/// Far below the smallest determinant on the circle, 0.1 m²: a plain inverse.
const INVERSE: InverseMethod = InverseMethod::Adjugate { epsilon: 1e-6 };

/// Two runs around of 17 s, poles at -10 1/s twice.
fn limb_loop(law: SpeedLaw, mass_errors: [f64; 2]) -> Result<Vec<TrackingError<2>>, ProblemError> {
    let problem = problem();
    let arm = problem.dynamics().expect("masses");
    let model = Box::new(arm.with_mass_errors(&mass_errors).expect("ten per cent"));
    let controller = Controller::ResolvedAcceleration { model, stiffness: 100.0, damping: 20.0 };
    let run = Run { law, ramp: Ramp::new(0.0, 17.0)?, steps: 8500 };
    problem.control(&ControlRun { run, controller, inverse: INVERSE })
}

fn largest<const N: usize>(samples: &[TrackingError<N>]) -> f64 {
    samples.iter().map(|s| s.distance).fold(0.0, f64::max)
}

fn peak_torque(samples: &[TrackingError<2>]) -> f64 {
    samples.iter().filter_map(|s| s.torque).map(|t| t.amax()).fold(0.0, f64::max)
}

#[test]
fn with_the_right_model_the_loop_keeps_the_path_and_its_torque_is_that_of_the_flow() -> Result<(), ProblemError> {
    for law in [NATURAL, CONSTANT] {
        let samples = limb_loop(law, [0.0; 2])?;
        // Runge-Kutta with 2 ms, acceleration's fastest change some 10 rad/s: (0.02)⁴ / 120 a step, 17 s: below 1e-7 m.
        assert!(largest(&samples) <= 1e-7, "{}", largest(&samples));
        let run = Run { law, ramp: Ramp::new(0.0, 17.0)?, steps: 8500 };
        let exact = problem().follow(&run)?.metrics().peak_torque.expect("masses");
        assert!((peak_torque(&samples) - exact).abs() <= 1e-4 * exact);
    }
    Ok(())
}

#[test]
fn links_misjudged_by_ten_per_cent_each_its_own_way_leave_natural_motion_nearer_to_the_path() -> Result<(), ProblemError>
{
    for errors in [[0.1, -0.1], [-0.1, 0.1]] {
        let natural = limb_loop(NATURAL, errors)?;
        let constant = limb_loop(CONSTANT, errors)?;
        // [N] reports 0.6 mm beside 1.5 mm and neither gains nor signs. A loop of time constant 0.1 s answers slow
        // disturbances with 0.01 s² times them: both errors scale with the gains, their ratio does not. The
        // paper's ratio is 2.5; at least 2 is asked for.
        assert!(2.0 * largest(&natural) < largest(&constant), "{} {}", largest(&natural), largest(&constant));
        assert!(5.0 * peak_torque(&natural) < peak_torque(&constant));
    }
    Ok(())
}

#[test]
fn links_misjudged_by_the_same_ten_per_cent_leave_constant_speed_as_near_to_the_path_but_not_its_torque()
-> Result<(), ProblemError> {
    for errors in [[0.1; 2], [-0.1; 2]] {
        let natural = limb_loop(NATURAL, errors)?;
        let constant = limb_loop(CONSTANT, errors)?;
        // What the model misses is then a tenth of the motion's own acceleration in the workspace, where constant speed is smooth.
        assert!(largest(&natural) > 0.5 * largest(&constant), "{} {}", largest(&natural), largest(&constant));
        assert!(5.0 * peak_torque(&natural) < peak_torque(&constant));
    }
    Ok(())
}

#[test]
fn inverse_jacobian_controller_draws_the_pa10_onto_its_path_and_keeps_it() -> Result<(), ProblemError> {
    let inverse = InverseMethod::Adjugate { epsilon: 1e-9 };
    let run = Run { law: SpeedLaw::Natural { b: 1.361 }, ramp: Ramp::new(2.0, 20.0)?, steps: 2000 };
    let controller = Controller::InverseJacobian { gain: 5.0 };
    let problem = pa10_problem().expect("built in");
    let exact = problem.control(&ControlRun { run, controller: controller.clone(), inverse })?;
    // Steps of 10 ms at rates of a few rad/s: (0.03)⁵ a step, 2000 of them.
    assert!(largest(&exact) <= 1e-6, "{}", largest(&exact));
    Ok(())
}

#[test]
fn resolved_acceleration_without_masses_is_an_error() -> Result<(), ProblemError> {
    let problem = problem();
    let model = Box::new(problem.dynamics().expect("masses").clone());
    let start = PathPlace { q: problem.start().q, parameter: problem.start().parameter };
    let bare = NaturalProblem::new(
        problem.arm().clone(),
        Task::PlanarPosition,
        SpeedFactor::Determinant,
        *problem.path(),
        start,
    )
    .expect("square");
    let run = Run { law: NATURAL, ramp: Ramp::new(0.0, 1.0)?, steps: 10 };
    let controller = Controller::ResolvedAcceleration { model, stiffness: 1.0, damping: 1.0 };
    assert!(bare.control(&ControlRun { run, controller, inverse: INVERSE }).is_err());
    Ok(())
}

#[test]
fn a_model_without_positive_masses_is_refused() {
    let problem = problem();
    let refused = problem.dynamics().expect("masses").with_mass_errors(&[-1.5, 0.0]);
    assert!(matches!(refused, Err(DynamicsError::Link { link: 0, .. })));
}
