//! Values of a scenario's text, replaced where they stand.

use super::Change;
use crate::error::VerifyError;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value to be given to a key.
pub(super) struct Setting {
    pub(super) key: &'static str,
    pub(super) value: f64,
    pub(super) unit: &'static str,
}

/// The text with the values replaced and what was changed; keys whose value stays the same are left alone.
pub(super) fn replaced(text: &str, settings: &[Setting]) -> Result<(String, Vec<Change>), VerifyError> {
    let mut edits: Vec<(Range<usize>, Change)> = Vec::new();
    for Setting { key, value, unit } in settings {
        let span = span(text, key).ok_or_else(|| VerifyError::NoKey { key: (*key).to_owned() })?;
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
pub(super) fn shown(value: f64) -> String {
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
            Setting { key: "control.target_rate", value: 4.0, unit: "1/s" },
            Setting { key: "control.law.sum.gain", value: 0.000_012_5, unit: "1" },
            Setting { key: "control.bandwidth", value: 7.5, unit: "rad/s" },
        ];
        let (changed, changes) = replaced(text, &settings).expect("every key is there");
        assert_eq!(changed, "# keep\n[control]\nbandwidth = 7.5 # rad/s\nlaw.sum.gain = 1.25e-5\ntarget_rate = 4\n");
        assert_eq!(changes.len(), 2);
        assert!(replaced(text, &[Setting { key: "control.gain", value: 1.0, unit: "1/s" }]).is_err());
    }
}
