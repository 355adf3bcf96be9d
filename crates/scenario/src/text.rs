//! A scenario's text: read as tables, and where an error lies in it.

use crate::error::ScenarioError;
use crate::syntax::explained;
use serde::de::DeserializeOwned;
use slideway_path::ProblemError;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Reads a TOML text. `refusal` is what a text meets that can be read: it tells the range of a number that is none.
pub(crate) fn from_toml<T: DeserializeOwned>(
    text: &str,
    refusal: impl Fn(T) -> Option<ScenarioError>,
) -> Result<T, ScenarioError> {
    let refused = |probe: &str| toml::from_str(probe).ok().and_then(&refusal);
    toml::from_str(text).map_err(|error| explained(text, &error, refused))
}

/// Place of an error in a text, as a range of bytes: the value at its key, or the nearest table around it.
#[must_use]
pub fn locate(text: &str, error: &ScenarioError) -> Option<Range<usize>> {
    match error {
        ScenarioError::Syntax { span, .. } | ScenarioError::Text { span, .. } => span.clone(),
        ScenarioError::Problem(ProblemError::LeavesReach { .. } | ProblemError::NoFiniteSpeed { .. }) => {
            locate_key(text, "path.end")
        }
        ScenarioError::Problem(ProblemError::BrokenPath { .. }) => locate_key(text, "path.position"),
        _ => locate_key(text, error.key()?),
    }
}

/// The span of the value at a dotted key, or of the innermost part of the key that is there.
fn locate_key(text: &str, key: &str) -> Option<Range<usize>> {
    let document = DeTable::parse(text).ok()?;
    let mut parts = key.split('.');
    let mut found: Option<&Spanned<DeValue<'_>>> = document.get_ref().get(parts.next()?);
    let mut span = found.map(Spanned::span);
    for part in parts {
        found = match found.map(Spanned::get_ref) {
            Some(DeValue::Table(table)) => table.get(part),
            Some(DeValue::Array(array)) => part.parse::<usize>().ok().and_then(|i| array.get(i)),
            _ => None,
        };
        if let Some(value) = found {
            span = Some(value.span());
        } else {
            break;
        }
    }
    span
}
