use crate::curve::{BlendedLines, CubicSpline, PolynomialPiece};
use slideway_robot::JointVector;
use std::ops::Range;

/// A path of the joints: configurations as a function of the path parameter `λ`, rad (m for joints that slide).
#[derive(Clone, Debug)]
pub struct JointCurve<const N: usize> {
    range: Range<f64>,
    shape: Shape<N>,
}

/// Curve that joins the configurations.
#[derive(Clone, Debug)]
enum Shape<const N: usize> {
    Line { from: JointVector<N>, rate: JointVector<N> },
    Spline(CubicSpline<N>),
    Lines(BlendedLines<N>),
}

impl<const N: usize> JointCurve<N> {
    /// A straight line at constant speed over a range of the path parameter.
    #[must_use]
    pub fn line(from: JointVector<N>, to: JointVector<N>, range: Range<f64>) -> Self {
        Self { shape: Shape::Line { from, rate: (to - from) / (range.end - range.start) }, range }
    }

    /// A spline, over a range of the path parameter that its way-points cover.
    #[must_use]
    pub fn spline(spline: CubicSpline<N>, range: Range<f64>) -> Self {
        Self { shape: Shape::Spline(spline), range }
    }

    /// Blended lines, over a range of the path parameter that their way-points cover.
    #[must_use]
    pub fn lines(lines: BlendedLines<N>, range: Range<f64>) -> Self {
        Self { shape: Shape::Lines(lines), range }
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

    /// The polynomials that the path consists of, in the order of the path.
    #[must_use]
    pub fn polynomials(&self) -> Vec<PolynomialPiece<N>> {
        let Range { start, end } = self.range;
        match &self.shape {
            Shape::Line { from, rate } => vec![PolynomialPiece { start, end, powers: vec![*from, *rate] }],
            Shape::Spline(spline) => spline.polynomials(&self.range),
            Shape::Lines(lines) => lines.polynomials(&self.range),
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
