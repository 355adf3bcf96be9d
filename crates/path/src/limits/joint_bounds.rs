use crate::error::Fault;
use crate::formula::Formula;
use std::ops::Range;
use thiserror::Error;

/// A lower and an upper bound per joint, constant or varying along the path.
#[derive(Clone, Debug)]
pub struct JointBounds<const N: usize> {
    lower: [Bound; N],
    upper: [Bound; N],
}

/// Bounds at one point of the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointRange<const N: usize> {
    /// Lower bounds.
    pub lower: [f64; N],
    /// Upper bounds.
    pub upper: [f64; N],
}

/// A bound: the same along the whole path, or a function of the path parameter.
#[derive(Clone, Debug)]
pub enum Bound {
    /// The same everywhere.
    Constant(f64),
    /// A formula in `lambda`.
    Along(Box<Formula>),
}

/// Signs that bounds must have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundSigns {
    /// Rest is inside: the lower negative, the upper positive.
    AroundZero,
    /// The lower below the upper.
    Ordered,
}

/// A bound that cannot be used.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{side} bound of joint {joint} (counted from 0): {fault}")]
pub struct BoundError {
    /// The joint, counted from 0.
    pub joint: usize,
    /// The bound of the joint: lower or upper.
    pub side: BoundSide,
    /// Fault of the bound.
    pub fault: Fault,
}

/// One of a joint's two bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundSide {
    /// The lower one.
    Lower,
    /// The upper one.
    Upper,
}

impl std::fmt::Display for BoundSide {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Lower => "lower",
            Self::Upper => "upper",
        })
    }
}

/// Points of the path at which formulas are tried.
const PROBES: u32 = 1000;

impl Bound {
    fn at(&self, lambda: f64) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Along(formula) => formula.at(lambda)[0],
        }
    }
}

impl<const N: usize> JointBounds<N> {
    /// Bounds for a range of the path parameter, on a thousand points of which formulas are tried.
    ///
    /// # Errors
    ///
    /// A bound of the wrong sign, or a formula without a finite value somewhere.
    pub fn new(lower: [Bound; N], upper: [Bound; N], signs: BoundSigns, path: &Range<f64>) -> Result<Self, BoundError> {
        let bounds = Self { lower, upper };
        for lambda in probes(path) {
            let JointRange { lower, upper } = bounds.at(lambda);
            for joint in 0..N {
                bounds.check(signs, joint, lambda, lower[joint]..upper[joint])?;
            }
        }
        Ok(bounds)
    }

    /// Bounds `-limits` and `limits`, the same along the whole path.
    ///
    /// # Errors
    ///
    /// A limit that is not positive.
    pub fn symmetric(limits: [f64; N]) -> Result<Self, BoundError> {
        let constant = |sign: f64| limits.map(|limit| Bound::Constant(sign * limit));
        Self::new(constant(-1.0), constant(1.0), BoundSigns::AroundZero, &(0.0..0.0))
    }

    /// The bounds at a path parameter; NaN where a formula has no value.
    #[must_use]
    pub fn at(&self, lambda: f64) -> JointRange<N> {
        JointRange {
            lower: std::array::from_fn(|i| self.lower[i].at(lambda)),
            upper: std::array::from_fn(|i| self.upper[i].at(lambda)),
        }
    }

    /// True if any bound varies along the path.
    #[must_use]
    pub fn vary(&self) -> bool {
        self.lower.iter().chain(&self.upper).any(|bound| matches!(bound, Bound::Along(_)))
    }

    /// The bounds, if they are the same everywhere.
    #[must_use]
    pub fn constant(&self) -> Option<JointRange<N>> {
        (!self.vary()).then(|| self.at(0.0))
    }

    /// The widest the bounds get, on a thousand points of the path.
    #[must_use]
    pub fn widest(&self, path: &Range<f64>) -> JointRange<N> {
        let mut widest = self.at(path.start);
        for lambda in probes(path) {
            let here = self.at(lambda);
            for i in 0..N {
                widest.lower[i] = widest.lower[i].min(here.lower[i]);
                widest.upper[i] = widest.upper[i].max(here.upper[i]);
            }
        }
        widest
    }

    fn check(
        &self,
        signs: BoundSigns,
        joint: usize,
        lambda: f64,
        Range { start: lower, end: upper }: Range<f64>,
    ) -> Result<(), BoundError> {
        let varies = matches!(self.upper[joint], Bound::Along(_)) || matches!(self.lower[joint], Bound::Along(_));
        let refused = |side, fault: Fault| Err(BoundError { joint, side, fault });
        let of_sign = |value, constant| if varies { Fault::SignAt { value, lambda } } else { constant };
        match signs {
            _ if varies && !(upper.is_finite() && lower.is_finite()) => {
                refused(BoundSide::Upper, Fault::UndefinedAt(lambda))
            }
            BoundSigns::AroundZero if !(upper > 0.0) => {
                refused(BoundSide::Upper, of_sign(upper, Fault::NotPositive(upper)))
            }
            BoundSigns::AroundZero if !(lower < 0.0) => {
                refused(BoundSide::Lower, of_sign(lower, Fault::NotNegative(lower)))
            }
            BoundSigns::Ordered if !(lower < upper) => {
                refused(BoundSide::Upper, Fault::NotIncreasing { before: lower, after: upper })
            }
            BoundSigns::AroundZero | BoundSigns::Ordered => Ok(()),
        }
    }
}

impl<const N: usize> JointRange<N> {
    /// The upper bounds, if the lower ones are their negatives.
    #[must_use]
    pub fn symmetric(&self) -> Option<[f64; N]> {
        self.lower.iter().zip(&self.upper).all(|(lower, upper)| *lower == -upper).then_some(self.upper)
    }
}

fn probes(path: &Range<f64>) -> impl Iterator<Item = f64> {
    let (start, length) = (path.start, path.end - path.start);
    (0..=PROBES).map(move |i| start + length * f64::from(i) / f64::from(PROBES))
}
