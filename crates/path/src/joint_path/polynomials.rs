//! A joint path as polynomials: what an optimum of the whole path, and not of a grid, is about.

use crate::curve::PolynomialPiece;
use slideway_robot::JointVector;

/// A continuous joint path `q(s)`, one polynomial a joint between neighbouring knots, with the path parameter `λ(s)` beside it.
///
/// `s` is not the path parameter: it is chosen so that `q'(s)` jumps only where the direction of travel does, at corners.
#[derive(Clone, Debug, PartialEq)]
pub struct JointPolynomials {
    knots: Vec<f64>,
    segments: Vec<Segment>,
    likeness: Likeness,
}

/// The polynomials between two knots, by rising powers of the distance from the first.
#[derive(Clone, Debug, PartialEq)]
struct Segment {
    joints: Vec<Vec<f64>>,
    lambda: Vec<f64>,
}

/// How polynomials and the joint path that they stand for agree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Likeness {
    /// They are the path, but for the rounding of their coefficients.
    Same,
    /// They are a spline through points of it, with its directions and curvatures there.
    Spline(SplineDeviation),
}

/// The largest distances seen between a joint path and the spline through points of it, at samples between these points.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct SplineDeviation {
    /// Of any one joint, rad (m for joints that slide).
    pub joint: f64,
    /// Of the tool's point, m.
    pub tool_m: f64,
    /// Of the tool's orientation, rad.
    pub tool_rad: f64,
    /// Points that the spline passes through.
    pub points: usize,
}

/// A point of a joint path, whatever the number of joints, with its derivatives by the path's parameter `s`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct JointPathPoint {
    /// Path parameter.
    pub lambda: f64,
    /// `dλ/ds`.
    pub lambda_rate: f64,
    /// Configuration, rad (m).
    pub q: Vec<f64>,
    /// `q'(s)`.
    pub first: Vec<f64>,
    /// `q''(s)`.
    pub second: Vec<f64>,
}

impl JointPolynomials {
    /// The parameter `s` at the knots, rising.
    #[must_use]
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// Coefficients of each joint between neighbouring knots, by rising powers of the distance from the first of the two.
    #[must_use]
    pub fn coefficients(&self) -> Vec<Vec<Vec<f64>>> {
        self.segments.iter().map(|segment| segment.joints.clone()).collect()
    }

    /// How they and the joint path agree.
    #[must_use]
    pub fn likeness(&self) -> Likeness {
        self.likeness
    }

    /// The point at a parameter, which is cut to the path; at a knot that of the segment that begins there.
    #[must_use]
    pub fn at(&self, s: f64) -> JointPathPoint {
        let i = self.knots.partition_point(|k| *k <= s).clamp(1, self.segments.len()) - 1;
        let t = s.clamp(self.knots[i], self.knots[i + 1]) - self.knots[i];
        let Segment { joints, lambda } = &self.segments[i];
        let [q, first, second] = [0, 1, 2].map(|order| joints.iter().map(|c| values(c, t)[order]).collect());
        let [lambda, lambda_rate, _] = values(lambda, t);
        JointPathPoint { lambda, lambda_rate, q, first, second }
    }
}

/// Value, first and second derivative of a polynomial.
fn values(powers: &[f64], t: f64) -> [f64; 3] {
    powers
        .iter()
        .rev()
        .fold([0.0; 3], |[value, first, second], c| [value * t + c, first * t + value, second * t + 2.0 * first])
}

/// Polynomials as they come, in the order of the path.
pub(super) struct Builder {
    knots: Vec<f64>,
    segments: Vec<Segment>,
}

impl Builder {
    pub(super) fn from(s: f64) -> Self {
        Self { knots: vec![s], segments: Vec::new() }
    }

    pub(super) fn push<const N: usize>(&mut self, length: f64, powers: &[JointVector<N>], lambda: Vec<f64>) {
        let joint = |j: usize| powers.iter().map(|c| c[j]).collect();
        self.segments.push(Segment { joints: (0..N).map(joint).collect(), lambda });
        self.knots.push(self.knots[self.knots.len() - 1] + length);
    }

    pub(super) fn finish(self, likeness: Likeness) -> JointPolynomials {
        JointPolynomials { knots: self.knots, segments: self.segments, likeness }
    }
}

/// Difference between two directions that counts as rounding.
const SAME_DIRECTION: f64 = 1e-9;

impl JointPolynomials {
    /// A path of the joints in its own pieces. Where the direction of travel goes on and the speed by the path parameter jumps, as between
    /// unevenly spaced way-points on a line, `s` takes the jump.
    pub(super) fn of_pieces<const N: usize>(pieces: &[PolynomialPiece<N>]) -> Self {
        let mut builder = Builder::from(pieces.first().map_or(0.0, |piece| piece.start));
        let mut before: Option<JointVector<N>> = None;
        // dλ/ds
        let mut rate = 1.0;
        for piece in pieces {
            let zero = JointVector::zeros();
            let first = *piece.powers.get(1).unwrap_or(&zero);
            rate = before.map_or(rate, |before| continued(&before, &first, rate));
            let mut factor = 1.0;
            let mut scaled = Vec::new();
            for c in &piece.powers {
                scaled.push(c * factor);
                factor *= rate;
            }
            let length = (piece.end - piece.start) / rate;
            builder.push(length, &scaled, vec![piece.start, rate]);
            let slope = |sum: JointVector<N>, (m, c): (usize, &JointVector<N>)| sum * length + c * m as f64;
            before = Some(scaled.iter().enumerate().skip(1).rev().fold(zero, slope));
        }
        builder.finish(Likeness::Same)
    }
}

/// The rate `dλ/ds` with which `dq/ds` goes on from `before`, where `dq/dλ` is now `first`; the rate so far where the direction jumps or nothing moves.
fn continued<const N: usize>(before: &JointVector<N>, first: &JointVector<N>, rate: f64) -> f64 {
    let (old, new) = (before.norm(), first.norm());
    let turn = (before / old - first / new).norm();
    let found = old / new;
    let jumps = (found / rate - 1.0).abs() > SAME_DIRECTION;
    if turn <= SAME_DIRECTION && jumps && found > 0.0 && found.is_finite() { found } else { rate }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unevenly_spaced_points_of_a_line_are_no_corner_and_a_bend_is_one() {
        let piece = |start: f64, end: f64, from: [f64; 2], rate: [f64; 2]| PolynomialPiece {
            start,
            end,
            powers: vec![from.into(), rate.into()],
        };
        let path = JointPolynomials::of_pieces(&[
            piece(0.0, 1.0, [0.0, 0.0], [1.0, 2.0]),
            piece(1.0, 3.0, [1.0, 2.0], [0.25, 0.5]),
            piece(3.0, 4.0, [1.5, 3.0], [1.0, 0.0]),
        ]);
        // The second piece has a quarter of the rate, so its two units of the path parameter are half a unit long.
        assert_eq!(path.knots(), [0.0, 1.0, 1.5, 1.75]);
        assert_eq!(path.at(1.25).lambda, 2.0);
        assert_eq!(path.at(1.25).first, path.at(0.5).first);
        assert_eq!(path.at(1.25).q, [1.25, 2.5]);
        assert_eq!(path.at(1.6).first, [4.0, 0.0]);
        assert_eq!(path.at(9.0).q, [2.5, 3.0]);
    }
}
