use crate::MotionError;
use crate::error::not_negative;
use crate::motor::Encoder;
use rand::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use rand_xorshift::XorShiftRng;
use slideway_robot::{JointVector, Twist};

/// Standard deviations of what sensors add, each independent and normal.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Noise {
    /// Of joint positions, rad (m).
    pub position: f64,
    /// Of joint speeds, per s.
    pub speed: f64,
    /// Of forces, N.
    pub force: f64,
    /// Of moments, N·m.
    pub moment: f64,
}

/// Joint positions and speeds as a controller sees them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement<const N: usize> {
    /// Positions, rad (m).
    pub q: JointVector<N>,
    /// Speeds, per s.
    pub qd: JointVector<N>,
}

/// Encoders, tachometers and a force sensor with noise from a seed: the same seed gives the same readings on every machine.
#[derive(Clone, Debug)]
pub struct Sensors {
    noise: Noise,
    encoder: Option<Encoder>,
    random: XorShiftRng,
}

impl Sensors {
    /// Sensors with a noise of their own.
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`]: a deviation that is negative or not finite.
    pub fn new(noise: Noise, seed: u64) -> Result<Self, MotionError> {
        for (name, value) in
            [("position", noise.position), ("speed", noise.speed), ("force", noise.force), ("moment", noise.moment)]
        {
            not_negative(name, value)?;
        }
        Ok(Self { noise, encoder: None, random: XorShiftRng::seed_from_u64(seed) })
    }

    /// The same sensors with positions rounded to an encoder's counts, after the noise.
    #[must_use]
    pub fn with_encoder(self, encoder: Encoder) -> Self {
        Self { encoder: Some(encoder), ..self }
    }

    /// Readings of a joint state.
    pub fn joints<const N: usize>(&mut self, q: &JointVector<N>, qd: &JointVector<N>) -> Measurement<N> {
        let noise = self.noise;
        let noisy = q.map(|q| q + noise.position * self.normal());
        let encoder = self.encoder;
        Measurement {
            q: noisy.map(|q| encoder.map_or(q, |encoder| encoder.read(q))),
            qd: qd.map(|v| v + noise.speed * self.normal()),
        }
    }

    /// Readings of a force and a moment.
    pub fn wrench(&mut self, wrench: &Twist) -> Twist {
        let noise = self.noise;
        Twist::from_fn(|i, _| {
            let deviation = if i < 3 { noise.force } else { noise.moment };
            wrench[i] + deviation * self.normal()
        })
    }

    fn normal(&mut self) -> f64 {
        StandardNormal.sample(&mut self.random)
    }
}
