use crate::MotionError;
use crate::error::positive;
use std::f64::consts::TAU;

/// An experiment with a sine: some periods to settle, some to measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SineTest {
    /// Amplitude of the reference, in its unit. Small enough that nothing saturates.
    pub amplitude: f64,
    /// Periods that are not measured.
    pub settling_periods: u32,
    /// Periods that are.
    pub measured_periods: u32,
    /// Sampling period, s.
    pub sampling_period: f64,
}

/// Answer to a sine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrequencyResponse {
    /// Frequency at which it was measured, rad/s: a whole number of samples in each period.
    pub frequency: f64,
    /// Amplitude of the answer's first harmonic over that of the reference.
    pub gain: f64,
    /// Its phase against the reference in (-π, π], rad; negative when late.
    pub phase: f64,
}

impl SineTest {
    /// Answer of `system` near a frequency (rad/s). It is asked once a sample: the output for a reference.
    ///
    /// The first Fourier coefficient over whole periods: exact for a linear system that has settled, and blind to constant
    /// offsets and to other harmonics.
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`]: a number that is not positive, or a frequency of fewer than eight samples a period.
    pub fn run(
        &self,
        frequency: f64,
        system: &mut impl FnMut(f64) -> Result<f64, MotionError>,
    ) -> Result<FrequencyResponse, MotionError> {
        positive("amplitude", self.amplitude)?;
        positive("sampling_period", self.sampling_period)?;
        positive("frequency", frequency)?;
        let samples = (TAU / (frequency * self.sampling_period)).round();
        crate::error::setting("frequency", frequency, (8.0..1e9).contains(&samples) && self.measured_periods > 0)?;
        let samples = samples as u64;
        let measured_from = samples * u64::from(self.settling_periods);
        let (mut sine, mut cosine) = (0.0, 0.0);
        for k in 0..measured_from + samples * u64::from(self.measured_periods) {
            // The phase starts anew in each period, so that it does not lose digits.
            let (s, c) = (TAU * (k % samples) as f64 / samples as f64).sin_cos();
            let output = system(self.amplitude * s)?;
            if k >= measured_from {
                (sine, cosine) = (sine + output * s, cosine + output * c);
            }
        }
        let scale = 2.0 / (samples as f64 * f64::from(self.measured_periods) * self.amplitude);
        let frequency = TAU / (samples as f64 * self.sampling_period);
        Ok(FrequencyResponse { frequency, gain: scale * sine.hypot(cosine), phase: cosine.atan2(sine) })
    }
}
