//! Numbers in JSON, which knows neither NaN nor infinity: finite ones as numbers, bit by bit, the others as the words `"NaN"`,
//! `"inf"` and `"-inf"`. For `#[serde(with = "number")]`.

use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};

/// Writes a number.
///
/// # Errors
///
/// Errors of the serialiser.
pub fn serialize<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    Written::of(*value).serialize(serializer)
}

/// Reads a number.
///
/// # Errors
///
/// Neither a number nor one of the words.
pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    Written::deserialize(deserializer)?.value().map_err(D::Error::custom)
}

#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum Written {
    Number(f64),
    Word(String),
}

impl Written {
    fn of(value: f64) -> Self {
        if value.is_finite() { Self::Number(value) } else { Self::Word(value.to_string()) }
    }

    fn value(self) -> Result<f64, String> {
        match self {
            Self::Number(value) => Ok(value),
            Self::Word(word) => match word.as_str() {
                "NaN" => Ok(f64::NAN),
                "inf" => Ok(f64::INFINITY),
                "-inf" => Ok(f64::NEG_INFINITY),
                _ => Err(format!("`{word}` is no number")),
            },
        }
    }
}

/// The same for a number that may be missing, which is null.
pub mod option {
    use super::{Deserialize, Deserializer, Serialize, Serializer, Written};
    use serde::de::Error as _;

    /// Writes a number or null.
    ///
    /// # Errors
    ///
    /// Errors of the serialiser.
    #[allow(clippy::ref_option)]
    pub fn serialize<S: Serializer>(value: &Option<f64>, serializer: S) -> Result<S::Ok, S::Error> {
        value.map(Written::of).serialize(serializer)
    }

    /// Reads a number or null.
    ///
    /// # Errors
    ///
    /// Neither null nor a number nor one of the words.
    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<f64>, D::Error> {
        let written = Option::<Written>::deserialize(deserializer)?;
        written.map(Written::value).transpose().map_err(D::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use serde::{Deserialize, Serialize};

    #[derive(Serialize, Deserialize)]
    struct Pair {
        #[serde(with = "super")]
        sure: f64,
        #[serde(with = "super::option")]
        maybe: Option<f64>,
    }

    #[test]
    fn every_number_comes_back_bit_by_bit() {
        for value in [0.0, -0.0, 0.1 + 0.2, 5e-324, 1.797e308, 3.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let text = serde_json::to_string(&Pair { sure: value, maybe: Some(value) }).expect("writes");
            let back: Pair = serde_json::from_str(&text).expect("reads");
            // The sign of a NaN says nothing.
            let same = |a: f64| a.to_bits() == value.to_bits() || a.is_nan() && value.is_nan();
            assert!(same(back.sure) && back.maybe.is_some_and(same), "{text}");
        }
    }

    #[test]
    fn nothing_is_null_and_other_words_are_refused() {
        assert_eq!(
            serde_json::to_string(&Pair { sure: 1.0, maybe: None }).expect("writes"),
            r#"{"sure":1.0,"maybe":null}"#
        );
        assert!(serde_json::from_str::<Pair>(r#"{"sure":"much","maybe":null}"#).is_err());
    }
}
