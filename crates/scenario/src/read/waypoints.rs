use crate::error::ScenarioError;
use crate::read::number_table::{NumberTable, TableError};
use crate::tables::curves::{EndsTable, LinesTable, PointList, RotationTable, SpacingName, SplineTable};
use crate::tables::number::Number;
use nalgebra::{SVector, UnitQuaternion, Vector3};
use slideway_path::Fault;
use slideway_path::curve::{BlendedLines, CubicSpline, CurveError, Spacing, SplineEnds, Waypoints, unit_quaternion};
use slideway_robot::euler;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// A table of a scenario that describes a curve: its key, the folder that files in it are relative to, and the range of
/// the path parameter.
#[derive(Clone, Debug)]
pub(crate) struct Place<'a> {
    pub(crate) key: String,
    pub(crate) folder: &'a Path,
    pub(crate) range: Range<f64>,
}

/// Way-points as given: one row of numbers each.
pub(crate) struct Rows {
    pub(crate) numbers: Vec<Vec<f64>>,
    origin: Origin,
}

/// Where rows come from, for errors about them.
enum Origin {
    Inline { key: String },
    Csv { key: String, path: PathBuf, lines: Vec<u64> },
}

impl Place<'_> {
    /// The table inside this one.
    pub(crate) fn inside(&self, name: &str) -> Self {
        Self { key: self.key(name), ..self.clone() }
    }

    /// The key of a value in this table.
    pub(crate) fn key(&self, name: &str) -> String {
        format!("{}.{name}", self.key)
    }

    /// An error about a value in this table.
    pub(crate) fn error(&self, name: &str, fault: impl Into<Fault>) -> ScenarioError {
        ScenarioError::value(self.key(name), fault)
    }

    pub(crate) fn spline<const D: usize>(&self, table: &SplineTable) -> Result<CubicSpline<D>, ScenarioError> {
        let rows = self.rows(&table.list(), &[D])?;
        let waypoints = self.waypoints(&rows, &table.list())?;
        let ends = self.ends(&table.ends)?;
        CubicSpline::new(waypoints, ends).map_err(|error| self.waypoint_error(&rows, error))
    }

    pub(crate) fn lines<const D: usize>(&self, table: &LinesTable) -> Result<BlendedLines<D>, ScenarioError> {
        let rows = self.rows(&table.list(), &[D])?;
        let waypoints = self.waypoints(&rows, &table.list())?;
        BlendedLines::new(waypoints, table.blend.0).map_err(|error| self.waypoint_error(&rows, error))
    }

    fn waypoints<const D: usize>(&self, rows: &Rows, list: &PointList<'_>) -> Result<Waypoints<D>, ScenarioError> {
        let points = rows.numbers.iter().map(|row| SVector::from_column_slice(row)).collect();
        let spacing = self.spacing(list, Spacing::Chord)?;
        Waypoints::new(points, &spacing, self.range.clone()).map_err(|error| self.waypoint_error(rows, error))
    }

    /// The way-points, from the scenario itself or from a CSV file, each with as many numbers as one of the widths says.
    pub(crate) fn rows(&self, list: &PointList<'_>, widths: &[usize]) -> Result<Rows, ScenarioError> {
        match (list.points, list.csv) {
            (Some(points), None) => self.inline(points, widths),
            (None, Some(file)) => self.csv(file, widths),
            (Some(_), Some(_)) => Err(self.error("csv", Fault::Conflict("`points` and `csv` exclude each other"))),
            (None, None) => {
                let fault = Fault::Missing("give the way-points, as `points = [[...], ...]` or `csv = \"file.csv\"`");
                Err(ScenarioError::value(self.key.clone(), fault))
            }
        }
    }

    fn inline(&self, points: &[Vec<Number>], widths: &[usize]) -> Result<Rows, ScenarioError> {
        let key = self.key("points");
        if let Some((i, row)) = points.iter().enumerate().find(|(_, row)| !widths.contains(&row.len())) {
            let fault = Fault::WaypointLength { found: row.len(), expected: widths.to_vec() };
            return Err(ScenarioError::value(format!("{key}.{i}"), fault));
        }
        let numbers = points.iter().map(|row| row.iter().map(|n| n.0).collect()).collect();
        Ok(Rows { numbers, origin: Origin::Inline { key } })
    }

    fn csv(&self, file: &str, widths: &[usize]) -> Result<Rows, ScenarioError> {
        let (key, path) = (self.key("csv"), self.folder.join(file));
        let table = std::fs::read(&path)
            .map_err(|error| TableError::Read { reason: error.to_string() })
            .and_then(|bytes| NumberTable::parse(&bytes, widths));
        match table {
            Ok(table) => {
                let lines = table.lines().to_vec();
                Ok(Rows { numbers: table.rows().to_vec(), origin: Origin::Csv { key, path, lines } })
            }
            Err(error) => Err(ScenarioError::Csv { key, path, error }),
        }
    }

    /// How path parameters are given to the way-points; a list of them must cover the path.
    pub(crate) fn spacing(&self, list: &PointList<'_>, default: Spacing) -> Result<Spacing, ScenarioError> {
        match (list.spacing, list.at) {
            (Some(_), Some(_)) => Err(self.error("spacing", Fault::Conflict("`spacing` and `at` exclude each other"))),
            (Some(SpacingName::Uniform), None) => Ok(Spacing::Uniform),
            (Some(SpacingName::Chord), None) => Ok(Spacing::Chord),
            (None, None) => Ok(default),
            (None, Some(at)) => {
                let at: Vec<f64> = at.iter().map(|n| n.0).collect();
                if let ([first, .., last], Range { start, end }) = (at.as_slice(), &self.range)
                    && (first > start || last < end)
                {
                    let fault = Fault::NotCovered { listed: [*first, *last], path: [*start, *end] };
                    return Err(self.error("at", fault));
                }
                Ok(Spacing::At(at))
            }
        }
    }

    pub(crate) fn ends<const D: usize>(&self, table: &EndsTable) -> Result<SplineEnds<D>, ScenarioError> {
        let derivative = |name: &str, numbers: &[Number]| {
            if numbers.len() == D {
                return Ok(SVector::from_fn(|i, _| numbers[i].0));
            }
            let fault = Fault::WaypointLength { found: numbers.len(), expected: vec![D] };
            Err(self.error(&format!("ends.clamped.{name}"), fault))
        };
        Ok(match table {
            EndsTable::Natural => SplineEnds::Natural,
            EndsTable::NotAKnot => SplineEnds::NotAKnot,
            EndsTable::Clamped { start, end } => {
                SplineEnds::Clamped { start: derivative("start", start)?, end: derivative("end", end)? }
            }
        })
    }

    /// A curve's error, at the way-point or at the path parameter that it is about.
    pub(crate) fn waypoint_error(&self, rows: &Rows, error: CurveError) -> ScenarioError {
        match error {
            CurveError::NotIncreasing { index, .. } => self.error(&format!("at.{index}"), error),
            CurveError::ParameterCount { .. } => self.error("at", error),
            CurveError::Blend { .. } => self.error("blend", error),
            CurveError::EndDerivative => self.error("ends", error),
            _ => rows.error(error.index(), error),
        }
    }
}

impl Rows {
    /// An error about a row, or about all of them.
    pub(crate) fn error(&self, row: Option<usize>, error: CurveError) -> ScenarioError {
        match &self.origin {
            Origin::Inline { key } => match row {
                Some(row) => ScenarioError::value(format!("{key}.{row}"), error),
                None => ScenarioError::value(key.clone(), error),
            },
            Origin::Csv { key, path, lines } => {
                let line = row.and_then(|row| lines.get(row)).copied();
                ScenarioError::CsvWaypoint { key: key.clone(), path: path.clone(), line, error }
            }
        }
    }
}

/// Three numbers of a scenario.
pub(crate) fn vector(numbers: &[Number; 3]) -> Vector3<f64> {
    Vector3::new(numbers[0].0, numbers[1].0, numbers[2].0)
}

/// The rotation that a table means.
pub(crate) fn rotation(table: &RotationTable) -> Result<UnitQuaternion<f64>, CurveError> {
    match table {
        RotationTable::Euler(angles) => Ok(from_euler(&vector(angles))),
        RotationTable::Quaternion(numbers) => unit_quaternion(numbers.map(|n| n.0)),
    }
}

/// The rotation of an Euler triple.
pub(crate) fn from_euler(angles: &Vector3<f64>) -> UnitQuaternion<f64> {
    UnitQuaternion::from_rotation_matrix(&euler::rotation(angles))
}
