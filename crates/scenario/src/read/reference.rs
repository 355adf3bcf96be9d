//! The path of a scenario, of the tool or of the joints.

use crate::error::ScenarioError;
use crate::read::curves::{orientation_curve, position_curve};
use crate::read::poses::PoseCurves;
use crate::read::waypoints::Place;
use crate::tables::number::{Number, joints};
use crate::tables::path::{JointsTable, PathTable};
use crate::tables::{InverseTable, ScenarioFile, TaskName};
use slideway_path::{CartesianPath, Fault, JointCurve, OrientationCurve, PositionCurve, Reference, ToolReference};
use slideway_robot::{InverseMethod, RobotError, Task};
use std::ops::Range;
use std::path::Path;

/// The path and, for one of the tool, how the controller follows it.
pub(crate) fn reference<const N: usize>(file: &ScenarioFile, folder: &Path) -> Result<Reference<N>, ScenarioError> {
    if let Some(joints) = &file.path.joints {
        let shared = [
            ("path.position", file.path.position.is_some()),
            ("path.orientation", file.path.orientation.is_some()),
            ("path.poses", file.path.poses.is_some()),
        ];
        if let Some((key, _)) = shared.into_iter().find(|(_, given)| *given) {
            let fault = Fault::Conflict("a path of the joints (`path.joints`) leaves nothing for the tool to say");
            return Err(ScenarioError::value(key, fault));
        }
        return Ok(Reference::Joint(joint_curve(&file.path, joints, folder)?));
    }
    let rows = task(file.robot.task).rows().len();
    if rows > N {
        return Err(ScenarioError::value("robot.task", Fault::TaskRows { rows, joints: N }));
    }
    let missing = Fault::Missing("a path of the tool needs an inverse, for example `[robot.inverse.adjugate]`");
    let table = file.robot.inverse.as_ref().ok_or_else(|| ScenarioError::value("robot.inverse", missing))?;
    let tool = ToolReference {
        path: cartesian(&file.path, file.robot.task, folder)?,
        task: task(file.robot.task),
        inverse: inverse(table),
    };
    let validated = tool.inverse.validate(tool.task, N);
    validated.map_err(|error| ScenarioError::value(inverse_key(table, &error), error))?;
    Ok(Reference::Tool(tool))
}

fn task(name: TaskName) -> Task {
    match name {
        TaskName::Pose => Task::Pose,
        TaskName::Position => Task::Position,
        TaskName::PlanarPosition => Task::PlanarPosition,
        TaskName::PlanarPose => Task::PlanarPose,
    }
}

fn inverse(table: &InverseTable) -> InverseMethod {
    match table {
        InverseTable::Adjugate { epsilon } => InverseMethod::Adjugate { epsilon: epsilon.0 },
        InverseTable::DampedLeastSquares { damping } => InverseMethod::DampedLeastSquares { damping: damping.0 },
        InverseTable::TruncatedSvd { cutoff } => InverseMethod::TruncatedSvd { cutoff: cutoff.0 },
    }
}

/// The key that an inverse's error is about.
fn inverse_key(table: &InverseTable, error: &RobotError) -> &'static str {
    match (table, error) {
        (InverseTable::Adjugate { .. }, RobotError::NotPositive { .. }) => "robot.inverse.adjugate.epsilon",
        (InverseTable::DampedLeastSquares { .. }, _) => "robot.inverse.damped-least-squares.damping",
        (InverseTable::TruncatedSvd { .. }, _) => "robot.inverse.truncated-svd.cutoff",
        _ => "robot.inverse",
    }
}

fn joint_curve<const N: usize>(
    path: &PathTable,
    table: &JointsTable,
    folder: &Path,
) -> Result<JointCurve<N>, ScenarioError> {
    let range = range(path)?;
    let place = |key: &str| Place { key: key.to_owned(), folder, range: range.clone() };
    Ok(match table {
        JointsTable::Line { from, to } => {
            let (from, to) = (joints("path.joints.line.from", from)?, joints("path.joints.line.to", to)?);
            JointCurve::line(from, to, range.clone())
        }
        JointsTable::Spline(table) => JointCurve::spline(place("path.joints.spline").spline(table)?, range.clone()),
        JointsTable::Lines(table) => JointCurve::lines(place("path.joints.lines").lines(table)?, range.clone()),
    })
}

fn cartesian(table: &PathTable, task: TaskName, folder: &Path) -> Result<CartesianPath, ScenarioError> {
    let range = range(table)?;
    let place = |key: &str| Place { key: key.to_owned(), folder, range: range.clone() };
    let PoseCurves { position, orientation } = match &table.poses {
        Some(poses) => {
            for (key, given) in
                [("path.position", table.position.is_some()), ("path.orientation", table.orientation.is_some())]
            {
                if given {
                    return Err(ScenarioError::value(
                        key,
                        Fault::Conflict("`path.poses` gives position and orientation"),
                    ));
                }
            }
            PoseCurves::read(poses, &place("path.poses"))?
        }
        None => PoseCurves {
            position: position(table, &place("path.position"))?,
            orientation: orientation(table, task, &place("path.orientation"))?,
        },
    };
    Ok(CartesianPath::new(position, orientation, range)?)
}

fn position(table: &PathTable, place: &Place<'_>) -> Result<PositionCurve, ScenarioError> {
    let missing = Fault::Missing(
        "say where the path leads: `path.position` or `path.poses` for the tool, or `path.joints` for the joints",
    );
    let position = table.position.as_ref().ok_or_else(|| ScenarioError::value("path", missing))?;
    position_curve(position, place)
}

fn orientation(table: &PathTable, task: TaskName, place: &Place<'_>) -> Result<OrientationCurve, ScenarioError> {
    match &table.orientation {
        Some(table) => orientation_curve(table, place),
        None if matches!(task, TaskName::Pose | TaskName::PlanarPose) => {
            let fault = Fault::Missing("a task that includes the orientation needs one along the path");
            Err(ScenarioError::value(place.key.clone(), fault))
        }
        None => Ok(OrientationCurve::standing()),
    }
}

/// First and last path parameter: as given, else those listed for the way-points, else 0 and 1. Formulas in the path
/// parameter, and the helix, need the last one given.
fn range(table: &PathTable) -> Result<Range<f64>, ScenarioError> {
    let listed = table.listed_parameters().unwrap_or_default();
    let given = |number: Option<Number>, listed: Option<&Number>| number.or(listed.copied()).map(|n| n.0);
    let start = given(table.start, listed.first()).unwrap_or(0.0);
    let default = if table.is_in_the_parameter() { None } else { Some(1.0) };
    let missing = Fault::Missing("this path is a function of the path parameter: say how far it runs");
    let end = given(table.end, listed.last()).or(default).ok_or_else(|| ScenarioError::value("path.end", missing))?;
    if start < end {
        return Ok(start..end);
    }
    let key = match table.listed_key() {
        _ if table.end.is_some() => "path.end".to_owned(),
        Some(key) => key,
        None => "path.start".to_owned(),
    };
    Err(ScenarioError::value(key, Fault::NotIncreasing { before: start, after: end }))
}
