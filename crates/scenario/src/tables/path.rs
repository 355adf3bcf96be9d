//! The path of a scenario as it is written.

use super::curves::{LinesTable, PointList, PosesTable, RotationTable, SpacingName, SplineTable};
use super::number::Number;
use schemars::JsonSchema;
use serde::Deserialize;

/// The path, of the tool or of the joints.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PathTable {
    /// Lambda at the start (default: 0).
    pub(crate) start: Option<Number>,
    /// Lambda at the end; may be left out for way-points, lines and arcs.
    pub(crate) end: Option<Number>,
    /// The tool's position, m.
    pub(crate) position: Option<PositionTable>,
    /// Position and orientation through way-points in one list.
    pub(crate) poses: Option<PosesTable>,
    /// A path of the joints, rad (m).
    pub(crate) joints: Option<JointsTable>,
    /// The tool's orientation.
    pub(crate) orientation: Option<OrientationTable>,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum PositionTable {
    Helix { start: [Number; 3], radius: Number, climb: Number },
    Line { from: [Number; 3], to: [Number; 3] },
    Arc { from: [Number; 3], via: [Number; 3], to: [Number; 3] },
    Spline(SplineTable),
    Lines(LinesTable),
    Formula { x: String, y: String, z: String },
}

/// A path of the joints.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum JointsTable {
    Line { from: Vec<Number>, to: Vec<Number> },
    Spline(SplineTable),
    Lines(LinesTable),
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum OrientationTable {
    Constant { euler: [Number; 3] },
    PiecewiseLinear { knots: Vec<KnotTable> },
    Formula { alpha: String, beta: String, gamma: String },
    Slerp { from: RotationTable, to: RotationTable },
    Squad { rotations: Vec<RotationTable>, spacing: Option<SpacingName>, at: Option<Vec<Number>> },
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct KnotTable {
    /// Lambda.
    pub(crate) at: Number,
    /// alpha, beta, gamma, rad.
    pub(crate) euler: [Number; 3],
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
