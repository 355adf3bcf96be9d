use std::ops::Range;

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::{Choices, Engine, Stop};
use crate::subject::Subject;

/// Findings of a campaign of random cases.
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

/// Cases between two reports of progress; the cores meet so often.
const PART: u64 = 4_096;

/// Tries `cases` cases that meet the hypotheses, on all cores; the report does not depend on their number.
///
/// Gives up, with fewer tried, once a hundred times as many cases have been skipped. `progress` is called at times with the number tried.
#[must_use]
pub fn campaign(engine: &Engine, subject: Subject, seed: u64, cases: u64, mut progress: impl FnMut(u64)) -> Report {
    let mut report = Report::EMPTY;
    let mut next = 0;
    while report.tried < cases && next < cases.saturating_mul(100) {
        // The cases tried are the first that are enough, in parts of any size: none is begun that may not be needed.
        let range = next..next + (cases - report.tried).min(PART);
        next = range.end;
        report = report.and(part(engine, subject, seed, range));
        progress(report.tried);
    }
    report
}

fn part(engine: &Engine, subject: Subject, seed: u64, range: Range<u64>) -> Report {
    range
        .into_par_iter()
        .fold(|| Report::EMPTY, |report, case| report.and(Report::of(engine, subject, seed, case)))
        .reduce(|| Report::EMPTY, Report::and)
}

#[cfg(test)]
mod tests {
    use std::error::Error;

    use rayon::ThreadPoolBuilder;

    use super::{PART, Report, campaign};
    use crate::CLAIMS;
    use crate::subject::{Fault, Subject};

    /// Campaigns of some claims that skip cases and some that do not.
    fn reports(subject: Subject) -> Vec<Report> {
        let claims = CLAIMS.iter().filter(|claim| ["frozen-band", "farkas", "switching"].contains(&claim.name));
        // One part and some more.
        let cases = PART + 500;
        claims.flat_map(|claim| claim.engines).map(|engine| campaign(engine, subject, 1, cases, |_| ())).collect()
    }

    #[test]
    fn the_report_is_the_same_for_any_number_of_threads() -> Result<(), Box<dyn Error>> {
        let on = |threads| ThreadPoolBuilder::new().num_threads(threads).build();
        for subject in [Subject::Shipped, Subject::Broken(Fault::SwitchDelayed)] {
            let alone = on(1)?.install(|| reports(subject));
            assert!(alone.iter().all(|report| report.tried == PART + 500) && alone.iter().any(|r| r.skipped > 0));
            assert_eq!(alone.iter().any(|report| report.violation.is_some()), subject != Subject::Shipped);
            for threads in [2, 7] {
                assert_eq!(on(threads)?.install(|| reports(subject)), alone);
            }
        }
        Ok(())
    }

    #[test]
    fn progress_is_told_up_to_the_last_case() {
        let mut told = Vec::new();
        for engine in CLAIMS.iter().take(1).flat_map(|claim| claim.engines.iter().take(1)) {
            let report = campaign(engine, Subject::Shipped, 1, 2 * PART + 1, |tried| told.push(tried));
            assert_eq!(told.last(), Some(&report.tried));
        }
        assert!(told.is_sorted() && told.len() >= 3);
    }
}
