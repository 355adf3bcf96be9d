use crate::MotionError;
use crate::error::positive;
use std::f64::consts::TAU;

/// An encoder: positions come in counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Encoder {
    resolution: f64,
}

impl Encoder {
    /// An encoder with a resolution at the joint, rad (m).
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`] unless it is positive and finite.
    pub fn new(resolution: f64) -> Result<Self, MotionError> {
        positive("resolution", resolution)?;
        Ok(Self { resolution })
    }

    /// An encoder on the motor's shaft before a gear.
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`] unless both numbers are finite and not zero.
    pub fn on_motor(counts_per_turn: f64, gear_ratio: f64) -> Result<Self, MotionError> {
        positive("counts_per_turn", counts_per_turn)?;
        positive("gear_ratio", gear_ratio.abs())?;
        Self::new(TAU / (counts_per_turn * gear_ratio.abs()))
    }

    /// Smallest change that is seen, rad (m).
    #[must_use]
    pub fn resolution(&self) -> f64 {
        self.resolution
    }

    /// The nearest count, as a position: at most half a count off.
    #[must_use]
    pub fn read(&self, q: f64) -> f64 {
        (q / self.resolution).round() * self.resolution
    }
}
