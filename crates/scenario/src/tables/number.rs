//! Numbers as people type them: `0.5`, `3`, `"pi / 2"`.

use serde::de::{self, Deserialize, Deserializer, Visitor};
use slideway_path::{Fault, ListOf, ProblemError, formula};
use slideway_robot::JointVector;
use std::fmt;

/// A finite number, or a constant expression in a string.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Number(pub(crate) f64);

struct NumberVisitor;

impl Visitor<'_> for NumberVisitor {
    type Value = Number;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a finite number, or an expression in quotes such as \"pi / 2\"")
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Number, E> {
        if value.is_finite() { Ok(Number(value)) } else { Err(E::custom(format!("{value} is not a finite number"))) }
    }

    // TOML integers are typed by people: far below 2^53.
    #[allow(clippy::cast_precision_loss)]
    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Number, E> {
        Ok(Number(value as f64))
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Number, E> {
        formula::constant(text).map(Number).map_err(E::custom)
    }
}

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NumberVisitor)
    }
}

/// A limit: a finite number, or a formula in `lambda`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum LimitNumber {
    Constant(f64),
    Formula(String),
}

struct LimitVisitor;

impl Visitor<'_> for LimitVisitor {
    type Value = LimitNumber;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a finite number, or a formula of `lambda` in quotes")
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<LimitNumber, E> {
        NumberVisitor.visit_f64(value).map(|n| LimitNumber::Constant(n.0))
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<LimitNumber, E> {
        NumberVisitor.visit_i64(value).map(|n| LimitNumber::Constant(n.0))
    }

    // A formula is parsed where its key is known.
    fn visit_str<E: de::Error>(self, text: &str) -> Result<LimitNumber, E> {
        if formula::mentions_lambda(text) {
            return Ok(LimitNumber::Formula(text.to_owned()));
        }
        NumberVisitor.visit_str(text).map(|n| LimitNumber::Constant(n.0))
    }
}

impl<'de> Deserialize<'de> for LimitNumber {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(LimitVisitor)
    }
}

/// One limit for all joints, or a list with one per joint.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum PerJointLimit {
    All(LimitNumber),
    Each(Vec<LimitNumber>),
}

struct PerJointVisitor;

impl<'de> Visitor<'de> for PerJointVisitor {
    type Value = PerJointLimit;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a finite number, a formula of `lambda` in quotes, or a list of them with one per joint")
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<PerJointLimit, E> {
        LimitVisitor.visit_f64(value).map(PerJointLimit::All)
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<PerJointLimit, E> {
        LimitVisitor.visit_i64(value).map(PerJointLimit::All)
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<PerJointLimit, E> {
        LimitVisitor.visit_str(text).map(PerJointLimit::All)
    }

    fn visit_seq<A: de::SeqAccess<'de>>(self, mut sequence: A) -> Result<PerJointLimit, A::Error> {
        let mut values = Vec::new();
        while let Some(value) = sequence.next_element()? {
            values.push(value);
        }
        Ok(PerJointLimit::Each(values))
    }
}

impl<'de> Deserialize<'de> for PerJointLimit {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PerJointVisitor)
    }
}

struct ListVisitor;

impl<'de> Visitor<'de> for ListVisitor {
    type Value = Vec<Number>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of numbers, one per joint, like `[0, 0.1]`")
    }

    fn visit_seq<A: de::SeqAccess<'de>>(self, mut sequence: A) -> Result<Vec<Number>, A::Error> {
        let mut numbers = Vec::new();
        while let Some(number) = sequence.next_element()? {
            numbers.push(number);
        }
        Ok(numbers)
    }
}

/// Reads a list with a number per joint: unlike a limit, a single number does not stand for all of them.
pub(crate) fn list<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Vec<Number>>, D::Error> {
    deserializer.deserialize_any(ListVisitor).map(Some)
}

/// A number for each joint.
pub(crate) fn joints<const N: usize>(key: &str, numbers: &[Number]) -> Result<JointVector<N>, ProblemError> {
    if numbers.len() != N {
        return Err(ProblemError::value(
            key,
            Fault::WrongLength { found: numbers.len(), expected: N, list: ListOf::Joints },
        ));
    }
    Ok(JointVector::from_fn(|i, _| numbers[i].0))
}

/// A number above zero; NaN is none.
pub(crate) fn positive(key: &str, number: Number) -> Result<f64, ProblemError> {
    if number.0 > 0.0 { Ok(number.0) } else { Err(ProblemError::value(key, Fault::NotPositive(number.0))) }
}
