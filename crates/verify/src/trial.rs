use serde::{Deserialize, Serialize};

/// One guarantee held against one trial.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Check {
    /// Name of the guarantee.
    pub guarantee: String,
    /// What was measured.
    #[serde(with = "crate::number")]
    pub measured: f64,
    /// The bound that it came nearest to, or exceeded.
    #[serde(with = "crate::number")]
    pub bound: f64,
    /// Distance from the bound as a share of its size; negative where it is exceeded, NaN counts as exceeded.
    #[serde(with = "crate::number")]
    pub margin: f64,
    /// Unit of both.
    pub unit: String,
}

impl Check {
    /// Whether the guarantee was kept.
    #[must_use]
    pub fn kept(&self) -> bool {
        self.margin >= 0.0
    }
}

/// What came of one trial.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trial {
    /// Number in the campaign, from 0.
    pub number: u64,
    /// Size of the disturbances, 0 none to 1 the whole range asked for: what a smallest case is smallest in.
    #[serde(with = "crate::number")]
    pub size: f64,
    /// The disturbances, as the `[disturbances]` table of a scenario.
    pub disturbances: toml::Table,
    /// Names of the hypotheses that this trial did not keep; guarantees that rest on them were not checked.
    pub outside: Vec<String>,
    /// The guarantees checked.
    pub checks: Vec<Check>,
}

impl Trial {
    /// Whether every guarantee checked was kept.
    #[must_use]
    pub fn kept(&self) -> bool {
        self.checks.iter().all(Check::kept)
    }
}
