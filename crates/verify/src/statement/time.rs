use super::path_drift::PathDrift;

/// What the bracket of the travel time is computed from (claim `time-with-feedback`). Times in s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TimeInputs {
    /// Least and largest value of the optimum `T*`.
    pub(crate) optimum: [f64; 2],
    /// Sampling period.
    pub(crate) period: f64,
    /// `μ`: 1 where the reference waits for the robot, the band `M` in the published advance.
    pub(crate) advance: f64,
    /// `sup E`.
    pub(crate) feedback: f64,
    /// `∫ E dt`.
    pub(crate) feedback_s: f64,
    /// `∫ (1 + E) |1 - b_path / b| dt`.
    pub(crate) shift_s: f64,
    /// Time held back.
    pub(crate) hold_back_s: f64,
}

/// Least and largest time of the reference from the start of its motion to its end, s; `None` where the path has no finite drift.
///
/// ```text
/// (T* - Ts W - F - μ P) / μ  <=  T  <=  T* + Ts W + H + μ P + Ts,    W = μ (1 + E) V (e^d - 1) / d
/// ```
pub(crate) fn bracket(drift: &PathDrift, inputs: &TimeInputs) -> Option<[f64; 2]> {
    let TimeInputs { optimum, period, advance, feedback, feedback_s, shift_s, hold_back_s } = *inputs;
    let pace = advance * (1.0 + feedback);
    let largest = drift.sample_drift(pace, period);
    let growth = if largest > 0.0 { largest.exp_m1() / largest } else { 1.0 };
    let between = period * pace * drift.variation() * growth;
    let lower = (optimum[0] - between - feedback_s - advance * shift_s) / advance;
    let upper = optimum[1] + between + hold_back_s + advance * shift_s + period;
    (!drift.breaks() && lower.is_finite() && upper.is_finite()).then_some([lower.max(0.0), upper])
}
