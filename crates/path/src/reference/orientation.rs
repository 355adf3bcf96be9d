use crate::curve::{CurveError, RotationPoint, Slerp, Squad};
use crate::formula::Formula;
use crate::reference::point::EulerPoint;
use crate::reference::position::{Curve3, evaluate, kinks};
use nalgebra::{Rotation3, Vector3};
use slideway_robot::euler;
use std::ops::Range;

/// Orientation along the path: Euler triples, or rotations.
#[derive(Clone, Debug)]
pub enum OrientationCurve {
    /// The same Euler triple everywhere, rad.
    Constant(Vector3<f64>),
    /// Linear between Euler triples: [`OrientationCurve::piecewise_linear`] checks their order.
    PiecewiseLinear(Vec<EulerKnot>),
    /// `α, β, γ` as formulas in `lambda`, rad.
    Formula(Box<[Formula; 3]>),
    /// Turns about one axis each between rotations.
    Slerp(Slerp),
    /// A smooth curve through rotations.
    Squad(Squad),
}

/// An Euler triple at a path parameter.
#[derive(Clone, Copy, Debug)]
pub struct EulerKnot {
    /// Path parameter.
    pub at: f64,
    /// `α, β, γ`, rad.
    pub euler: Vector3<f64>,
}

/// The orientation at a path parameter.
#[derive(Clone, Copy, Debug)]
pub struct OrientationPoint {
    pub(crate) rotation: Rotation3<f64>,
    /// `ω` and `ω'` by the path parameter, base frame.
    pub(crate) velocity: Vector3<f64>,
    pub(crate) acceleration: Vector3<f64>,
    /// The Euler triple, where the path is given in them.
    pub(crate) euler: Option<EulerPoint>,
}

impl OrientationCurve {
    /// Euler triples at path parameters, linear in between.
    ///
    /// # Errors
    ///
    /// Fewer than two, or path parameters that do not increase.
    pub fn piecewise_linear(knots: Vec<EulerKnot>) -> Result<Self, CurveError> {
        if knots.len() < 2 {
            return Err(CurveError::TooFew { found: knots.len() });
        }
        let unordered = (1..knots.len()).find(|&i| !(knots[i - 1].at < knots[i].at));
        match unordered {
            Some(index) => {
                Err(CurveError::NotIncreasing { index, before: knots[index - 1].at, value: knots[index].at })
            }
            None => Ok(Self::PiecewiseLinear(knots)),
        }
    }

    /// No turn at all, for tasks that leave the orientation free.
    #[must_use]
    pub fn standing() -> Self {
        Self::Constant(Vector3::zeros())
    }

    pub(crate) fn at(&self, lambda: f64) -> OrientationPoint {
        // [G11] eq 26
        match self {
            Self::Constant(euler) => from_euler([*euler, Vector3::zeros(), Vector3::zeros()]),
            Self::PiecewiseLinear(knots) => {
                let after = knots.partition_point(|k| k.at <= lambda).clamp(1, knots.len() - 1);
                let (a, b) = (knots[after - 1], knots[after]);
                let rate = (b.euler - a.euler) / (b.at - a.at);
                from_euler([a.euler + rate * (lambda - a.at), rate, Vector3::zeros()])
            }
            Self::Formula(formulas) => from_euler(evaluate(formulas, lambda)),
            Self::Slerp(slerp) => slerp.at(lambda).into(),
            Self::Squad(squad) => squad.at(lambda).into(),
        }
    }

    /// Path parameters where the first derivative jumps.
    pub(crate) fn kinks(&self, range: &Range<f64>) -> Vec<f64> {
        match self {
            Self::PiecewiseLinear(knots) => knots.iter().map(|k| k.at).collect(),
            Self::Slerp(slerp) => slerp.kinks(),
            Self::Formula(formulas) => kinks(formulas, range),
            Self::Constant(_) | Self::Squad(_) => Vec::new(),
        }
    }
}

/// `ω = E rates`, `ω' = E rates' + Ė rates`.
fn from_euler([angles, rates, rates2]: Curve3) -> OrientationPoint {
    let map = euler::rate_map(&angles);
    OrientationPoint {
        rotation: euler::rotation(&angles),
        velocity: map * rates,
        acceleration: map * rates2 + euler::rate_map_bias(&angles, &rates),
        euler: Some(EulerPoint { angles, rates }),
    }
}

impl From<RotationPoint> for OrientationPoint {
    fn from(point: RotationPoint) -> Self {
        Self {
            rotation: point.rotation.to_rotation_matrix(),
            velocity: point.velocity,
            acceleration: point.acceleration,
            euler: None,
        }
    }
}
