use crate::curve::{BlendedLines, CubicSpline};
use crate::error::LabError;
use crate::path::range;
use crate::path::waypoint_reader::Place;
use crate::scenario::number::joints;
use crate::scenario::schema::{JointsTable, PathTable};
use slideway_robot::JointVector;
use std::ops::Range;
use std::path::Path;

/// A path of the joints: configurations as a function of the path parameter `λ`, rad (m for joints that slide).
#[derive(Clone, Debug)]
pub struct JointCurve<const N: usize> {
    range: Range<f64>,
    shape: Shape<N>,
}

/// How the configurations are joined.
#[derive(Clone, Debug)]
enum Shape<const N: usize> {
    Line { from: JointVector<N>, rate: JointVector<N> },
    Spline(CubicSpline<N>),
    Lines(BlendedLines<N>),
}

impl<const N: usize> JointCurve<N> {
    pub(crate) fn new(path: &PathTable, table: &JointsTable, folder: &Path) -> Result<Self, LabError> {
        let range = range(path)?;
        let place = |key: &str| Place { key: key.to_owned(), folder, range: range.clone() };
        let shape = match table {
            JointsTable::Line { from, to } => {
                let (from, to) = (joints("path.joints.line.from", from)?, joints("path.joints.line.to", to)?);
                Shape::Line { from, rate: (to - from) / (range.end - range.start) }
            }
            JointsTable::Spline(table) => Shape::Spline(place("path.joints.spline").spline(table)?),
            JointsTable::Lines(table) => Shape::Lines(place("path.joints.lines").lines(table)?),
        };
        Ok(Self { range, shape })
    }

    /// Path parameter at the start.
    #[must_use]
    pub fn start(&self) -> f64 {
        self.range.start
    }

    /// Path parameter at the end.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.range.end
    }

    /// Path parameters strictly inside the path where its derivative jumps, increasing.
    #[must_use]
    pub fn kinks(&self) -> Vec<f64> {
        match &self.shape {
            Shape::Line { .. } | Shape::Spline(_) => Vec::new(),
            Shape::Lines(lines) => {
                lines.kinks().into_iter().filter(|at| *at > self.range.start && *at < self.range.end).collect()
            }
        }
    }

    /// `q(λ)`, `q'(λ)` and `q''(λ)`; at a kink, those of the piece that begins there.
    #[must_use]
    pub fn at(&self, lambda: f64) -> [JointVector<N>; 3] {
        match &self.shape {
            Shape::Line { from, rate } => [from + rate * (lambda - self.range.start), *rate, JointVector::zeros()],
            Shape::Spline(spline) => spline.at(lambda),
            Shape::Lines(lines) => lines.at(lambda),
        }
    }
}
