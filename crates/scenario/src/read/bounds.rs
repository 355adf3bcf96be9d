use crate::tables::number::{LimitNumber, PerJointLimit};
use slideway_path::formula::Formula;
use slideway_path::{Bound, BoundError, BoundSide, BoundSigns, Fault, JointBounds, ListOf, ProblemError};
use std::ops::Range;

/// The keys under which bounds were given, for errors about them.
pub(crate) struct BoundTable<'a> {
    /// Key of the upper bounds: `limits.speed`.
    pub(crate) key: &'static str,
    pub(crate) upper: &'a PerJointLimit,
    /// Lower bounds; without them the negatives of the upper ones.
    pub(crate) lower: Option<&'a PerJointLimit>,
    pub(crate) signs: BoundSigns,
}

impl BoundTable<'_> {
    pub(crate) fn read<const N: usize>(&self, path: &Range<f64>) -> Result<JointBounds<N>, ProblemError> {
        let upper = bounds(self.key, self.upper, LimitNumber::clone)?;
        let lower = match self.lower {
            Some(lower) => bounds(&self.lower_key(), lower, LimitNumber::clone)?,
            None => bounds(self.key, self.upper, negated)?,
        };
        JointBounds::new(lower, upper, self.signs, path).map_err(|error| self.pointed(error))
    }

    fn lower_key(&self) -> String {
        format!("{}_lower", self.key)
    }

    /// The error at the key of its bound.
    fn pointed(&self, error: BoundError) -> ProblemError {
        let BoundError { joint, side, fault } = error;
        let key = match (side, self.lower) {
            (BoundSide::Lower, Some(values)) => element(&self.lower_key(), values, joint),
            _ => element(self.key, self.upper, joint),
        };
        ProblemError::value(key, fault)
    }
}

fn bound(key: &str, number: &LimitNumber) -> Result<Bound, ProblemError> {
    Ok(match number {
        LimitNumber::Constant(value) => Bound::Constant(*value),
        LimitNumber::Formula(text) => {
            Bound::Along(Box::new(Formula::new(text).map_err(|error| ProblemError::value(key, error))?))
        }
    })
}

fn negated(number: &LimitNumber) -> LimitNumber {
    match number {
        LimitNumber::Constant(value) => LimitNumber::Constant(-value),
        LimitNumber::Formula(text) => LimitNumber::Formula(format!("-({text})")),
    }
}

fn bounds<const N: usize>(
    key: &str,
    values: &PerJointLimit,
    of: impl Fn(&LimitNumber) -> LimitNumber,
) -> Result<[Bound; N], ProblemError> {
    let numbers: Vec<LimitNumber> = match values {
        PerJointLimit::All(number) => vec![of(number); N],
        PerJointLimit::Each(numbers) => numbers.iter().map(of).collect(),
    };
    let found = numbers.len();
    let bounds = numbers
        .iter()
        .enumerate()
        .map(|(joint, number)| bound(&element(key, values, joint), number))
        .collect::<Result<Vec<_>, _>>()?;
    bounds
        .try_into()
        .map_err(|_| ProblemError::value(key, Fault::WrongLength { found, expected: N, list: ListOf::JointsOrAll }))
}

/// The key of one element of a per-joint value.
fn element(key: &str, values: &PerJointLimit, joint: usize) -> String {
    if matches!(values, PerJointLimit::All(_)) { key.to_owned() } else { format!("{key}.{joint}") }
}
