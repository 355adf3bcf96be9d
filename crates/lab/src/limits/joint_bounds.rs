use crate::error::{Fault, LabError, ListOf};
use crate::formula::Formula;
use crate::scenario::number::{LimitNumber, PerJointLimit};
use std::ops::Range;

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

/// One bound.
#[derive(Clone, Debug)]
enum Bound {
    Constant(f64),
    Along(Box<Formula>),
}

/// What the bounds must be like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BoundSigns {
    /// Rest is inside: the lower negative, the upper positive.
    AroundZero,
    /// The lower below the upper.
    Ordered,
}

/// The keys under which bounds were given, for errors about them.
pub(crate) struct BoundTable<'a> {
    /// Key of the upper bounds: `limits.speed`.
    pub(crate) key: &'static str,
    pub(crate) upper: &'a PerJointLimit,
    /// Lower bounds; without them the negatives of the upper ones.
    pub(crate) lower: Option<&'a PerJointLimit>,
    pub(crate) signs: BoundSigns,
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

    fn negated(number: &LimitNumber) -> LimitNumber {
        match number {
            LimitNumber::Constant(value) => LimitNumber::Constant(-value),
            LimitNumber::Formula(text) => LimitNumber::Formula(format!("-({text})")),
        }
    }

    fn new(key: &str, number: &LimitNumber) -> Result<Self, LabError> {
        Ok(match number {
            LimitNumber::Constant(value) => Self::Constant(*value),
            LimitNumber::Formula(text) => {
                Self::Along(Box::new(Formula::new(text).map_err(|error| LabError::value(key, error))?))
            }
        })
    }
}

impl<const N: usize> JointBounds<N> {
    pub(crate) fn new(table: &BoundTable<'_>, path: &Range<f64>) -> Result<Self, LabError> {
        let lower_key = format!("{}_lower", table.key);
        let upper = bounds(table.key, table.upper, LimitNumber::clone)?;
        let lower = match table.lower {
            Some(lower) => bounds(&lower_key, lower, LimitNumber::clone)?,
            None => bounds(table.key, table.upper, Bound::negated)?,
        };
        let bounds = Self { lower, upper };
        bounds.check(table, path)?;
        Ok(bounds)
    }

    /// The bounds at a path parameter; NaN where a formula has no value.
    #[must_use]
    pub fn at(&self, lambda: f64) -> JointRange<N> {
        JointRange {
            lower: std::array::from_fn(|i| self.lower[i].at(lambda)),
            upper: std::array::from_fn(|i| self.upper[i].at(lambda)),
        }
    }

    /// Whether any bound varies along the path.
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
    pub(crate) fn widest(&self, path: &Range<f64>) -> JointRange<N> {
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

    fn check(&self, table: &BoundTable<'_>, path: &Range<f64>) -> Result<(), LabError> {
        for lambda in probes(path) {
            let JointRange { lower, upper } = self.at(lambda);
            for joint in 0..N {
                self.check_joint(table, joint, lambda, lower[joint]..upper[joint])?;
            }
        }
        Ok(())
    }

    fn check_joint(
        &self,
        table: &BoundTable<'_>,
        joint: usize,
        lambda: f64,
        Range { start: lower, end: upper }: Range<f64>,
    ) -> Result<(), LabError> {
        let varies = matches!(self.upper[joint], Bound::Along(_)) || matches!(self.lower[joint], Bound::Along(_));
        let upper_key = element(table.key, table.upper, joint);
        let lower_key = match table.lower {
            Some(values) => element(&format!("{}_lower", table.key), values, joint),
            None => upper_key.clone(),
        };
        let fault = |key: String, fault: Fault| Err(LabError::value(key, fault));
        match table.signs {
            _ if varies && !(upper.is_finite() && lower.is_finite()) => fault(upper_key, Fault::UndefinedAt(lambda)),
            BoundSigns::AroundZero if !(upper > 0.0) && varies => {
                fault(upper_key, Fault::SignAt { value: upper, lambda })
            }
            BoundSigns::AroundZero if !(upper > 0.0) => fault(upper_key, Fault::NotPositive(upper)),
            BoundSigns::AroundZero if !(lower < 0.0) && varies => {
                fault(lower_key, Fault::SignAt { value: lower, lambda })
            }
            BoundSigns::AroundZero if !(lower < 0.0) => fault(lower_key, Fault::NotNegative(lower)),
            BoundSigns::Ordered if !(lower < upper) => {
                fault(upper_key, Fault::NotIncreasing { before: lower, after: upper })
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

fn bounds<const N: usize>(
    key: &str,
    values: &PerJointLimit,
    of: impl Fn(&LimitNumber) -> LimitNumber,
) -> Result<[Bound; N], LabError> {
    let numbers: Vec<LimitNumber> = match values {
        PerJointLimit::All(number) => vec![of(number); N],
        PerJointLimit::Each(numbers) => numbers.iter().map(of).collect(),
    };
    let found = numbers.len();
    let bounds = numbers
        .iter()
        .enumerate()
        .map(|(joint, number)| Bound::new(&element(key, values, joint), number))
        .collect::<Result<Vec<_>, _>>()?;
    bounds
        .try_into()
        .map_err(|_| LabError::value(key, Fault::WrongLength { found, expected: N, list: ListOf::JointsOrAll }))
}

/// The key of one element of a per-joint value.
fn element(key: &str, values: &PerJointLimit, joint: usize) -> String {
    if matches!(values, PerJointLimit::All(_)) { key.to_owned() } else { format!("{key}.{joint}") }
}

fn probes(path: &Range<f64>) -> impl Iterator<Item = f64> {
    let (start, length) = (path.start, path.end - path.start);
    (0..=PROBES).map(move |i| start + length * f64::from(i) / f64::from(PROBES))
}
