use crate::MotionError;
use crate::error::positive;

/// A winding that warms with the square of its current and cools towards its surroundings.
///
/// ```text
/// τ ḣ = (i / Ic)² - h          h = rise of temperature over the rise that is allowed
/// ```
///
/// Exact over a sample of constant current: `h' = h + α ((i / Ic)² - h)`, `α = 1 - exp(-T / τ)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Winding {
    continuous_current: f64,
    /// `α`.
    share: f64,
}

impl Winding {
    /// The current that may flow for ever (A), the thermal time constant and the sampling period (s).
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`] unless all are positive and finite.
    pub fn new(continuous_current: f64, time_constant: f64, sampling_period: f64) -> Result<Self, MotionError> {
        positive("continuous_current", continuous_current)?;
        positive("time_constant", time_constant)?;
        positive("sampling_period", sampling_period)?;
        Ok(Self { continuous_current, share: -(-sampling_period / time_constant).exp_m1() })
    }

    /// Largest current (A) of a sample after which `h` is at most 1: `Ic sqrt(h + (1 - h) / α)`, for `h` in [0, 1].
    #[must_use]
    pub fn largest_current(&self, heat: f64) -> f64 {
        self.continuous_current * (heat + (1.0 - heat).max(0.0) / self.share).sqrt()
    }

    /// `h` after a sample at a current. Never above 1 from at most 1 while the current is at most
    /// [`Winding::largest_current`]; the last rounding is cut off.
    #[must_use]
    pub fn after(&self, heat: f64, current: f64) -> f64 {
        let ratio = current.abs().min(self.largest_current(heat)) / self.continuous_current;
        (heat + self.share * (ratio * ratio - heat)).min(1.0)
    }
}
