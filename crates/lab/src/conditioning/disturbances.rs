use crate::disturbances::{MOST_DELAY, MOST_JITTER, MOST_NOISE, Uniform, in_words, within};
use serde::Serialize;
use slideway_conditioner::path::{ConstraintSample, Motion};
use slideway_path::ProblemError;
use std::fmt;

/// Disturbances of a conditioned run that the conditioner does not know of: the table `[disturbances]` of a conditioning scenario. By
/// default none.
///
/// They concern the forms of the conditioner; the methods that it is compared with run without. The conditioned position is the
/// conditioner's own output and needs no measurement: what it is told about the constraints does. A trace tells the truth: `σ` and
/// `φ` are those of the constraints as they are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct PathDisturbances {
    /// Seed of noise and jitter, which draw from sequences of their own.
    pub seed: u64,
    /// Where the conditioned reference starts, relative to the reference, m. Unless it is zero the start is at rest.
    pub initial_error: [f64; 3],
    /// Greatest noise of a measured distance `σ`, m: uniform, drawn anew for every constraint and sample. Gradients are seen right.
    pub distance_noise: f64,
    /// Samples by which the constraints are seen late: where they were then. One that stands still is seen right.
    pub delay: u32,
    /// Share of the sampling period by which a period may be longer or shorter, uniform: it lasts `T (1 + jitter r)` with `r` in [-1, 1),
    /// while the conditioner counts on `T`. Reference and constraints go on by what it lasted.
    pub jitter: f64,
}

impl fmt::Display for PathDisturbances {
    /// Lists the disturbances in words, apart from the seed.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let off = self.initial_error.iter().map(|e| e * e).sum::<f64>().sqrt();
        let words = [
            (off, "start off by {} m"),
            (self.distance_noise, "measured distances off by up to {} m"),
            (f64::from(self.delay), "constraints seen late by {} samples"),
            (100.0 * self.jitter, "periods off by up to {} %"),
        ];
        in_words(f, &words)
    }
}

impl PathDisturbances {
    /// True if there are no disturbances.
    #[must_use]
    pub fn are_none(&self) -> bool {
        self.initial_error == [0.0; 3] && !self.are_random() && self.delay == 0
    }

    /// True if the seed changes anything.
    #[must_use]
    pub fn are_random(&self) -> bool {
        self.distance_noise != 0.0 || self.jitter != 0.0
    }

    /// Refuses values that cannot be meant; NaN is one.
    ///
    /// # Errors
    ///
    /// The first value that no scenario may have, with its key.
    pub fn check(&self) -> Result<(), ProblemError> {
        for (i, value) in self.initial_error.iter().enumerate() {
            within(&format!("initial_error.{i}"), *value, -f64::MAX, f64::MAX)?;
        }
        within("distance_noise", self.distance_noise, 0.0, MOST_NOISE)?;
        within("delay", self.delay.into(), 0.0, MOST_DELAY.into())?;
        within("jitter", self.jitter, 0.0, MOST_JITTER)
    }
}

/// The conditioner's disturbed view of the constraints, and the real lengths of its periods.
pub(crate) struct Surroundings<const M: usize> {
    /// Noise of this sample, m; the same for every evaluation in it.
    noise: Option<[f64; M]>,
    amplitude: f64,
    /// Age of the constraints as they are seen, s.
    late: f64,
    jitter: f64,
    measuring: Uniform,
    clock: Uniform,
}

impl<const M: usize> Surroundings<M> {
    pub(crate) fn new(disturbances: &PathDisturbances, period: f64) -> Self {
        Self {
            noise: None,
            amplitude: disturbances.distance_noise,
            late: f64::from(disturbances.delay) * period,
            jitter: disturbances.jitter,
            measuring: Uniform::new(disturbances.seed, 0),
            clock: Uniform::new(disturbances.seed, 1),
        }
    }

    /// True if the conditioner sees the constraints as they are.
    pub(crate) fn shows_the_truth(&self) -> bool {
        self.amplitude == 0.0 && self.late == 0.0
    }

    /// Draws the noise of a new sample.
    pub(crate) fn measure(&mut self) {
        let amplitude = self.amplitude;
        self.noise = (amplitude != 0.0).then(|| std::array::from_fn(|_| amplitude * self.measuring.next()));
    }

    /// The motion at whose time the constraints are seen; before the start they stood as at the start.
    pub(crate) fn seen_at(&self, motion: &Motion<3>) -> Motion<3> {
        if self.late == 0.0 { *motion } else { Motion { time: (motion.time - self.late).max(0.0), ..*motion } }
    }

    /// The constraints as they are seen, their values off by the noise of this sample.
    pub(crate) fn seen(&self, mut samples: [ConstraintSample<3>; M]) -> [ConstraintSample<3>; M] {
        for (sample, noise) in samples.iter_mut().zip(self.noise.iter().flatten()) {
            sample.value += noise;
        }
        samples
    }

    /// Real length of the coming period, s. Call it once a sample.
    pub(crate) fn period(&mut self, nominal: f64) -> f64 {
        if self.jitter == 0.0 { nominal } else { nominal * (1.0 + self.jitter * self.clock.next()) }
    }
}
