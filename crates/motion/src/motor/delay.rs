use crate::MotionError;
use crate::error::setting;

/// Longest delay, in samples.
pub const LONGEST_DELAY: usize = 16;

/// A delay of a whole number of samples, at most [`LONGEST_DELAY`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Delay {
    samples: usize,
}

/// Values on their way through a [`Delay`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DelayLine<T> {
    ring: [T; LONGEST_DELAY],
    next: usize,
}

impl<T: Copy> DelayLine<T> {
    /// A line in which the same value has been for ever.
    #[must_use]
    pub fn filled(value: T) -> Self {
        Self { ring: [value; LONGEST_DELAY], next: 0 }
    }
}

impl Delay {
    /// A delay of so many samples; 0 is none.
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`] above [`LONGEST_DELAY`].
    pub fn new(samples: usize) -> Result<Self, MotionError> {
        setting("delay", samples as f64, samples <= LONGEST_DELAY)?;
        Ok(Self { samples })
    }

    /// One sample: what went in `samples` ago.
    pub fn step<T: Copy>(&self, line: &mut DelayLine<T>, input: T) -> T {
        if self.samples == 0 {
            return input;
        }
        let place = line.next % self.samples;
        line.next = (place + 1) % self.samples;
        std::mem::replace(&mut line.ring[place], input)
    }
}
