//! Curves through way-points as they are written in a scenario.

use super::number::Number;
use super::{JointsTable, PathTable, PositionTable};
use serde::Deserialize;

/// A cubic spline through way-points.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SplineTable {
    pub(crate) points: Option<Vec<Vec<Number>>>,
    pub(crate) csv: Option<String>,
    pub(crate) spacing: Option<SpacingName>,
    pub(crate) at: Option<Vec<Number>>,
    #[serde(default)]
    pub(crate) ends: EndsTable,
}

/// Lines between way-points, rounded by blends.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LinesTable {
    pub(crate) points: Option<Vec<Vec<Number>>>,
    pub(crate) csv: Option<String>,
    pub(crate) spacing: Option<SpacingName>,
    pub(crate) at: Option<Vec<Number>>,
    pub(crate) blend: Number,
}

/// Way-points of position and orientation together.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PosesTable {
    pub(crate) points: Option<Vec<Vec<Number>>>,
    pub(crate) csv: Option<String>,
    pub(crate) spacing: Option<SpacingName>,
    pub(crate) at: Option<Vec<Number>>,
    #[serde(default)]
    pub(crate) position: PosePositionTable,
    #[serde(default)]
    pub(crate) orientation: PoseOrientationName,
}

/// How the positions of poses are joined.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum PosePositionTable {
    Spline {
        #[serde(default)]
        ends: EndsTable,
    },
    Lines {
        blend: Number,
    },
}

impl Default for PosePositionTable {
    fn default() -> Self {
        Self::Spline { ends: EndsTable::default() }
    }
}

/// How the orientations of poses are joined.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum PoseOrientationName {
    #[default]
    Squad,
    Slerp,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum SpacingName {
    Uniform,
    Chord,
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum EndsTable {
    Natural,
    #[default]
    NotAKnot,
    Clamped {
        start: Vec<Number>,
        end: Vec<Number>,
    },
}

/// A rotation, in one of two notations.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum RotationTable {
    Euler([Number; 3]),
    Quaternion([Number; 4]),
}

/// What all tables of way-points have in common.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PointList<'a> {
    pub(crate) points: Option<&'a [Vec<Number>]>,
    pub(crate) csv: Option<&'a str>,
    pub(crate) spacing: Option<SpacingName>,
    pub(crate) at: Option<&'a [Number]>,
}

impl SplineTable {
    pub(crate) fn list(&self) -> PointList<'_> {
        PointList {
            points: self.points.as_deref(),
            csv: self.csv.as_deref(),
            spacing: self.spacing,
            at: self.at.as_deref(),
        }
    }
}

impl LinesTable {
    pub(crate) fn list(&self) -> PointList<'_> {
        PointList {
            points: self.points.as_deref(),
            csv: self.csv.as_deref(),
            spacing: self.spacing,
            at: self.at.as_deref(),
        }
    }
}

impl PosesTable {
    pub(crate) fn list(&self) -> PointList<'_> {
        PointList {
            points: self.points.as_deref(),
            csv: self.csv.as_deref(),
            spacing: self.spacing,
            at: self.at.as_deref(),
        }
    }
}

impl PointList<'_> {
    /// The part of the table that holds the first way-point.
    pub(crate) fn first_key(&self) -> &'static str {
        if self.csv.is_some() { "csv" } else { "points.0" }
    }
}

impl PathTable {
    /// The path parameters that are listed for the way-points of the path, if any are.
    pub(crate) fn listed_parameters(&self) -> Option<&[Number]> {
        self.waypoints().and_then(|(_, list)| list.at)
    }

    /// The key of that list.
    pub(crate) fn listed_key(&self) -> Option<String> {
        self.waypoints().filter(|(_, list)| list.at.is_some()).map(|(key, _)| format!("{key}.at"))
    }

    /// Whether the path is a function of the path parameter itself, so that its end must be given.
    pub(crate) fn is_in_the_parameter(&self) -> bool {
        matches!(self.position, Some(PositionTable::Helix { .. } | PositionTable::Formula { .. }))
    }

    /// The key of the path's first point, for errors about it.
    pub(crate) fn start_key(&self) -> String {
        match (&self.position, self.waypoints()) {
            (_, Some((key, list))) => format!("{key}.{}", list.first_key()),
            (Some(PositionTable::Helix { .. }), _) => "path.position.helix.start".into(),
            (Some(PositionTable::Line { .. }), _) => "path.position.line.from".into(),
            (Some(PositionTable::Arc { .. }), _) => "path.position.arc.from".into(),
            (Some(PositionTable::Formula { .. }), _) => "path.position.formula".into(),
            _ => "path".into(),
        }
    }

    /// The way-points of the path and the key of their table.
    fn waypoints(&self) -> Option<(&'static str, PointList<'_>)> {
        match (&self.position, &self.joints, &self.poses) {
            (Some(PositionTable::Spline(table)), ..) => Some(("path.position.spline", table.list())),
            (Some(PositionTable::Lines(table)), ..) => Some(("path.position.lines", table.list())),
            (_, Some(JointsTable::Spline(table)), _) => Some(("path.joints.spline", table.list())),
            (_, Some(JointsTable::Lines(table)), _) => Some(("path.joints.lines", table.list())),
            (.., Some(table)) => Some(("path.poses", table.list())),
            _ => None,
        }
    }
}
