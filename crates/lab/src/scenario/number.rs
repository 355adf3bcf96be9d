//! Numbers as people type them: `0.5`, `3`, `"pi / 2"`.

use crate::formula;
use serde::de::{self, Deserialize, Deserializer, Visitor};
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

/// One number for all joints, or a list with one number per joint.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum PerJoint {
    All(f64),
    Each(Vec<f64>),
}

struct PerJointVisitor;

impl<'de> Visitor<'de> for PerJointVisitor {
    type Value = PerJoint;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a finite number, or a list with one number per joint")
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<PerJoint, E> {
        NumberVisitor.visit_f64(value).map(|n| PerJoint::All(n.0))
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<PerJoint, E> {
        NumberVisitor.visit_i64(value).map(|n| PerJoint::All(n.0))
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<PerJoint, E> {
        NumberVisitor.visit_str(text).map(|n| PerJoint::All(n.0))
    }

    fn visit_seq<A: de::SeqAccess<'de>>(self, mut sequence: A) -> Result<PerJoint, A::Error> {
        let mut values = Vec::new();
        while let Some(Number(value)) = sequence.next_element()? {
            values.push(value);
        }
        Ok(PerJoint::Each(values))
    }
}

impl<'de> Deserialize<'de> for PerJoint {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PerJointVisitor)
    }
}
