use serde::Serialize;

/// A published value beside what this project computes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Published {
    /// Where it is printed, such as `[N] Table I`.
    pub source: &'static str,
    /// The run it belongs to, with the setting where there are two readings of it.
    pub case: String,
    /// Quantity that is measured.
    pub quantity: &'static str,
    /// Its unit; empty for a number without one.
    pub unit: &'static str,
    /// The published value.
    pub paper: f64,
    /// The value computed here; `None` where what is published does not suffice to compute it.
    pub ours: Option<f64>,
    /// Largest `|ours - paper|` that counts as agreement.
    pub tolerance: f64,
    /// Agreement of the two when this row was written.
    pub expected: Agreement,
    /// Why there is no value, or why it differs; empty if there is nothing to say.
    pub remark: &'static str,
}

/// Relation of a published value to ours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Agreement {
    /// They agree to the tolerance.
    Agrees,
    /// They do not.
    Differs,
    /// There is nothing to compare.
    NotComputed,
}

/// A number as printed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Printed {
    pub(crate) value: f64,
    /// One unit of the last digit printed: papers round, and some cut.
    pub(crate) last_digit: f64,
}

impl Printed {
    /// Reads a plain decimal; NaN, which agrees with nothing, if it is none.
    pub(crate) fn new(text: &str) -> Self {
        let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        Self { value: text.parse().unwrap_or(f64::NAN), last_digit: 0.1_f64.powi(decimals.try_into().unwrap_or(0)) }
    }
}

impl Published {
    /// `(ours - paper) / paper`.
    #[must_use]
    pub fn difference(&self) -> Option<f64> {
        self.ours.map(|ours| (ours - self.paper) / self.paper)
    }

    /// Agreement of the two now. NaN differs.
    #[must_use]
    pub fn agreement(&self) -> Agreement {
        match self.ours {
            None => Agreement::NotComputed,
            // Rounding of the last digit's decimal fraction.
            Some(ours) if (ours - self.paper).abs() <= self.tolerance * (1.0 + 1e-9) => Agreement::Agrees,
            Some(_) => Agreement::Differs,
        }
    }

    /// True if the two agreed when this row was written and do not agree now.
    #[must_use]
    pub fn is_lost(&self) -> bool {
        self.expected == Agreement::Agrees && self.agreement() != Agreement::Agrees
    }
}
