//! Hypotheses, bounds and failures in words, the same on the terminal, in JUnit and on the page.

use crate::say::words::{apart_in, short};
use crate::verify::results::GuaranteeResult;
use slideway_verify::{Guarantee, Hypothesis, Relation};

/// The value of a hypothesis and what it needs.
pub(crate) fn needed(hypothesis: &Hypothesis) -> String {
    let [value, needed] = apart_in([hypothesis.value, hypothesis.needed], &hypothesis.unit);
    format!("{value}; {} {needed} is needed", relation(hypothesis))
}

/// The need of a hypothesis.
pub(crate) fn least(hypothesis: &Hypothesis) -> String {
    let [_, needed] = apart_in([hypothesis.value, hypothesis.needed], &hypothesis.unit);
    format!("{} {needed}", relation(hypothesis))
}

fn relation(hypothesis: &Hypothesis) -> &'static str {
    match hypothesis.relation {
        Relation::AtLeast => "at least",
        Relation::AtMost => "at most",
    }
}

/// A share in per cent.
pub(crate) fn percent(share: f64) -> String {
    format!("{} %", short(100.0 * share))
}

pub(crate) fn with_unit(value: f64, unit: &str) -> String {
    let [text] = apart_in([value], unit);
    text
}

/// Bounds and value of a guarantee side by side: what is missing takes the place of another and is not shown.
fn numbers(guarantee: &Guarantee) -> [Option<String>; 3] {
    let given = [guarantee.lower, guarantee.upper, guarantee.measured];
    let any = given.iter().flatten().next().copied().unwrap_or(0.0);
    let [lower, upper, measured] = apart_in(given.map(|value| value.unwrap_or(any)), &guarantee.unit);
    let shown = [lower, upper, measured];
    std::array::from_fn(|i| given[i].map(|_| shown[i].clone()))
}

/// The bound of a guarantee that has none for all trials.
const EACH: &str = "each run's own";

/// The bound of a guarantee.
pub(crate) fn bound(result: &GuaranteeResult) -> String {
    result.stated.as_ref().map_or_else(|| EACH.to_owned(), stated_bound)
}

/// The bound of a guarantee that is stated before the trials.
pub(crate) fn stated_bound(guarantee: &Guarantee) -> String {
    let [lower, upper, _] = numbers(guarantee);
    match (lower, upper) {
        (Some(lower), Some(upper)) => format!("{lower} to {upper}"),
        (Some(lower), None) => format!("at least {lower}"),
        (None, Some(upper)) => format!("at most {upper}"),
        (None, None) => EACH.to_owned(),
    }
}

/// What a guarantee's value is in the scenario as it is.
pub(crate) fn as_it_is(guarantee: Option<&Guarantee>) -> String {
    let measured = guarantee.and_then(|g| {
        let [_, _, measured] = numbers(g);
        measured
    });
    measured.unwrap_or_else(|| "-".to_owned())
}

/// The trial with the smallest margin.
pub(crate) fn nearest(result: &GuaranteeResult) -> String {
    result.nearest.as_ref().map_or_else(|| "-".to_owned(), |n| format!("{} (trial {})", percent(n.margin), n.trial))
}

/// A guarantee that was kept, in one line.
pub(crate) fn kept(result: &GuaranteeResult) -> String {
    format!(
        "bound: {}; in the scenario as it is: {}; trials checked: {}; smallest margin: {}",
        bound(result),
        as_it_is(result.stated.as_ref()),
        result.trials_checked,
        nearest(result)
    )
}

/// A guarantee that was not kept: where, by how much, and which file shows it again.
pub(crate) fn failing(result: &GuaranteeResult, seed: u64) -> Vec<String> {
    let mut lines = Vec::new();
    let text = result.stated.as_ref().map_or(String::new(), |g| format!(" ({})", g.text));
    if result.kept_without_disturbances == Some(false) {
        lines.push(format!(
            "{}{text} is violated in the scenario as it is: {}, bound: {}",
            result.name,
            as_it_is(result.stated.as_ref()),
            bound(result)
        ));
    }
    if let Some(f) = &result.failing {
        let [measured, bound] = apart_in([f.first.measured, f.first.bound], &result.unit);
        lines.push(format!(
            "{}{text} is violated in {} of {} trials checked, first in trial {} of seed {seed}: {}, bound {}, margin {}",
            result.name,
            result.violations,
            result.trials_checked,
            f.first.trial,
            measured,
            bound,
            percent(f.first.margin)
        ));
        lines.push(format!(
            "smallest case: disturbances of size {} (the trial's: {}), in {}",
            short(f.smallest.size),
            short(f.first.size),
            f.file
        ));
    }
    lines
}
