use super::follow::Run;
use super::law::{Ramp, SpeedLaw};
use super::metrics::NaturalMetrics;
use super::path::Circle;
use super::problem::{NaturalProblem, PathPlace};
use super::table_1::QUANTITIES;
use crate::published::{Agreement, Printed, Published};
use nalgebra::Vector3;
use slideway_path::ProblemError;
use slideway_robot::augmented::SpeedFactor;
use slideway_robot::models::Model;
use slideway_robot::{JointVector, RobotError, Task};
use std::f64::consts::PI;

/// Radius of the circle, m.
const RADIUS: f64 = 0.2;

/// Start and stop, s.
const RISE: f64 = 2.0;

/// Constant `b` of NM-1, rad/s per m.
const B: f64 = 1.361;

/// Two full cycles, as in the text and by NM-1's printed distance, rad. They fix the length of the runs: in the 60 s that
/// the text gives as well, NM-1 covers 3.26 m.
const WAY: f64 = 4.0 * PI;

/// Steps of a run, about 5 ms each.
const STEPS: usize = 10_000;

/// The PA-10 of `[N] section III B`: joint 3 locked at 0, a horizontal circle of 0.2 m whose centre lies 0.2 m in x from the
/// start, orientation kept. The speed factor is `ρ sin q4`, the distance of the wrist from the base axis times the elbow's sine.
///
/// # Errors
///
/// None with the numbers built in.
pub fn pa10_problem() -> Result<NaturalProblem<6, Circle>, RobotError> {
    let arm = Model::Pa10.describe()?.locked("joint3", 0.0)?.arm::<6>()?;
    let q = JointVector::from([15.0_f64, -37.0, 80.0, 15.0, -45.0, -15.0].map(f64::to_radians));
    let tool = arm.forward(&q);
    let centre = tool.translation.vector + Vector3::x() * RADIUS;
    let path = Circle { centre, radius: RADIUS, phase: 0.0, orientation: tool.rotation };
    // Upper arm 0.45 m, forearm 0.5 m.
    let factor = SpeedFactor::Arm { scale: 0.45 * 0.5 };
    NaturalProblem::new(arm, Task::Pose, factor, path, PathPlace { q, parameter: PI })
}

/// A column of the table as printed: distance, peak joint speed, peak torque, power.
struct Column {
    case: &'static str,
    law: SpeedLaw,
    printed: [&'static str; 4],
    /// Expected agreement of distance and peak joint speed.
    expected: [Agreement; 2],
    /// On both.
    remarks: [&'static str; 2],
}

const LENGTH: &str =
    "runs of the length in which NM-1 covers two cycles, 2.51 m as printed; in the 60 s of the text it covers 3.26 m";
const TWO_CYCLES: &str =
    "all runs are taken to be as long as NM-1's two cycles; two cycles at 0.277 rad/s, 2.51 m, take 0.34 s longer";
const INFERRED: &str =
    "the length of the runs is inferred from NM-1's distance, to 0.4 % of it, and the run ends where the tool is fast";
const SPEED: &str = "0.277 rad/s gives 0.810 rad/s; the printed peak belongs to 0.2746 rad/s";
const FROM_SPEED: &str = "b follows from this value";
const INERTIAS: &str = "needs the inertias of the PA-10, which are not published";

/// `[N] Table II` row by row, agreement to one unit of the last printed digit. Torques and powers need inertias that are not published.
///
/// # Errors
///
/// None with the numbers built in.
pub fn table_2() -> Result<Vec<Published>, ProblemError> {
    let problem = pa10_problem().map_err(|error| ProblemError::value("robot", error))?;
    // The ramps at both ends cost as much way as one of them lasts.
    let interval = problem.survey(PI + WAY)?.duration(B) + RISE;
    let cycle = problem.survey(3.0 * PI)?;
    let natural = |peak| SpeedLaw::Natural { b: cycle.b_for_speed(peak) };
    let constant = SpeedLaw::Constant { path_speed: 0.277 };
    let mut rows = Vec::new();
    for Column { case, law, printed, expected, remarks } in columns(constant, natural) {
        let run = Run { law, ramp: Ramp::new(RISE, interval)?, steps: STEPS };
        let NaturalMetrics { distance, peak_joint_speed, .. } = problem.follow(&run)?.metrics();
        let ours = [Some(distance), Some(peak_joint_speed), None, None];
        for (i, (quantity, unit)) in QUANTITIES.into_iter().enumerate() {
            let Printed { value, last_digit } = Printed::new(printed[i]);
            rows.push(Published {
                source: "[N] Table II",
                case: case.to_owned(),
                quantity,
                unit,
                paper: value,
                ours: ours[i],
                tolerance: last_digit,
                expected: expected.get(i).copied().unwrap_or(Agreement::NotComputed),
                remark: remarks.get(i).copied().unwrap_or(INERTIAS),
            });
        }
    }
    Ok(rows)
}

fn columns(constant: SpeedLaw, natural: impl Fn(f64) -> SpeedLaw) -> [Column; 4] {
    use Agreement::{Agrees, Differs};
    [
        Column {
            case: "CS-1",
            law: constant,
            printed: ["2.51", "0.803", "0.75", "486.65"],
            expected: [Differs, Differs],
            remarks: [TWO_CYCLES, SPEED],
        },
        Column {
            case: "NM-1",
            law: SpeedLaw::Natural { b: B },
            printed: ["2.51", "0.268", "0.258", "222.78"],
            expected: [Agrees, Agrees],
            remarks: [LENGTH, ""],
        },
        Column {
            case: "NM-2",
            law: natural(0.803),
            printed: ["7.63", "0.803", "2.27", "5939.3"],
            expected: [Differs, Agrees],
            remarks: [INFERRED, FROM_SPEED],
        },
        Column {
            case: "NM-3",
            law: natural(0.46),
            printed: ["4.18", "0.46", "0.75", "1100.2"],
            expected: [Differs, Agrees],
            remarks: [INFERRED, FROM_SPEED],
        },
    ]
}
