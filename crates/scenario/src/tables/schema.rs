//! Schemas of what is not read by a derived reader.

use super::number::{LimitNumber, Number, PerJointLimit};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use slideway_lab::Method;
use std::borrow::Cow;

/// A method by its name.
pub(super) struct MethodName;

impl JsonSchema for MethodName {
    fn schema_name() -> Cow<'static, str> {
        "Method".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "description": "A speed law.", "type": "string", "enum": Method::ALL.map(Method::name) })
    }
}

impl JsonSchema for Number {
    fn schema_name() -> Cow<'static, str> {
        "Number".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A finite number, or an expression in quotes such as \"pi / 2\".",
            "type": ["number", "string"],
        })
    }
}

impl JsonSchema for LimitNumber {
    fn schema_name() -> Cow<'static, str> {
        "LimitNumber".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A finite number, or a formula of `lambda` in quotes.",
            "type": ["number", "string"],
        })
    }
}

impl JsonSchema for PerJointLimit {
    fn schema_name() -> Cow<'static, str> {
        "PerJointLimit".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "One limit for all joints, or a list with one per joint.",
            "type": ["number", "string", "array"],
            "items": generator.subschema_for::<LimitNumber>(),
        })
    }
}
