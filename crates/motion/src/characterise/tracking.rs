/// Largest and root-mean-square error of a run, gathered a sample at a time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TrackingError {
    peak: f64,
    squares: f64,
    samples: u64,
}

impl TrackingError {
    /// Takes an error of one sample into account. A NaN makes both numbers NaN.
    pub fn add(&mut self, error: f64) {
        let size = error.abs();
        self.peak = if self.peak >= size { self.peak } else { size };
        self.squares += error * error;
        self.samples += 1;
    }

    /// Largest error.
    #[must_use]
    pub fn peak(&self) -> f64 {
        if self.squares.is_nan() { f64::NAN } else { self.peak }
    }

    /// Root of the mean square; zero before the first sample.
    #[must_use]
    pub fn rms(&self) -> f64 {
        if self.samples == 0 { 0.0 } else { (self.squares / self.samples as f64).sqrt() }
    }
}
