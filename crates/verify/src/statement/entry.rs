//! Entries of a statement: their making, and the rounding of their numbers.

use super::{Guarantee, Hypothesis, Relation};

/// Room that every number read off the run without disturbances is given, as a share. The bounds are stated for the numbers with room.
pub(crate) const ROOM: f64 = 0.25;

/// A number with room.
pub(crate) fn room(value: f64) -> f64 {
    (1.0 + ROOM) * value
}

pub(crate) fn at_most(name: &str, claim: &str, text: &str, unit: &str) -> Hypothesis {
    Hypothesis {
        name: name.into(),
        claim: claim.into(),
        text: text.into(),
        value: f64::NAN,
        relation: Relation::AtMost,
        needed: f64::NAN,
        unit: unit.into(),
        remedy: None,
    }
}

pub(crate) fn up_to(name: &str, claim: &str, text: &str, unit: &str, bound: f64, rests_on: &[&str]) -> Guarantee {
    Guarantee {
        name: name.into(),
        claim: claim.into(),
        text: text.into(),
        lower: None,
        upper: Some(bound),
        unit: unit.into(),
        rests_on: rests_on.iter().map(|&name| name.to_owned()).collect(),
        measured: None,
    }
}

pub(crate) fn failing(hypothesis: &Hypothesis, remedy: impl FnOnce() -> String) -> Option<String> {
    (!hypothesis.holds()).then(remedy)
}

/// Three digits, rounded up.
pub(crate) fn shown_up(value: f64) -> f64 {
    let unit = 10f64.powf(value.log10().floor() - 2.0);
    format!("{:.12e}", (value / unit).ceil() * unit).parse().unwrap_or(value)
}

/// Three digits, rounded down.
pub(crate) fn shown_down(value: f64) -> f64 {
    let unit = 10f64.powf(value.log10().floor() - 2.0);
    format!("{:.12e}", (value / unit).floor() * unit).parse().unwrap_or(value)
}
