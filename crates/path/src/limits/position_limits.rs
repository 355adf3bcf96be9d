use serde::{Deserialize, Serialize};
use slideway_robot::PositionRanges;

/// Position limits of the joints, and their origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PositionLimits<const N: usize> {
    /// Ranges, rad (m); `None` where a joint has none.
    pub ranges: PositionRanges<N>,
    /// Origin of the ranges.
    pub source: PositionSource,
}

/// Origin of the ranges of the joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PositionSource {
    /// The robot: a path that leaves them is reported.
    Robot,
    /// The scenario: a path that leaves them fails.
    Scenario,
}

/// A joint that leaves its range along the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PositionExcess {
    /// The joint, counted from 0.
    pub joint: usize,
    /// Path parameter where it is farthest outside.
    pub lambda: f64,
    /// Its position there, rad (m).
    pub position: f64,
    /// Lower end of its range.
    pub lower: f64,
    /// Upper end of its range.
    pub upper: f64,
    /// Who gave the range.
    pub source: PositionSource,
}

impl<const N: usize> PositionLimits<N> {
    /// No ranges at all.
    pub const NONE: Self = Self { ranges: [None; N], source: PositionSource::Robot };
}
