//! Values of a scenario's text, replaced where they stand.

use serde::{Deserialize, Serialize};
use slideway_verify::ProposedValue;
use std::ops::Range;
use thiserror::Error;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value of the scenario that is replaced.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Change {
    /// Its key.
    pub key: String,
    /// As it stands in the scenario.
    pub before: String,
    /// As proposed.
    pub after: f64,
    /// Its unit.
    pub unit: String,
}

/// A key that the scenario does not have.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("the scenario has no `{key}` to change")]
pub struct NoKey {
    /// The key.
    pub key: String,
}

/// The text with the values replaced and what was changed; keys whose value stays the same are left alone.
pub(crate) fn replaced(text: &str, values: &[ProposedValue]) -> Result<(String, Vec<Change>), NoKey> {
    let mut edits: Vec<(Range<usize>, Change)> = Vec::new();
    for ProposedValue { key, value, unit } in values {
        let span = span(text, key).ok_or_else(|| NoKey { key: (*key).to_owned() })?;
        let before = text[span.clone()].to_owned();
        if before.parse() != Ok(*value) {
            edits.push((span, Change { key: (*key).to_owned(), before, after: *value, unit: (*unit).to_owned() }));
        }
    }
    let changes = edits.iter().map(|(_, change)| change.clone()).collect();
    // From the end, so that the places before stay where they are.
    edits.sort_by_key(|(span, _)| std::cmp::Reverse(span.start));
    let mut text = text.to_owned();
    for (span, change) in edits {
        text.replace_range(span, &shown(change.after));
    }
    Ok((text, changes))
}

/// A number as TOML: plain where that is short.
pub(crate) fn shown(value: f64) -> String {
    let plain = value.to_string();
    if plain.len() <= 8 { plain } else { format!("{value:e}") }
}

/// Where the value of a dotted key stands.
fn span(text: &str, key: &str) -> Option<Range<usize>> {
    let document = DeTable::parse(text).ok()?;
    let mut parts = key.split('.');
    let mut found: &Spanned<DeValue<'_>> = document.get_ref().get(parts.next()?)?;
    for part in parts {
        let DeValue::Table(table) = found.get_ref() else { return None };
        found = table.get(part)?;
    }
    Some(found.span())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_is_replaced_where_it_stands_and_nothing_else_is() {
        let text = "# keep\n[control]\nbandwidth = 5 # rad/s\nlaw.sum.gain = \"2 * 3\"\ntarget_rate = 4\n";
        let settings = [
            ProposedValue { key: "control.target_rate", value: 4.0, unit: "1/s" },
            ProposedValue { key: "control.law.sum.gain", value: 0.000_012_5, unit: "1" },
            ProposedValue { key: "control.bandwidth", value: 7.5, unit: "rad/s" },
        ];
        let (changed, changes) = replaced(text, &settings).expect("every key is there");
        assert_eq!(changed, "# keep\n[control]\nbandwidth = 7.5 # rad/s\nlaw.sum.gain = 1.25e-5\ntarget_rate = 4\n");
        assert_eq!(changes.len(), 2);
        assert!(replaced(text, &[ProposedValue { key: "control.gain", value: 1.0, unit: "1/s" }]).is_err());
    }
}
