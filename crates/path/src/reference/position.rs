use crate::curve::{Arc, BlendedLines, CubicSpline};
use crate::error::Fault;
use crate::formula::Formula;
use crate::jumps::{Tangent, jumps};
use nalgebra::Vector3;
use std::ops::Range;

/// Position along the path, m.
#[derive(Clone, Debug)]
pub enum PositionCurve {
    /// `[G11] eq 25`, see [`PositionCurve::helix`].
    Helix {
        /// First point, m.
        start: Vector3<f64>,
        /// Radius, m, positive.
        radius: f64,
        /// Climb, m per rad.
        climb: f64,
    },
    /// A straight line, see [`PositionCurve::line`].
    Line {
        /// First point, m.
        from: Vector3<f64>,
        /// Derivative by the path parameter, m.
        rate: Vector3<f64>,
        /// Path parameter at the first point.
        begin: f64,
    },
    /// A circular arc.
    Arc(Arc),
    /// A cubic spline through way-points.
    Spline(CubicSpline<3>),
    /// Lines between way-points, rounded by blends.
    Lines(BlendedLines<3>),
    /// `x, y, z` as formulas in `lambda`, m.
    Formula(Box<[Formula; 3]>),
}

/// Value and derivatives of three coordinates.
pub type Curve3 = [Vector3<f64>; 3];

impl PositionCurve {
    /// A helix about a vertical axis: radius `radius`, starting at `start` in the direction of +y, `climb` m per rad along z.
    ///
    /// # Errors
    ///
    /// A radius that is not positive.
    pub fn helix(start: Vector3<f64>, radius: f64, climb: f64) -> Result<Self, Fault> {
        if radius > 0.0 { Ok(Self::Helix { start, radius, climb }) } else { Err(Fault::NotPositive(radius)) }
    }

    /// A straight line at constant speed over a range of the path parameter, m.
    #[must_use]
    pub fn line(from: Vector3<f64>, to: Vector3<f64>, range: &Range<f64>) -> Self {
        Self::Line { from, rate: (to - from) / (range.end - range.start), begin: range.start }
    }

    /// Position and its first two derivatives by the path parameter, m; at a kink, those of the piece that begins there.
    #[must_use]
    pub fn at(&self, lambda: f64) -> Curve3 {
        match self {
            Self::Helix { start, radius, climb } => {
                // [G11] eq 25.
                let (s, c) = lambda.sin_cos();
                [
                    start + Vector3::new(radius * (c - 1.0), radius * s, climb * lambda),
                    Vector3::new(-radius * s, radius * c, *climb),
                    Vector3::new(-radius * c, -radius * s, 0.0),
                ]
            }
            Self::Line { from, rate, begin } => [from + rate * (lambda - begin), *rate, Vector3::zeros()],
            Self::Arc(arc) => arc.at(lambda),
            Self::Spline(spline) => spline.at(lambda),
            Self::Lines(lines) => lines.at(lambda),
            Self::Formula(formulas) => evaluate(formulas, lambda),
        }
    }

    /// Path parameters where the first derivative jumps.
    pub(crate) fn kinks(&self, range: &Range<f64>) -> Vec<f64> {
        match self {
            Self::Lines(lines) => lines.kinks(),
            Self::Formula(formulas) => kinks(formulas, range),
            Self::Helix { .. } | Self::Line { .. } | Self::Arc(_) | Self::Spline(_) => Vec::new(),
        }
    }
}

/// Points between which kinks of formulas are looked for.
const PROBES: u32 = 1000;
/// Jump of a derivative, as a share of its largest value, that is a kink: far above what smooth curves change by between the points besides what their
/// second derivatives tell.
const KINK: f64 = 1e-6;

/// Path parameters where the first derivative of three formulas jumps.
pub(crate) fn kinks(formulas: &[Formula; 3], range: &Range<f64>) -> Vec<f64> {
    let tangent = |at: f64| {
        let [_, value, slope] = evaluate(formulas, at);
        let finite = value.iter().chain(&slope).all(|x| x.is_finite());
        finite.then_some(Tangent { at, value, slope })
    };
    let probe = |i: u32| range.start + (range.end - range.start) * f64::from(i) / f64::from(PROBES);
    let points: Vec<_> = (0..=PROBES).filter_map(|i| tangent(probe(i))).collect();
    let largest = points.iter().map(|point| point.value.norm()).fold(0.0, f64::max);
    jumps(&points, KINK * largest, tangent)
}

/// Three formulas and their derivatives at a path parameter.
pub(crate) fn evaluate(formulas: &[Formula; 3], lambda: f64) -> Curve3 {
    let [x, y, z] = [formulas[0].at(lambda), formulas[1].at(lambda), formulas[2].at(lambda)];
    [0, 1, 2].map(|order| Vector3::new(x[order], y[order], z[order]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    #[test]
    fn kinks_of_formulas_are_found_where_a_derivative_jumps_and_nowhere_else() {
        let found = |x: &str| {
            let formula = |text: &str| Formula::new(text).expect("parses");
            let curve = PositionCurve::Formula(Box::new([formula(x), formula("lambda"), formula("0")]));
            curve.kinks(&(0.0..1.0))
        };
        for (text, at) in [
            ("0.1 * abs(lambda - 0.5)", vec![0.5]),
            ("max(0, sin(9 * lambda + 1))", [PI, TAU, 3.0 * PI].map(|x| (x - 1.0) / 9.0).to_vec()),
            ("min(lambda, 0.3217) + abs(lambda - 0.1234)", vec![0.1234, 0.3217]),
        ] {
            let kinks = found(text);
            assert_eq!(kinks.len(), at.len(), "{text}: {kinks:?}");
            // Rounding of sin near its zero, 1e-16 over a slope of 9.
            assert!(kinks.iter().zip(&at).all(|(found, at)| (found - at).abs() < 1e-14), "{text}: {kinks:?}");
        }
        for smooth in [
            "abs(lambda + 1)",
            "sin(200 * lambda)",
            "tanh(1000 * (lambda - 0.3))",
            "sqrt(lambda + 1e-6)",
            "abs(lambda - 0.5)^3",
        ] {
            assert_eq!(found(smooth), [], "{smooth}");
        }
    }
}
