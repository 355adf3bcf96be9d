use libm::{expm1, fabs};

use super::signal::{larger, narrow};
use crate::implicit::AffineSpeed;
use crate::limits::SpeedLimits;

/// Which law a [`Progress`] is of: what a sample keeps of the feedforward depends on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProgressForm {
    /// The explicit forms, either advance.
    Explicit,
    /// The implicit form.
    Implicit,
}

/// Sums over the samples of a motion on which its travel time depends (claim `time-with-feedback`). In samples: times `Ts` they are s.
///
/// `E`, `b`, `z` and `m` as in [`super::Signals`], each at its own sample; `b_path = λ̇d / λ̇*` on the path itself.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ProgressSums {
    /// `Σ E`: how much faster than the limits the feedback can let the reference go.
    pub feedback: f64,
    /// `Σ (m - 1)⁺`: by how much the demand left the limits, which the published advance turns into progress.
    pub overrun: f64,
    /// `Σ (1 + E + (m - 1)⁺) |1 - b_path / b|`: how far the feedforward as it was seen is from the path's.
    pub shift: f64,
    /// `Σ max(y, E)⁺` with `z >= 1 - y`: how far below the limits filter, feedback and drift can hold the reference.
    pub held_back: f64,
    /// `R = max (1 + E + (m - 1)⁺) b_path / b`, no sum: the path rate is at most `R λ̇*`.
    pub pace: f64,
}

/// Collects [`ProgressSums`] from the first sample in which the reference moves to its end.
///
/// ```text
/// y' = max(1 - (1 - a)(1 - y)⁺ b'/b - a b',  1 - (1 - a)(1 - E) b'/b)      explicit
/// y' = max(1 - (1 - a)(1 - y)⁺ b'/b - a b',  E')                           implicit
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    form: ProgressForm,
    filter_step: f64,
    sums: ProgressSums,
    last: Option<Before>,
}

/// The sample before.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Before {
    below: f64,
    feedback: f64,
    length: f64,
}

impl Progress {
    /// For a regulator with the filter step `a = af Ts`.
    #[must_use]
    pub fn new(form: ProgressForm, filter_step: f64) -> Self {
        Self { form, filter_step, sums: ProgressSums::default(), last: None }
    }

    /// Takes a sample in: the limits, the demand as it was seen, the factor it was computed with, and `b_path` where the reference is.
    pub fn update<const N: usize>(
        &mut self,
        limits: &SpeedLimits<N>,
        demand: &AffineSpeed<N>,
        factor: f64,
        on_path: f64,
    ) {
        let (length, feedback) = (limits.ratio(&demand.feedforward), narrow(limits, &demand.feedback));
        let over = (limits.ratio(&demand.at(factor)) - 1.0).max(0.0);
        let below = match self.last {
            None => 1.0 - factor * length,
            Some(before) => self.below(&before, length, feedback),
        };
        let shift = if length == on_path { 0.0 } else { fabs(1.0 - on_path / length) };
        self.sums.feedback += feedback;
        self.sums.overrun += over;
        self.sums.shift += (1.0 + feedback + over) * shift;
        let ahead = if length == on_path { 1.0 } else { on_path / length };
        self.sums.pace = larger(self.sums.pace, (1.0 + feedback + over) * ahead);
        self.sums.held_back += larger(larger(below, feedback), 0.0);
        self.last = Some(Before { below, feedback, length });
    }

    /// The sums over the samples so far.
    #[must_use]
    pub fn sums(&self) -> ProgressSums {
        self.sums
    }

    fn below(&self, before: &Before, length: f64, feedback: f64) -> f64 {
        let rest = 1.0 - self.filter_step;
        let kept = if before.length == length { 1.0 } else { length / before.length };
        let risen = 1.0 - rest * (1.0 - before.below).max(0.0) * kept - self.filter_step * length;
        match self.form {
            ProgressForm::Explicit => larger(risen, 1.0 - rest * (1.0 - before.feedback) * kept),
            ProgressForm::Implicit => larger(risen, feedback),
        }
    }
}

/// Inputs to the bracket of the travel time: the sums and the numbers that go with them. Times in s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TravelInputs {
    /// The sums, in samples.
    pub sums: ProgressSums,
    /// Least and largest value of the optimum `T*` of the path under its speed limits.
    pub optimum: [f64; 2],
    /// Sampling period `Ts`.
    pub period: f64,
    /// Total variation of `ln λ̇*` along the path.
    pub variation: f64,
    /// `d`: largest change of `ln λ̇*` while the reference moves for one sampling period at `R λ̇*`.
    pub sample_drift: f64,
}

/// Least and largest time from the start of the reference's motion to its end (claim `time-with-feedback`), or `None` for numbers that
/// are not finite.
///
/// ```text
/// T* - Ts (W + ΣE + Σ(m - 1)⁺ + P)  <=  T  <=  T* + Ts (W + H + P + 1),     W = R V (e^d - 1) / d
/// ```
///
/// with `P` the shift, `H` what was held back, `R` the pace and `V` the variation. Hypotheses: `q̇d = A + f B` at every sample but the last, which may be cut short;
/// `b_path` known where the reference is. With the synchronised advance or the implicit form `Σ(m - 1)⁺` is not needed.
#[must_use]
pub fn travel_bracket(inputs: &TravelInputs) -> Option<[f64; 2]> {
    let TravelInputs { sums, optimum: [least, most], period, variation, sample_drift } = *inputs;
    // NaN goes to the quotient, which keeps it.
    let growth = if sample_drift <= 0.0 { 1.0 } else { expm1(sample_drift) / sample_drift };
    let between = sums.pace * variation * growth + sums.shift;
    let lower = least - period * (between + sums.feedback + sums.overrun);
    let upper = most + period * (between + sums.held_back + 1.0);
    (lower.is_finite() && upper.is_finite()).then_some([lower.max(0.0), upper])
}
