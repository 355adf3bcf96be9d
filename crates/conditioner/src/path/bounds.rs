//! Proven bands of the path conditioner and the paper's estimates.
//!
//! Notation: `G` is the full push of one sample in terms of `φ`, `D` its drift over one sample without a push, `D̄` the
//! largest.

use super::filters::{Discretisation, PushFilter};
use crate::bounds::positive_part;

/// The paper's chattering band, `[G12] eq 22`: `T α1² K ‖u_SM‖ ‖∇σ‖`. An estimate of the width, not a bound on `φ`.
#[must_use]
pub fn chattering_estimate(period: f64, cutoff: f64, approach: f64, push: f64, gradient: f64) -> f64 {
    // [G12] eq 22; [G12] eq 23 is the same number, read as a bound on `σ`.
    period * cutoff * cutoff * approach * libm::fabs(push) * libm::fabs(gradient)
}

/// Fall of `φ` over one sample per unit of push along a unit gradient, zero-order hold: `γ1 + K γ2`.
///
/// `γ1` and `γ2` are what a unit push held for the sampling period adds to position and velocity: `G = (γ1 + K γ2) ‖u_SM‖ ‖∇σ‖`.
#[must_use]
pub fn push_per_sample(period: f64, cutoff: f64, approach: f64) -> f64 {
    let [position, velocity] = PushFilter::new(cutoff, period, Discretisation::ZeroOrderHold).reach();
    position + approach * velocity
}

/// Lower and upper end of a band.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// Smallest `φ` while sliding.
    pub lower: f64,
    /// Largest `φ`.
    pub upper: f64,
}

/// Band of `φ` while sliding on one constraint, zero-order hold or Euler (claim `path-band`): `-(G - D_min)⁺ <= φ <= D̄`.
///
/// Hypotheses: `φ <= 0` when contact begins and `D <= G` throughout. With a pair of constraints use
/// [`pair_push`] for `G`.
#[must_use]
pub fn band(push: f64, drift_min: f64, drift_max: f64) -> Band {
    Band { lower: -positive_part(push - drift_min), upper: positive_part(drift_max) }
}

/// Upper band of `φ` in the appendix's scheme, where a push takes effect over three samples (0, 1/4, 3/4 of it):
/// `D̄ + (D̄ - G/4)⁺ + (D̄ - 3G/4)⁺` (claim `path-band-appendix`).
#[must_use]
pub fn appendix_upper_band(push: f64, drift_max: f64) -> f64 {
    positive_part(drift_max) + positive_part(drift_max - 0.25 * push) + positive_part(drift_max - 0.75 * push)
}

/// Fall of one constraint's `φ` over one sample under a push shared by two: `G √((1 + c) / 2)`, `c` the cosine between the gradients.
#[must_use]
pub fn pair_push(push: f64, cosine: f64) -> f64 {
    push * libm::sqrt(positive_part(0.5 * (1.0 + cosine)))
}

/// Largest rise of `φ` between two samples at which it is not positive: `T² sup |φ̈| / 8`. `σ` rises no further.
#[must_use]
pub fn between_samples(period: f64, second_derivative: f64) -> f64 {
    0.125 * period * period * libm::fabs(second_derivative)
}

/// Longest time to get back inside from rest at `σ = outside > 0` with the implicit form or the reserve, s.
///
/// ```text
/// t <= (outside + margin) / rate + K ln((outside + margin) / margin)
/// ```
///
/// The first term is the time until `φ + margin` is gone, falling at the recovery rate; from then on `σ + margin` falls at
/// least as fast as `exp(-t / K)`. Without a margin the boundary is neared for ever, and the answer is infinite.
#[must_use]
pub fn recovery_time(outside: f64, margin: f64, rate: f64, approach: f64) -> f64 {
    let depth = outside + margin;
    depth / rate + approach * libm::log(depth / margin)
}

/// Smallest switching gain that makes the sum law slide: `max μ_i`, where `μ = (L_g L_gᵀ)⁻¹ L_f` (claim `path-gain`).
///
/// Sharp, where `[G12] eq 21` can be several times too large. `multipliers` are those of
/// `min ‖u‖²` subject to `L_f φ + L_g φ u <= 0`, which the equivalent control attains (claim `path-equivalence`).
#[must_use]
pub fn required_gain<const M: usize>(multipliers: &[f64; M]) -> f64 {
    // [G12] eq 18 with one multiplier; in place of [G12] eq 21 with several.
    multipliers.iter().fold(0.0, |most, &b| if b <= most || most.is_nan() { most } else { b })
}
