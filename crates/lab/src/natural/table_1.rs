use super::follow::Run;
use super::law::{Ramp, SpeedLaw};
use super::metrics::NaturalMetrics;
use super::path::Circle;
use super::problem::{NaturalProblem, PathPlace};
use crate::published::{Agreement, Printed, Published};
use nalgebra::{Rotation3, Vector3};
use slideway_path::ProblemError;
use slideway_robot::augmented::SpeedFactor;
use slideway_robot::models::Model;
use slideway_robot::{RobotError, Task};
use std::f64::consts::PI;

/// Length of every run of Table I, s.
pub const TABLE_1_INTERVAL: f64 = 17.0;

/// Steps of a run: 1 ms each.
const STEPS: usize = 17_000;

/// The two-joint limb of `[N] section III A`: thin rods of 1 m and 1 kg in the horizontal plane, a circle of 0.7 m through
/// the tip at -60° and 120°.
///
/// The parameter is the angle from the tip to the centre, 120° at the start, so that the circle passes close to the outer
/// boundary; `det J = sin q2`.
///
/// # Errors
///
/// None with the numbers built in.
pub fn limb_problem() -> Result<NaturalProblem<2, Circle>, RobotError> {
    let dynamics = Model::Planar2R.describe()?.dynamics::<2>()?;
    let arm = dynamics.arm().clone();
    let q = [f64::to_radians(-60.0), f64::to_radians(120.0)].into();
    let parameter = f64::to_radians(120.0);
    let radius = 0.7;
    let towards_centre = Vector3::new(parameter.cos(), parameter.sin(), 0.0);
    let centre = arm.forward(&q).translation.vector + towards_centre * radius;
    let path = Circle { centre, radius, phase: PI, orientation: Rotation3::identity() };
    let start = PathPlace { q, parameter };
    Ok(NaturalProblem::new(arm, Task::PlanarPosition, SpeedFactor::Determinant, path, start)?.with_dynamics(dynamics))
}

/// The metrics of a run of Table I, without start and stop.
///
/// # Errors
///
/// [`ProblemError::NoFiniteSpeed`] for a constant speed that is not finite.
pub fn limb_case(law: SpeedLaw) -> Result<NaturalMetrics, ProblemError> {
    let problem = limb_problem().map_err(|error| ProblemError::value("robot", error))?;
    let run = Run { law, ramp: Ramp::new(0.0, TABLE_1_INTERVAL)?, steps: STEPS };
    Ok(problem.follow(&run)?.metrics())
}

/// A column of the table as printed: distance, peak joint speed, peak torque, power.
struct Column {
    case: &'static str,
    law: SpeedLaw,
    printed: [&'static str; 4],
    /// Expected agreement of each printed number.
    expected: [Agreement; 4],
    remark: &'static str,
}

const PRINTED: &str =
    "the printed path speed does not give the printed distance, 8.85 m in 17 s, nor the printed peaks";
const FITTED: &str = "path speed fitted to the printed peaks; the printed distance belongs to 0.744 rad/s";
const FROM_PEAKS: &str =
    "b follows from the printed peaks, 2.26 rad/s to 0.22 %, so the distance is known to 0.22 % as well";
const POWER: &str = "mean of Σ|τ q̇|; the paper does not define its total power";

const fn natural(b: f64) -> SpeedLaw {
    SpeedLaw::Natural { b }
}

const fn constant(path_speed: f64) -> SpeedLaw {
    SpeedLaw::Constant { path_speed }
}

use Agreement::{Agrees, Differs};

/// `b` of NM-1 is printed; those of NM-2 and NM-3 follow from the printed peaks, the speed of CS-2 from the distance.
const COLUMNS: [Column; 6] = [
    Column {
        case: "CS-1, 0.85 rad/s",
        law: constant(0.85),
        printed: ["8.85", "2.9", "5.31", "626.7"],
        expected: [Differs; 4],
        remark: PRINTED,
    },
    Column {
        case: "CS-1, 0.78 rad/s",
        law: constant(0.78),
        printed: ["8.85", "2.9", "5.31", "626.7"],
        expected: [Differs, Agrees, Agrees, Differs],
        remark: FITTED,
    },
    Column {
        case: "NM-1",
        law: natural(1.2),
        printed: ["8.85", "0.84", "0.73", "149.15"],
        expected: [Agrees, Agrees, Agrees, Differs],
        remark: "",
    },
    Column {
        case: "NM-2",
        law: natural(4.14),
        printed: ["30.43", "2.9", "8.74", "5751.0"],
        expected: [Agrees, Agrees, Agrees, Differs],
        remark: "",
    },
    Column {
        case: "NM-3",
        law: natural(3.2264),
        printed: ["24.75", "2.26", "5.31", "2747.4"],
        expected: [Agrees, Agrees, Agrees, Differs],
        remark: FROM_PEAKS,
    },
    Column {
        case: "CS-2",
        law: constant(2.0798),
        printed: ["24.75", "7.73", "37.8", "11167.3"],
        expected: [Agrees, Agrees, Agrees, Differs],
        remark: "",
    },
];

/// `[N] Table I` row by row. Agreement is to one unit of the last printed digit.
///
/// # Errors
///
/// None with the numbers built in.
pub fn table_1() -> Result<Vec<Published>, ProblemError> {
    let mut rows = Vec::new();
    for Column { case, law, printed, expected, remark } in COLUMNS {
        let NaturalMetrics { distance, peak_joint_speed, peak_torque, mean_power } = limb_case(law)?;
        let ours = [Some(distance), Some(peak_joint_speed), peak_torque, mean_power];
        for (i, (quantity, unit)) in QUANTITIES.into_iter().enumerate() {
            let Printed { value, last_digit } = Printed::new(printed[i]);
            let inferred = if remark == FROM_PEAKS && i == 0 { 0.0022 * value } else { 0.0 };
            rows.push(Published {
                source: "[N] Table I",
                case: case.to_owned(),
                quantity,
                unit,
                paper: value,
                ours: ours[i],
                tolerance: last_digit + inferred,
                expected: expected[i],
                remark: if i == 3 { POWER } else { remark },
            });
        }
    }
    Ok(rows)
}

/// Quantities that both tables list, with their units.
pub(super) const QUANTITIES: [(&str, &str); 4] =
    [("distance", "m"), ("peak joint speed", "rad/s"), ("peak torque", "N·m"), ("power", "W")];
