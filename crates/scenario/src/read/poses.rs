use crate::error::ScenarioError;
use crate::read::waypoints::{Place, Rows, from_euler};
use crate::tables::curves::{PoseOrientationName, PosePositionTable, PosesTable};
use nalgebra::{UnitQuaternion, Vector3};
use slideway_path::curve::{
    BlendedLines, CubicSpline, CurveError, RotationWaypoints, Slerp, Spacing, Squad, Waypoints, unit_quaternion,
};
use slideway_path::{OrientationCurve, PositionCurve};

/// Position and orientation through the same way-points at the same path parameters.
pub(crate) struct PoseCurves {
    pub(crate) position: PositionCurve,
    pub(crate) orientation: OrientationCurve,
}

/// Numbers of a pose: position and Euler triple, or position and quaternion.
const WIDTHS: [usize; 2] = [6, 7];

impl PoseCurves {
    pub(crate) fn read(table: &PosesTable, place: &Place<'_>) -> Result<Self, ScenarioError> {
        let rows = place.rows(&table.list(), &WIDTHS)?;
        let rotations = rotations(&rows)?;
        let points: Vec<_> = rows.numbers.iter().map(|row| Vector3::new(row[0], row[1], row[2])).collect();
        let stands = |i: &usize| points[*i] == points[i - 1] && rotations[*i].angle_to(&rotations[i - 1]) == 0.0;
        if let Some(index) = (1..points.len()).find(stands) {
            return Err(rows.error(Some(index), CurveError::Repeated { before: index - 1, index }));
        }
        let pointed = |error| place.waypoint_error(&rows, error);
        let spacing = place.spacing(&table.list(), Spacing::Chord)?;
        let positions = Waypoints::with_dwells(points, &spacing, place.range.clone()).map_err(pointed)?;
        let at = Spacing::At(positions.at().to_vec());
        let turns = RotationWaypoints::new(rotations, &at, place.range.clone()).map_err(pointed)?;
        Ok(Self {
            position: position(&table.position, positions, place, &rows)?,
            orientation: match table.orientation {
                PoseOrientationName::Squad => OrientationCurve::Squad(Squad::new(turns)),
                PoseOrientationName::Slerp => OrientationCurve::Slerp(Slerp::new(turns)),
            },
        })
    }
}

fn position(
    table: &PosePositionTable,
    waypoints: Waypoints<3>,
    place: &Place<'_>,
    rows: &Rows,
) -> Result<PositionCurve, ScenarioError> {
    // A row's own error points at the row, one of the table at the shape's key.
    let pointed = |shape: Place<'_>, error: CurveError| match error.index() {
        Some(_) => place.waypoint_error(rows, error),
        None => shape.waypoint_error(rows, error),
    };
    Ok(match table {
        PosePositionTable::Spline { ends } => {
            let shape = place.inside("position").inside("spline");
            let spline = CubicSpline::new(waypoints, shape.ends(ends)?);
            PositionCurve::Spline(spline.map_err(|error| pointed(shape, error))?)
        }
        PosePositionTable::Lines { blend } => {
            let shape = place.inside("position").inside("lines");
            let lines = BlendedLines::new(waypoints, blend.0);
            PositionCurve::Lines(lines.map_err(|error| pointed(shape, error))?)
        }
    })
}

fn rotations(rows: &Rows) -> Result<Vec<UnitQuaternion<f64>>, ScenarioError> {
    let rotation = |(i, row): (usize, &Vec<f64>)| match row.get(3..) {
        Some(&[w, x, y, z]) => unit_quaternion([w, x, y, z]).map_err(|error| rows.error(Some(i), error)),
        _ => Ok(from_euler(&Vector3::new(row[3], row[4], row[5]))),
    };
    rows.numbers.iter().enumerate().map(rotation).collect()
}
