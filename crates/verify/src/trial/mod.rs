//! Trials: what they are, how they are drawn, run and judged.

pub(crate) mod disturbances;
pub(crate) mod draw;
pub(crate) mod path;
pub(crate) mod smallest;
pub(crate) mod speed;

use crate::statement::{Guarantee, Statement};
use disturbances::TrialDisturbances;
use serde::{Deserialize, Serialize};

/// One guarantee held against one trial.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Check {
    /// Name of the guarantee.
    pub guarantee: String,
    /// Measured value. The largest number there is stands for NaN, and for the arrival of a robot that never arrived.
    #[serde(with = "crate::number")]
    pub measured: f64,
    /// The bound that it came nearest to, or exceeded.
    #[serde(with = "crate::number")]
    pub bound: f64,
    /// Distance from the bound as a share of its size, or itself where the bound is zero; negative where it is exceeded, NaN counts as
    /// exceeded.
    #[serde(with = "crate::number")]
    pub margin: f64,
    /// Unit of both.
    pub unit: String,
}

impl Check {
    /// True if the guarantee was kept.
    #[must_use]
    pub fn kept(&self) -> bool {
        self.margin >= 0.0
    }

    /// A value that must not exceed a bound.
    pub(crate) fn at_most(guarantee: &str, measured: f64, bound: f64, unit: &str) -> Self {
        Self::new(guarantee, measured, bound, bound - measured, unit)
    }

    /// A value that must reach a bound.
    pub(crate) fn at_least(guarantee: &str, measured: f64, bound: f64, unit: &str) -> Self {
        Self::new(guarantee, measured, bound, measured - bound, unit)
    }

    /// A value held against a guarantee; the nearer bound counts. `None` for a guarantee without bounds: an infinite one is none.
    pub(crate) fn of(guarantee: &Guarantee, measured: f64) -> Option<Self> {
        let finite = |bound: &f64| bound.is_finite();
        let upper = guarantee
            .upper
            .filter(finite)
            .map(|bound| Self::at_most(&guarantee.name, measured, bound, &guarantee.unit));
        let lower = guarantee
            .lower
            .filter(finite)
            .map(|bound| Self::at_least(&guarantee.name, measured, bound, &guarantee.unit));
        match (lower, upper) {
            (Some(lower), Some(upper)) => Some(if lower.margin < upper.margin { lower } else { upper }),
            (lower, upper) => lower.or(upper),
        }
    }

    /// JSON has neither NaN nor infinity: the largest numbers stand for them, on the side that fails.
    fn new(guarantee: &str, measured: f64, bound: f64, distance: f64, unit: &str) -> Self {
        let margin = if bound == 0.0 { distance } else { distance / bound.abs() };
        let number = |value: f64| if value.is_nan() { f64::MAX } else { value.clamp(-f64::MAX, f64::MAX) };
        let margin = if margin.is_nan() { -f64::MAX } else { number(margin) };
        Self {
            guarantee: guarantee.into(),
            measured: number(measured),
            bound: number(bound),
            margin,
            unit: unit.into(),
        }
    }
}

/// Outcome of one trial.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trial {
    /// Number in the campaign, from 0.
    pub number: u64,
    /// Size of the disturbances, 0 none to 1 the whole range asked for: what a smallest case is smallest in.
    #[serde(with = "crate::number")]
    pub size: f64,
    /// The disturbances, as the `[disturbances]` table of a scenario.
    pub disturbances: TrialDisturbances,
    /// Names of the hypotheses that this trial did not keep; guarantees that rest on them were not checked. Beside those of the
    /// statement: what every statement takes for granted of the loop, see [`crate::Campaign::trial`].
    pub outside: Vec<String>,
    /// The guarantees checked.
    pub checks: Vec<Check>,
}

impl Trial {
    /// True if every guarantee checked was kept.
    #[must_use]
    pub fn kept(&self) -> bool {
        self.checks.iter().all(Check::kept)
    }

    /// Names of the guarantees that were not kept.
    #[must_use]
    pub fn violated(&self) -> Vec<&str> {
        self.checks.iter().filter(|check| !check.kept()).map(|check| check.guarantee.as_str()).collect()
    }
}

/// Judgement of a run beside a statement.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Judgement {
    pub(crate) outside: Vec<String>,
    pub(crate) checks: Vec<Check>,
}

/// A guarantee that holds whatever disturbs the loop, so that every trial is held against it.
pub(crate) struct Always {
    pub(crate) name: &'static str,
    pub(crate) text: &'static str,
    pub(crate) unit: &'static str,
}

impl Always {
    /// As it stands in a statement. Its bound is in the text: in a run it is judged sample by sample, or by the run's own signals. Only
    /// where the run without a trial's disturbances breaks it does the bound stand beside what was measured.
    pub(crate) fn guarantee(&self, nominal: &Check) -> Guarantee {
        let broken = (!nominal.kept()).then_some(nominal.bound);
        Guarantee {
            name: self.name.into(),
            claim: self.name.into(),
            text: self.text.into(),
            lower: broken.filter(|bound| nominal.measured < *bound),
            upper: broken.filter(|bound| !(nominal.measured < *bound)),
            unit: self.unit.into(),
            rests_on: Vec::new(),
            measured: Some(nominal.measured),
        }
    }
}

/// Checks the guarantees of a statement against what a run measured, but for those that rest on something the run did not keep, and
/// those that `leave` names a reason for.
pub(crate) fn held_against(
    statement: &Statement,
    outside: &mut Vec<String>,
    measured: impl Fn(&Guarantee) -> Option<f64>,
    leave: impl Fn(&Guarantee) -> Option<&'static str>,
) -> Vec<Check> {
    let mut checks = Vec::new();
    for guarantee in &statement.guarantees {
        if guarantee.rests_on.iter().any(|name| outside.contains(name)) {
            continue;
        }
        let Some(value) = measured(guarantee) else { continue };
        match leave(guarantee) {
            Some(reason) if outside.iter().any(|name| name == reason) => {}
            Some(reason) => outside.push(reason.to_owned()),
            None => checks.extend(Check::of(guarantee, value)),
        }
    }
    checks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_be_measured_fails_and_still_fits_into_json() {
        for value in [f64::NAN, f64::INFINITY] {
            let check = Check::at_most("g", value, 1.0, "1");
            assert!(!check.kept());
            let text = serde_json::to_string(&check).expect("writes");
            assert_eq!(serde_json::from_str::<Check>(&text).expect("reads"), check);
        }
    }
}
