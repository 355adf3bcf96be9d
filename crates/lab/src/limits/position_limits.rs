use crate::error::{Fault, LabError, ListOf};
use crate::joint_path::{JointPath, PieceKind};
use crate::scenario::number::Number;
use serde::{Deserialize, Serialize};
use slideway_robot::{JointVector, PositionRange, PositionRanges, RobotDescription};

/// How far the joints may go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PositionLimits<const N: usize> {
    /// Ranges, rad (m); `None` where a joint has none.
    pub ranges: PositionRanges<N>,
    /// Who says so.
    pub source: PositionSource,
}

/// Who gave the ranges of the joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PositionSource {
    /// The robot: a path that leaves them is reported.
    Robot,
    /// The scenario: a path that leaves them fails.
    Scenario,
}

/// A joint that leaves its range along the path.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
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
    /// The scenario's ranges, else the robot's own.
    pub(crate) fn new(given: Option<&Vec<[Number; 2]>>, robot: &RobotDescription) -> Result<Self, LabError> {
        const KEY: &str = "limits.position";
        let Some(given) = given else {
            let ranges = std::array::from_fn(|i| robot.joints.get(i).and_then(|j| j.limits.position));
            return Ok(Self { ranges, source: PositionSource::Robot });
        };
        if given.len() != N {
            return Err(LabError::value(
                KEY,
                Fault::WrongLength { found: given.len(), expected: N, list: ListOf::JointRanges },
            ));
        }
        for (joint, [lower, upper]) in given.iter().enumerate() {
            if !(lower.0 < upper.0) {
                let fault = Fault::NotIncreasing { before: lower.0, after: upper.0 };
                return Err(LabError::value(format!("{KEY}.{joint}"), fault));
            }
        }
        let range = |i: usize| Some(PositionRange { lower: given[i][0].0, upper: given[i][1].0 });
        Ok(Self { ranges: std::array::from_fn(range), source: PositionSource::Scenario })
    }

    /// The joints that leave their ranges along a joint path, each where it is farthest outside.
    pub(crate) fn excesses(&self, path: &JointPath<N>) -> Vec<PositionExcess> {
        let mut found: [Option<PositionExcess>; N] = [None; N];
        for piece in path.pieces() {
            match piece.kind() {
                PieceKind::Follow { at, q, .. } | PieceKind::Prescribed { at, q, .. } => {
                    at.iter().zip(q).for_each(|(lambda, q)| self.look(*lambda, q, &mut found));
                }
                PieceKind::SelfMotion { lambda, from, to } => {
                    [from, to].into_iter().for_each(|q| self.look(*lambda, q, &mut found));
                }
            }
        }
        found.into_iter().flatten().collect()
    }

    fn look(&self, lambda: f64, q: &JointVector<N>, found: &mut [Option<PositionExcess>; N]) {
        for (joint, worst) in found.iter_mut().enumerate() {
            let Some(PositionRange { lower, upper }) = self.ranges[joint] else { continue };
            let outside = |position: f64| (position - upper).max(lower - position);
            let farther = worst.is_none_or(|w| outside(q[joint]) > outside(w.position));
            if outside(q[joint]) > 0.0 && farther {
                *worst = Some(PositionExcess { joint, lambda, position: q[joint], lower, upper, source: self.source });
            }
        }
    }
}
