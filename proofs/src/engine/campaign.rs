use std::ops::Range;

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::{Choices, Engine, Stop};
use crate::subject::Subject;

/// What a campaign of random cases found.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// Cases that met the hypotheses.
    pub tried: u64,
    /// Cases that did not.
    pub skipped: u64,
    /// The smallest margin; infinite if nothing was measured.
    pub smallest: f64,
    /// The case with the smallest margin.
    pub closest: u64,
    /// The first case, by number, that violates the claim.
    pub violation: Option<Violation>,
}

/// A case that violates a claim: [`Choices::random`] of seed and case, or [`Choices::replay`] of the choices, gives it again.
#[derive(Clone, Debug, PartialEq)]
pub struct Violation {
    /// Its number.
    pub case: u64,
    /// The choices it is built from.
    pub choices: Vec<f64>,
    /// By how much, or what was refused.
    pub what: String,
}

impl Report {
    const EMPTY: Self = Self { tried: 0, skipped: 0, smallest: f64::INFINITY, closest: 0, violation: None };

    fn of(engine: &Engine, subject: Subject, seed: u64, case: u64) -> Self {
        let mut choices = Choices::random(seed, case);
        let violated =
            |choices: &Choices, what: String| Some(Violation { case, choices: choices.used().to_vec(), what });
        match (engine.trial)(&mut choices, subject) {
            Err(Stop::Skipped) => Self { skipped: 1, ..Self::EMPTY },
            Err(Stop::Refused(why)) => Self { tried: 1, violation: violated(&choices, why), ..Self::EMPTY },
            Ok(margin) if margin >= 0.0 => Self { tried: 1, smallest: margin, closest: case, ..Self::EMPTY },
            Ok(margin) => {
                let what = format!("margin {margin:e} ({})", engine.unit);
                let smallest = if margin.is_nan() { f64::NEG_INFINITY } else { margin };
                Self { tried: 1, smallest, closest: case, violation: violated(&choices, what), ..Self::EMPTY }
            }
        }
    }

    /// Both together; the same in whatever order parts are put together.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        let (first, second) = if self.closest <= other.closest { (&self, &other) } else { (&other, &self) };
        let closest = if second.smallest < first.smallest { second } else { first };
        let (smallest, closest) = (closest.smallest, closest.closest);
        let violation = match (self.violation, other.violation) {
            (Some(one), Some(two)) => Some(if one.case <= two.case { one } else { two }),
            (one, two) => one.or(two),
        };
        Self { tried: self.tried + other.tried, skipped: self.skipped + other.skipped, smallest, closest, violation }
    }
}

/// Tries `cases` cases that meet the hypotheses, on all cores; the report does not depend on their number.
///
/// Gives up, with fewer tried, once a hundred times as many cases have been skipped.
#[must_use]
pub fn campaign(engine: &Engine, subject: Subject, seed: u64, cases: u64) -> Report {
    let mut report = Report::EMPTY;
    let mut next = 0;
    while report.tried < cases && next < cases.saturating_mul(100) {
        let range = next..next + (cases - report.tried);
        next = range.end;
        report = report.and(part(engine, subject, seed, range));
    }
    report
}

fn part(engine: &Engine, subject: Subject, seed: u64, range: Range<u64>) -> Report {
    range
        .into_par_iter()
        .fold(|| Report::EMPTY, |report, case| report.and(Report::of(engine, subject, seed, case)))
        .reduce(|| Report::EMPTY, Report::and)
}
