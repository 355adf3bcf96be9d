//! Curves through way-points as they are written in a scenario.

use super::number::Number;
use schemars::JsonSchema;
use serde::Deserialize;

/// A cubic spline through way-points.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SplineTable {
    /// The way-points, a list of numbers each.
    pub(crate) points: Option<Vec<Vec<Number>>>,
    /// A CSV file instead of `points`, a way-point a row, relative to the scenario file.
    pub(crate) csv: Option<String>,
    /// Lambda along the way-points (default: chord).
    pub(crate) spacing: Option<SpacingName>,
    /// Lambda at each way-point, instead of `spacing`.
    pub(crate) at: Option<Vec<Number>>,
    /// The ends of the spline (default: not-a-knot).
    #[serde(default)]
    pub(crate) ends: EndsTable,
}

/// Lines between way-points, rounded by blends.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LinesTable {
    /// The way-points, a list of numbers each.
    pub(crate) points: Option<Vec<Vec<Number>>>,
    /// A CSV file instead of `points`, a way-point a row, relative to the scenario file.
    pub(crate) csv: Option<String>,
    /// Lambda along the way-points (default: chord).
    pub(crate) spacing: Option<SpacingName>,
    /// Lambda at each way-point, instead of `spacing`.
    pub(crate) at: Option<Vec<Number>>,
    /// Half-width of the rounding, as a share of the shorter neighbouring line: 0 (corners) to 0.5.
    pub(crate) blend: Number,
}

/// Way-points of position and orientation together.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PosesTable {
    /// The way-points, a list of numbers each.
    pub(crate) points: Option<Vec<Vec<Number>>>,
    /// A CSV file instead of `points`, a way-point a row, relative to the scenario file.
    pub(crate) csv: Option<String>,
    /// Lambda along the way-points (default: chord).
    pub(crate) spacing: Option<SpacingName>,
    /// Lambda at each way-point, instead of `spacing`.
    pub(crate) at: Option<Vec<Number>>,
    /// The curve of the positions (default: spline).
    #[serde(default)]
    pub(crate) position: PosePositionTable,
    /// The curve of the orientations (default: squad).
    #[serde(default)]
    pub(crate) orientation: PoseOrientationName,
}

/// How the positions of poses are joined.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
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
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum PoseOrientationName {
    #[default]
    Squad,
    Slerp,
}

#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum SpacingName {
    Uniform,
    Chord,
}

#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
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
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
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
