use crate::error::{ParameterError, positive};

/// First-order low-pass filter of unit gain, advanced by Euler steps.
///
/// ```text
/// f[k+1] = (1 - a) f[k] + a u[k],   a = bandwidth * sampling_period
/// ```
///
/// `[G11] eq 19, 22`, with `u[k]` instead of the printed `u[k+1]`, which would make an algebraic loop.
///
/// Guaranteed (claim `factor-range`): with `u` in [0, 1] and `f` in [0, 1] the output stays in [0, 1], to the last bit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FirstOrderFilter {
    step: f64,
}

impl FirstOrderFilter {
    /// Validates the bandwidth (rad/s) and the sampling period (s).
    ///
    /// # Errors
    ///
    /// Either number is not positive and finite, or their product exceeds 1.
    pub fn new(bandwidth: f64, sampling_period: f64) -> Result<Self, ParameterError> {
        let bandwidth = positive(bandwidth, ParameterError::Bandwidth)?;
        let sampling_period = positive(sampling_period, ParameterError::SamplingPeriod)?;
        let step = bandwidth * sampling_period;
        if step > 0.0 && step <= 1.0 { Ok(Self { step }) } else { Err(ParameterError::FilterStep { step }) }
    }

    /// The filter step `a`, in (0, 1].
    #[must_use]
    pub fn step(&self) -> f64 {
        self.step
    }

    /// The output after one sample with input `u`.
    ///
    /// Written as `f + a (u - f)`: each operation rounds monotonically, so the result cannot pass the nearer of 0 and 1.
    #[inline]
    #[must_use]
    pub fn next(&self, output: f64, input: f64) -> f64 {
        // [G11] eq 22: Euler steps of [G11] eq 19.
        output + self.step * (input - output)
    }
}
