use serde::{Deserialize, Serialize};

/// How a value has to stand to the one that is needed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Relation {
    /// The value must be at least what is needed.
    AtLeast,
    /// The value must be at most what is needed.
    AtMost,
}

/// What a claim asks of the scenario.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Hypothesis {
    /// Name, kebab case, unique in the statement.
    pub name: String,
    /// The claim that asks for it.
    pub claim: String,
    /// In plain words and symbols.
    pub text: String,
    /// What the scenario has.
    #[serde(with = "crate::number")]
    pub value: f64,
    /// How it has to stand to `needed`.
    pub relation: Relation,
    /// What is needed.
    #[serde(with = "crate::number")]
    pub needed: f64,
    /// Unit of both.
    pub unit: String,
    /// Key of the scenario to change, and the number to change it to, where the hypothesis fails.
    pub remedy: Option<String>,
}

impl Hypothesis {
    /// Whether it holds; NaN does not.
    #[must_use]
    pub fn holds(&self) -> bool {
        match self.relation {
            Relation::AtLeast => self.value >= self.needed,
            Relation::AtMost => self.value <= self.needed,
        }
    }
}

/// What follows from hypotheses that hold.
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
    /// Whether a value is inside; NaN is not.
    #[must_use]
    pub fn contains(&self, value: f64) -> bool {
        self.lower.is_none_or(|lower| value >= lower) && self.upper.is_none_or(|upper| value <= upper)
    }
}

/// What is known of a scenario before any trial.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Statement {
    /// The method it is about.
    pub method: String,
    /// What the claims ask for, with what the scenario has.
    pub hypotheses: Vec<Hypothesis>,
    /// What follows. A guarantee whose hypotheses fail is not in the list.
    pub guarantees: Vec<Guarantee>,
}
