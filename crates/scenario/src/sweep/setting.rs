use super::error::SweepError;
use toml::{Table, Value};

/// One value of a scenario file to be replaced: a dotted key, list elements counted from 0, and the value.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// The key, for example `constraint.0.approach`.
    pub key: String,
    /// The value it is given.
    pub value: Value,
}

/// One axis of a grid: a key and the values it takes, in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The key.
    pub key: String,
    /// Its values.
    pub values: Vec<Value>,
}

impl Setting {
    /// Parses `KEY=VALUE`.
    ///
    /// The value is TOML. A bare word or formula, which TOML does not know, is taken as a string: a shell eats the quotes of
    /// `trap.walk="paper"`.
    ///
    /// # Errors
    ///
    /// No equals sign, an empty part of the key, or a value with an open bracket or quote.
    pub fn parse(text: &str) -> Result<Self, SweepError> {
        let (key, value) = assignment(text)?;
        Ok(Self { value: self::value(&key, value)?, key })
    }

    /// Puts the value into a document; tables on the way are made where they are missing.
    ///
    /// # Errors
    ///
    /// The key leads through a plain value or to an element that a list does not have.
    pub fn apply(&self, document: &mut Table) -> Result<(), SweepError> {
        let mut parts = self.key.split('.');
        let first = parts.next().unwrap_or_default();
        let mut at = first.to_owned();
        let mut slot = document.entry(first).or_insert_with(|| Value::Table(Table::new()));
        for part in parts {
            slot = self.descend(slot, &at, part)?;
            at = format!("{at}.{part}");
        }
        *slot = self.value.clone();
        Ok(())
    }

    fn descend<'a>(&self, slot: &'a mut Value, at: &str, part: &str) -> Result<&'a mut Value, SweepError> {
        let key = || self.key.clone();
        match slot {
            Value::Table(table) => Ok(table.entry(part).or_insert_with(|| Value::Table(Table::new()))),
            Value::Array(list) => {
                let length = list.len();
                part.parse::<usize>().ok().and_then(|i| list.get_mut(i)).ok_or_else(|| SweepError::NoElement {
                    key: key(),
                    at: at.into(),
                    length,
                    element: part.into(),
                })
            }
            plain => Err(SweepError::NotATable { key: key(), at: at.into(), found: plain.to_string() }),
        }
    }
}

impl Axis {
    /// Parses `KEY=V1,V2,...`; commas inside brackets, braces and quotes do not separate.
    ///
    /// # Errors
    ///
    /// As for [`Setting::parse`].
    pub fn parse(text: &str) -> Result<Self, SweepError> {
        let (key, values) = assignment(text)?;
        let values = elements(values).into_iter().map(|v| value(&key, v)).collect::<Result<_, _>>()?;
        Ok(Self { key, values })
    }
}

/// A value as a person would type it: strings without quotes, everything else as TOML.
#[must_use]
pub fn shown(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}

/// Whether one of two keys contains the other.
pub(crate) fn overlap(a: &str, b: &str) -> bool {
    let (short, long) = if a.len() <= b.len() { (a, b) } else { (b, a) };
    long.strip_prefix(short).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}

fn assignment(text: &str) -> Result<(String, &str), SweepError> {
    let wrong = || SweepError::NotAssigned { given: text.to_owned() };
    let (key, value) = text.split_once('=').ok_or_else(wrong)?;
    let (key, value) = (key.trim(), value.trim());
    if key.split('.').any(|part| part.is_empty() || part.contains(char::is_whitespace)) || value.is_empty() {
        return Err(wrong());
    }
    Ok((key.to_owned(), value))
}

fn value(key: &str, text: &str) -> Result<Value, SweepError> {
    let text = text.trim();
    // One line only: a line break would smuggle in another key.
    let parsed = if text.contains('\n') { None } else { Some(format!("value = {text}").parse::<Table>()) };
    match parsed {
        Some(Ok(mut table)) if table.len() == 1 => table.remove("value").ok_or_else(|| refused(key, text, "")),
        _ if text.is_empty() => Err(refused(key, text, "nothing between two commas")),
        Some(Err(error)) if text.starts_with(['[', '{', '"', '\'']) => Err(refused(key, text, error.message())),
        _ => Ok(Value::String(text.to_owned())),
    }
}

fn refused(key: &str, value: &str, reason: &str) -> SweepError {
    SweepError::Value { key: key.into(), value: value.into(), reason: reason.into() }
}

/// Splits at the commas outside brackets, braces, parentheses and quotes.
fn elements(text: &str) -> Vec<&str> {
    let (mut parts, mut begin, mut depth, mut quote) = (Vec::new(), 0, 0_i32, None);
    for (i, c) in text.char_indices() {
        match (quote, c) {
            (Some(open), c) if c == open => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') => quote = Some(c),
            (None, '[' | '{' | '(') => depth += 1,
            (None, ']' | '}' | ')') => depth -= 1,
            (None, ',') if depth == 0 => {
                parts.push(&text[begin..i]);
                begin = i + 1;
            }
            _ => {}
        }
    }
    parts.push(&text[begin..]);
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    fn applied(document: &str, setting: &str) -> Result<Table, SweepError> {
        let mut table: Table = document.parse().expect("TOML");
        Setting::parse(setting)?.apply(&mut table).map(|()| table)
    }

    #[test]
    fn a_setting_replaces_one_value_and_nothing_else() {
        let found = applied("a.b = [1, { c = 2, d = 3 }]\ne = 4", "a.b.1.c=\"x\"").expect("applies");
        assert_eq!(found, "a.b = [1, { c = 'x', d = 3 }]\ne = 4".parse().expect("TOML"));
    }

    #[test]
    fn bare_words_and_formulas_are_strings_and_numbers_are_numbers() {
        for (text, expected) in [
            ("k=paper", Value::String("paper".into())),
            ("k=2 * pi / 5", Value::String("2 * pi / 5".into())),
            ("k = 2e-4", Value::Float(2e-4)),
            ("k=5", Value::Integer(5)),
            ("k=a=b", Value::String("a=b".into())),
        ] {
            assert_eq!(Setting::parse(text).expect("parses").value, expected, "{text}");
        }
    }

    #[test]
    fn commas_separate_only_outside_brackets_and_quotes() {
        let axis = Axis::parse("k=[1, 2],{ a = 1, b = 2 },\"x,y\",max(1, 2),5").expect("parses");
        assert_eq!(axis.values.iter().map(shown).collect::<Vec<_>>().len(), 5);
        assert_eq!(shown(&axis.values[2]), "x,y");
        assert_eq!(shown(&axis.values[3]), "max(1, 2)");
    }

    #[test]
    fn broken_assignments_are_refused() {
        for text in ["k", "=1", "k=", "a..b=1", "a b=1"] {
            assert!(matches!(Setting::parse(text), Err(SweepError::NotAssigned { .. })), "{text}");
        }
        for text in ["k=[1", "k=\"x", "k={a=1"] {
            assert!(matches!(Setting::parse(text), Err(SweepError::Value { .. })), "{text}");
        }
        assert!(matches!(Axis::parse("k=1,,2"), Err(SweepError::Value { .. })));
    }

    #[test]
    fn keys_through_plain_values_and_past_the_end_of_lists_are_refused() {
        assert!(matches!(applied("a = 1", "a.b=1"), Err(SweepError::NotATable { .. })));
        assert!(matches!(applied("a = [1]", "a.1=1"), Err(SweepError::NoElement { length: 1, .. })));
        assert!(matches!(applied("a = [1]", "a.x=1"), Err(SweepError::NoElement { .. })));
    }

    #[test]
    fn a_key_overlaps_with_what_it_contains_but_not_with_its_namesakes() {
        assert!(overlap("trap.walk", "trap.walk.safe") && overlap("trap", "trap"));
        assert!(!overlap("trap.walk", "trap.walk_speed"));
    }
}
