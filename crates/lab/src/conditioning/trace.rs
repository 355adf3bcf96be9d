use crate::csv;
use crate::run::trace::push_number;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::fmt::Write as _;
use std::io;

/// Most constraints a scenario may have.
pub const MAX_CONSTRAINTS: usize = 8;

/// The methods that are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PathMethod {
    /// Sliding mode on exact zero-order-hold filters.
    SlidingMode,
    /// The scheme of the paper's appendix.
    SlidingModePaper,
    /// Backward-Euler sliding mode.
    SlidingModeImplicit,
    /// Quadratic-programming safety filter.
    QpFilter,
    /// Exact projection of every reference point onto the allowed set.
    Projection,
    /// Potential field.
    PotentialField,
}

impl PathMethod {
    /// All methods, in the order of the tables.
    pub const ALL: [Self; 6] = [
        Self::SlidingMode,
        Self::SlidingModePaper,
        Self::SlidingModeImplicit,
        Self::QpFilter,
        Self::Projection,
        Self::PotentialField,
    ];

    /// The name used in files, tables and on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::SlidingMode => "sliding-mode",
            Self::SlidingModePaper => "sliding-mode-paper",
            Self::SlidingModeImplicit => "sliding-mode-implicit",
            Self::QpFilter => "qp-filter",
            Self::Projection => "projection",
            Self::PotentialField => "potential-field",
        }
    }

    /// The form that a verdict is about where nothing else is chosen.
    pub const JUDGED: Self = Self::SlidingMode;

    /// True if it is one of the conditioner's forms.
    #[must_use]
    pub fn is_conditioner(self) -> bool {
        matches!(self, Self::SlidingMode | Self::SlidingModePaper | Self::SlidingModeImplicit)
    }
}

impl fmt::Display for PathMethod {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// Action of a method on the reference at one sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// No constraint acted.
    Free,
    /// A constraint acted.
    Acting,
    /// The reserve acted.
    Reserve,
    /// The reference was held.
    Held,
    /// The reference waits while the walk searches or returns.
    Trapped,
}

impl Phase {
    /// The name used in traces.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Free => "free",
            Self::Acting => "acting",
            Self::Reserve => "reserve",
            Self::Held => "held",
            Self::Trapped => "trapped",
        }
    }
}

/// One run of one method.
#[derive(Clone, Debug, PartialEq)]
pub struct ConditionedTrace {
    /// The method.
    pub method: PathMethod,
    /// Names of the constraints.
    pub constraints: Vec<String>,
    /// Sampling period, s.
    pub sampling_period: f64,
    /// When the reference reached its end, s: at the last sample, or less than a sampling period after it.
    pub finish_s: Option<f64>,
    /// The samples.
    pub samples: Vec<ConditionedSample>,
}

/// One sample. Entries of the constraint arrays beyond the scenario's constraints are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConditionedSample {
    /// Time, s.
    pub t: f64,
    /// Path parameter of the reference.
    pub lambda: f64,
    /// Reference, m.
    pub reference: [f64; 3],
    /// Conditioned reference, m.
    pub position: [f64; 3],
    /// `σ_i` at the conditioned reference.
    pub sigma: [f64; MAX_CONSTRAINTS],
    /// `φ_i` at the conditioned reference; NaN for methods without a velocity.
    pub phi: [f64; MAX_CONSTRAINTS],
    /// `φ_i` as the method saw it: the same unless measurements are disturbed.
    pub seen_phi: [f64; MAX_CONSTRAINTS],
    /// Share of each constraint in the push.
    pub share: [f64; MAX_CONSTRAINTS],
    /// Length of `∇σ_i` at the conditioned reference.
    pub gradient: [f64; MAX_CONSTRAINTS],
    /// Push `u_1`, m.
    pub push: [f64; 3],
    /// Push that the reserve added in the interval that ends here, m.
    pub reserve: [f64; 3],
    /// Walk `f_RW`, m.
    pub walk: [f64; 3],
    /// Action of the method.
    pub phase: Phase,
}

impl ConditionedSample {
    /// Distance of the conditioned reference from the reference, m.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        self.position.iter().zip(&self.reference).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
    }
}

impl ConditionedTrace {
    /// Writes the trace as CSV, one row per sample, units in the column names, nothing where there is no number.
    ///
    /// # Errors
    ///
    /// Any error of the writer.
    pub fn write_csv(&self, mut out: impl io::Write) -> io::Result<()> {
        let mut columns: Vec<String> = ["t_s", "lambda"].map(str::to_owned).to_vec();
        for name in ["reference", "position", "push", "walk"] {
            columns.extend(["x", "y", "z"].map(|axis| format!("{name}_{axis}_m")));
        }
        for name in &self.constraints {
            columns.extend([format!("sigma_{name}_m"), format!("phi_{name}_m"), format!("share_{name}")]);
        }
        columns.push("phase".into());
        writeln!(out, "{}", csv::header(&columns))?;
        let mut line = String::new();
        for s in &self.samples {
            line.clear();
            let _ = write!(line, "{:.10},{}", s.t, s.lambda);
            for value in s.reference.iter().chain(&s.position).chain(&s.push).chain(&s.walk) {
                push_number(&mut line, *value);
            }
            for i in 0..self.constraints.len() {
                [s.sigma[i], s.phi[i], s.share[i]].into_iter().for_each(|value| push_number(&mut line, value));
            }
            writeln!(out, "{line},{}", s.phase.name())?;
        }
        Ok(())
    }
}
