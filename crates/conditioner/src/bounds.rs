//! Proven bounds and the paper's estimates, as plain functions of the parameters.
//!
//! Notation: `a = af Ts` is the filter step; `g = λ̇d / λ̇*` says how much faster than the limits the target rate is
//! (`g > 1` means regulation is needed); `m = ‖F_N q̇d‖∞` is the largest use of a limit.

mod feedback;
mod progress;
mod signal;
mod time;

pub use feedback::{FeedbackBand, FeedbackLoop, drifting_band_with_feedback};
pub use progress::{Progress, ProgressForm, ProgressSums, TravelInputs, travel_bracket};
pub use signal::{SignalBand, Signals, implicit_chattering};
pub use time::{TimeBracket, time_bracket};

use libm::{exp, log1p};

/// The number if it is positive, 0 if it is not, NaN if it is NaN, which `f64::max` would turn into 0: a bound of what is not known.
pub(crate) fn positive_part(x: f64) -> f64 {
    if x <= 0.0 { 0.0 } else { x }
}

/// Largest `m` on a frozen path (claim `frozen-band`): `1 + a (g - 1)` for `g >= 1`, at most 1 otherwise.
///
/// Hypotheses: zero tracking error, `g` constant, `m <= 1` at the first sample.
#[must_use]
pub fn frozen_band(filter_step: f64, overspeed: f64) -> f64 {
    1.0 + filter_step * positive_part(overspeed - 1.0)
}

/// Largest `m` on a drifting path (claim `drifting-band`), or `None` where the reaching condition fails.
///
/// ```text
/// M = (1 - a) exp(L Ts λ̇*max) + a g_max,   valid if M >= 1, m_0 <= 1 and L Ts λ̇*max M <= -ln(1 - a)
/// ```
///
/// `drift` is `L Ts λ̇*max`: how much `ln g` can change in one sample at the largest admissible path rate, with
/// `L = sup |d ln g / dλ|`. The condition says that the filter falls faster than the limit does. NaN gives `None`.
#[must_use]
pub fn drifting_band(filter_step: f64, overspeed_max: f64, drift: f64) -> Option<f64> {
    let band = (1.0 - filter_step) * exp(drift) + filter_step * overspeed_max;
    // One part in 1e15 is taken off the filter's rate of fall: both sides of the condition are rounded.
    let reach = -log1p(-filter_step) * (1.0 - 1e-15);
    (band >= 1.0 && drift >= 0.0 && drift * band <= reach).then_some(band)
}

/// Largest `m` on a frozen path when `u` arrives `delay` samples late: `1 + (1 - (1 - a)^(D+1)) (g - 1)`.
#[must_use]
pub fn delayed_frozen_band(filter_step: f64, overspeed: f64, delay: u32) -> f64 {
    let reach = -libm::expm1((f64::from(delay) + 1.0) * log1p(-filter_step));
    1.0 + reach * positive_part(overspeed - 1.0)
}

/// Largest `m` on a frozen path with feedback (claim `feedback-band`): `1 + a g - Kp Ts`, or `None` unless `af >= Kp`.
///
/// Hypotheses: `g >= 1` constant, `m[0]` within the band, direction-preserving saturation, and a robot that trails: no joint's feedback
/// opposes its feedforward at the start (none does on the path). Without the last one the band can be left. Either advance.
#[must_use]
pub fn frozen_band_with_feedback(filter_step: f64, overspeed: f64, gain_step: f64) -> Option<f64> {
    (filter_step >= gain_step && gain_step >= 0.0).then(|| 1.0 + filter_step * overspeed - filter_step.min(gain_step))
}

/// True if the switch acts at all on a path with `g` constant (claim `switching`, exact):
/// some sample `k` of the run has `g (1 - (1 - f0)(1 - a)^k) > 1`.
///
/// `[G11] eq 21` asks for `g >= 1` only: that is necessary, and not sufficient. A run can end before the filter is there,
/// and at equality no switch ever happens.
#[must_use]
pub fn switches_by(filter_step: f64, overspeed: f64, initial_factor: f64, samples: u32) -> bool {
    // Not exp(0 * log1p(-a)) at the first sample: with a = 1 that is 0 * infinity, a NaN that would deny the switch.
    let left = if samples == 0 { 1.0 } else { exp(f64::from(samples) * log1p(-filter_step)) };
    let risen = 1.0 - (1.0 - initial_factor) * left;
    // [G11] eq 21 is `overspeed >= 1`.
    overspeed * risen > 1.0
}

/// The paper's estimate of the chattering amplitude of one joint, `[G11] eq 23`: `|v_i| a λ̇d` with `v = J⁻¹ f'`.
///
/// An estimate, not a bound: it leaves out the drift of `v` along the path, see [`chattering_bound`].
#[must_use]
pub fn chattering_estimate(joint_rate: f64, filter_step: f64, target_rate: f64) -> f64 {
    // [G11] eq 23
    libm::fabs(joint_rate) * filter_step * target_rate
}

/// Bound on the change of one joint's desired speed over one sample (claim `chattering-band`):
///
/// ```text
/// |Δq̇d,i| <= |B_i[k+1]| |Δf| + f |ΔB_i| + |ΔA_i|,   |Δf| = a |u - f|,   q̇d = A + f B
/// ```
///
/// `feedforward` is `B_i[k+1] = v_i λ̇d`, `drift` is `f |ΔB_i| + |ΔA_i|`; on the path and with `sup |dv_i/dλ|` known in
/// advance `drift` is at most `Ts λ̇² sup |dv_i/dλ|`.
#[must_use]
pub fn chattering_bound(feedforward: f64, factor_change: f64, drift: f64) -> f64 {
    libm::fabs(feedforward) * libm::fabs(factor_change) + libm::fabs(drift)
}
