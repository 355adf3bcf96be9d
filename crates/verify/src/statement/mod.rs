//! Statements: hypotheses and guarantees of a scenario before any trial, and readings of a run to hold against them.

mod conditioning;
mod contact;
mod entry;
mod observed;
mod path_drift;
mod recovery;
mod signals;
mod speed;
mod speed_declared;
mod speed_guarantees;
mod speed_hypotheses;
mod speed_loop;
mod speed_observed;
mod speed_words;

pub(crate) use conditioning::ConditioningCase;
pub(crate) use entry::{room, shown_down, shown_up};
pub use observed::{Observed, Observer, Reading};
pub(crate) use recovery::{PUSH_ROUNDING, excess, recovery_rate};
pub(crate) use speed::SpeedCase;

use serde::{Deserialize, Serialize};

/// Relation of a value to the one that is needed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Relation {
    /// The value must be at least the one that is needed.
    AtLeast,
    /// The value must be at most the one that is needed.
    AtMost,
}

/// A condition that a claim sets on the scenario.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Hypothesis {
    /// Name, kebab case, unique in the statement.
    pub name: String,
    /// The claim that asks for it.
    pub claim: String,
    /// In plain words and symbols.
    pub text: String,
    /// Value that the scenario has.
    #[serde(with = "crate::number")]
    pub value: f64,
    /// Relation that it must have to `needed`.
    pub relation: Relation,
    /// Value that is needed.
    #[serde(with = "crate::number")]
    pub needed: f64,
    /// Unit of both.
    pub unit: String,
    /// Key of the scenario to change, and the number to change it to, where the hypothesis fails.
    pub remedy: Option<String>,
}

impl Hypothesis {
    /// True if it holds; NaN does not.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.holds_for(self.value)
    }

    /// True if it would hold with another value; NaN does not.
    #[must_use]
    pub fn holds_for(&self, value: f64) -> bool {
        match self.relation {
            Relation::AtLeast => value >= self.needed,
            Relation::AtMost => value <= self.needed,
        }
    }

    /// Distance from `needed` as a share of it, negative where it fails; the plain distance where `needed` is 0.
    #[must_use]
    pub fn margin(&self) -> f64 {
        let distance = match self.relation {
            Relation::AtLeast => self.value - self.needed,
            Relation::AtMost => self.needed - self.value,
        };
        if self.needed == 0.0 { distance } else { distance / self.needed.abs() }
    }
}

/// A bound that follows from hypotheses that hold.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Guarantee {
    /// Name, kebab case, unique in the statement.
    pub name: String,
    /// The claim behind it.
    pub claim: String,
    /// In plain words and symbols.
    pub text: String,
    /// Least value, if it is bounded from below.
    #[serde(with = "crate::number::option")]
    pub lower: Option<f64>,
    /// Greatest value, if it is bounded from above.
    #[serde(with = "crate::number::option")]
    pub upper: Option<f64>,
    /// Unit.
    pub unit: String,
    /// Names of the hypotheses it rests on, all of which hold.
    pub rests_on: Vec<String>,
    /// The value in the scenario as it is, without disturbances; `None` where it has none.
    #[serde(with = "crate::number::option")]
    pub measured: Option<f64>,
}

impl Guarantee {
    /// True if a value is inside the bounds; NaN is not.
    #[must_use]
    pub fn contains(&self, value: f64) -> bool {
        self.lower.is_none_or(|lower| value >= lower) && self.upper.is_none_or(|upper| value <= upper)
    }
}

/// Hypotheses and guarantees of a scenario, made before any trial.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Statement {
    /// The method it is about.
    pub method: String,
    /// Conditions of the claims, with the values that the scenario has.
    pub hypotheses: Vec<Hypothesis>,
    /// Bounds that follow. A guarantee whose hypotheses fail is not in the list.
    pub guarantees: Vec<Guarantee>,
    /// Remarks in words: quantities without a guarantee, and the sources of the numbers.
    #[serde(default)]
    pub remarks: Vec<String>,
}

impl Statement {
    /// True if every hypothesis holds.
    #[must_use]
    pub fn accepts(&self) -> bool {
        self.hypotheses.iter().all(Hypothesis::holds)
    }

    /// True if every hypothesis holds and nothing measured is outside its guarantee.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.accepts() && self.violated().next().is_none()
    }

    /// The guarantees whose measured value is outside.
    pub fn violated(&self) -> impl Iterator<Item = &Guarantee> {
        self.guarantees.iter().filter(|g| g.measured.is_some_and(|value| !g.contains(value)))
    }

    /// Names of the hypotheses that a run did not keep.
    #[must_use]
    pub fn outside(&self, run: &Observed) -> Vec<String> {
        let broken = |h: &&Hypothesis| run.hypothesis(&h.name).is_some_and(|value| !h.holds_for(value));
        self.hypotheses.iter().filter(broken).map(|h| h.name.clone()).collect()
    }

    /// Leaves out the guarantees that rest on a hypothesis that fails.
    fn keep_what_holds(mut self) -> Self {
        let failed: Vec<String> = self.hypotheses.iter().filter(|h| !h.holds()).map(|h| h.name.clone()).collect();
        let finite = |g: &Guarantee| g.upper.is_none_or(f64::is_finite);
        self.guarantees.retain(|g| finite(g) && g.rests_on.iter().all(|name| !failed.contains(name)));
        // What is needed of a signal without bound says nothing.
        self.hypotheses.retain(|h| h.needed.is_finite() || !h.holds());
        self
    }
}
