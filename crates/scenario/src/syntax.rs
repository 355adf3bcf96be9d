//! What a text that is no scenario lacks, and what would do: the parser's message with the key it is about and a remedy for it.

use crate::built_in::{CONDITIONING_TEMPLATE, TEMPLATE};
use crate::error::ScenarioError;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Required values that the templates do not show, each with one that does.
const EXAMPLES: [(&str, &str); 7] = [
    ("blend", "0.2"),
    ("radius", "0.1"),
    ("side", "\"outside\""),
    ("scale", "0.1"),
    ("exponent", "8"),
    ("sharpness", "100"),
    ("pitch", "0.1"),
];

/// An error of the parser, with its key and a remedy. `refusal` is what a text meets that parses: it tells the range of a number that
/// is none.
pub(crate) fn explained(
    text: &str,
    error: &toml::de::Error,
    refusal: impl Fn(&str) -> Option<ScenarioError>,
) -> ScenarioError {
    let (span, said) = (error.span(), error.message());
    let key = span.clone().and_then(|span| key_at(text, &span)).filter(|key| !key.is_empty());
    let remedy = remedy(said, key.as_deref()).unwrap_or_else(|| {
        let range = span.clone().filter(|_| said.contains("not a finite number")).and_then(|span| {
            let probe = format!("{}-1{}", &text[..span.start], &text[span.end..]);
            refusal(&probe).filter(|refused| refused.key() == key.as_deref()).map(|refused| refused.remedy())
        });
        range.unwrap_or_else(|| general(said).into())
    });
    let message = key.map_or_else(|| said.to_owned(), |key| format!("`{key}`: {}", plain(said)));
    ScenarioError::Text { message, remedy, span }
}

/// The message without the names of the reader's own types.
fn plain(said: &str) -> String {
    match said.split_once(", expected struct ").or_else(|| said.split_once(", expected internally tagged ")) {
        Some((found, _)) => format!("{found}, expected a table"),
        None => said.to_owned(),
    }
}

/// What to do about a message whose kind is known.
fn remedy(said: &str, key: Option<&str>) -> Option<String> {
    let quoted: Vec<&str> = said.split('`').skip(1).step_by(2).collect();
    if said.starts_with("missing field") {
        let name = quoted.first()?;
        return Some(match example(name) {
            Some(value) => format!("add it to the table, for example `{name} = {value}`"),
            None => format!("add `{name}` to the table; the reference of the scenario's keys says what it is"),
        });
    }
    if said.starts_with("unknown field") || said.starts_with("unknown variant") {
        let (name, known) = quoted.split_first()?;
        if known.is_empty() {
            return Some(format!("remove `{name}`"));
        }
        let by_distance = known.iter().map(|known| (strsim::osa_distance(name, known), *known));
        let meant = by_distance.min().filter(|(distance, known)| 3 * distance <= known.len() + 1);
        let list = known.iter().map(|known| format!("`{known}`")).collect::<Vec<_>>().join(", ");
        return Some(match meant {
            Some((_, meant)) => format!("did you mean `{meant}`? One of {list} would do"),
            None => format!("give one of {list} instead"),
        });
    }
    if said.contains("expected struct")
        || said.contains("expected internally tagged")
        || said.contains("expected a map")
    {
        let key = key.unwrap_or("the key");
        let inside = keys_of(key).map_or_else(String::new, |inside| format!(", for example `{key}.{inside}`"));
        return Some(format!("give `{key}` a table, or set one of the keys in it{inside}"));
    }
    if said.starts_with("invalid length") || said.starts_with("invalid type") || said.starts_with("invalid value") {
        return said.split_once("expected ").map(|(_, wanted)| match wanted {
            "u32" | "u64" | "usize" | "a nonzero u64" => "give a whole number that is not negative".into(),
            wanted => format!("give {wanted}"),
        });
    }
    if said.contains("which means nothing here") || said.starts_with("cannot read `") {
        return Some(
            "write numbers, + - * / ^, parentheses, `pi`, and functions such as sin, cos, exp and sqrt".into(),
        );
    }
    None
}

/// What to do about what is not TOML.
fn general(said: &str) -> &'static str {
    match said {
        _ if said.contains("finite number") => "give a finite number",
        _ if said.contains("duplicate key") => "keep one of the two",
        _ => {
            "write `key = value`, one a line, and strings in quotes; `slideway init FILE` writes a scenario to start from"
        }
    }
}

/// A value that a key has in one of the templates, or elsewhere.
fn example(name: &str) -> Option<&'static str> {
    let known = EXAMPLES.iter().find(|(key, _)| *key == name).map(|(_, value)| *value);
    known.or_else(|| {
        let lines = TEMPLATE.lines().chain(CONDITIONING_TEMPLATE.lines());
        let mut values =
            lines.filter_map(|line| line.trim_start_matches("# ").split_once(" = ").filter(|(key, _)| *key == name));
        values.next().map(|(_, value)| value.split(" #").next().unwrap_or(value).trim())
    })
}

/// A key of a table in the templates.
fn keys_of(table: &str) -> Option<String> {
    [TEMPLATE, CONDITIONING_TEMPLATE].iter().find_map(|text| {
        let document: toml::Table = text.parse().ok()?;
        let mut found = document.get(table.split('.').next()?)?;
        for part in table.split('.').skip(1) {
            found = found.get(part)?;
        }
        found.as_table()?.keys().next().cloned()
    })
}

/// The key of the innermost value that holds a place, dotted, list elements counted from 0.
fn key_at(text: &str, place: &Range<usize>) -> Option<String> {
    key_in(of_table(DeTable::parse(text).ok()?.get_ref()), place)
}

/// The same below some entries. A table under a heading spans its heading alone: what is in it is looked at in any case.
fn key_in(entries: Vec<(String, &Spanned<DeValue<'_>>)>, place: &Range<usize>) -> Option<String> {
    entries.into_iter().find_map(|(name, value)| {
        let inside = match value.get_ref() {
            DeValue::Table(table) => of_table(table),
            DeValue::Array(list) => list.iter().enumerate().map(|(i, value)| (i.to_string(), value)).collect(),
            _ => Vec::new(),
        };
        let span = value.span();
        let below = key_in(inside, place).map(|key| format!("{name}.{key}"));
        below.or_else(|| (span.start <= place.start && place.end <= span.end).then_some(name))
    })
}

fn of_table<'a, 'b>(table: &'a DeTable<'b>) -> Vec<(String, &'a Spanned<DeValue<'b>>)> {
    table.iter().map(|(name, value)| (name.get_ref().to_string(), value)).collect()
}
