//! What the text and Fig. 3 of `[N]` say in numbers beside the tables.

use slideway_lab::natural::{
    ControlRun, Controller, Ramp, Run, SpeedLaw, TABLE_1_INTERVAL, limb_problem, pa10_problem,
};
use slideway_lab::{Agreement, Published};
use slideway_path::ProblemError;
use slideway_robot::InverseMethod;
use std::f64::consts::PI;

const GAINS: &str = "links misjudged by +10 % and -10 %, poles at -10 1/s: the paper prints neither its gains nor the errors' \
signs, the ratio depends on the signs";

pub(super) fn rows() -> Result<Vec<Published>, ProblemError> {
    Ok(vec![
        Published {
            source: "[N] section III B",
            case: "PA-10".into(),
            quantity: "closest distance to the base axis",
            unit: "m",
            paper: 0.07,
            ours: Some(closest_distance()?),
            tolerance: 0.01,
            expected: Agreement::Agrees,
            remark: "",
        },
        Published {
            source: "[N] Fig. 3",
            case: "2R, wrong model".into(),
            quantity: "peak error, constant speed over natural motion",
            unit: "",
            paper: 1.5 / 0.6,
            ours: Some(
                peak_error(SpeedLaw::Constant { path_speed: 0.78 })? / peak_error(SpeedLaw::Natural { b: 1.2 })?,
            ),
            tolerance: 0.1,
            expected: Agreement::Differs,
            remark: GAINS,
        },
    ])
}

/// Of the wrist, over a cycle, m.
fn closest_distance() -> Result<f64, ProblemError> {
    let problem = pa10_problem().map_err(|error| ProblemError::value("robot", error))?;
    let survey = problem.survey(3.0 * PI)?;
    let distance = |q| problem.arm().frames(q).origins[4].xy().norm();
    Ok(survey.points.iter().map(|p| distance(&p.place.q)).fold(f64::INFINITY, f64::min))
}

/// Largest distance from the path under resolved acceleration with a wrong model, m.
fn peak_error(law: SpeedLaw) -> Result<f64, ProblemError> {
    let robot = |error| ProblemError::value("robot", error);
    let problem = limb_problem().map_err(robot)?;
    let run = Run { law, ramp: Ramp::new(0.0, TABLE_1_INTERVAL)?, steps: 8500 };
    let Some(arm) = problem.dynamics() else { return Ok(f64::NAN) };
    let wrong = arm.with_mass_errors(&[0.1, -0.1]).map_err(|error| robot(error.into()))?;
    let controller = Controller::ResolvedAcceleration { model: Box::new(wrong), stiffness: 100.0, damping: 20.0 };
    let inverse = InverseMethod::Adjugate { epsilon: 1e-6 };
    let samples = problem.control(&ControlRun { run, controller, inverse })?;
    Ok(samples.iter().map(|s| s.distance).fold(0.0, f64::max))
}
