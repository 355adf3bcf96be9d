use slideway_path::{Fault, ProblemError};
use slideway_robot::augmented::Flow;

/// Law of the speed along the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpeedLaw {
    /// Natural motion: `b` constant, `q̇* = b φ` with the speed factor `φ` (`det J` or a part of it).
    Natural {
        /// `b`; its unit is the joints' speed divided by that of the null vector.
        b: f64,
    },
    /// `q̇*` constant. Where `φ` vanishes no joint speed does this.
    Constant {
        /// `q̇*`, 1/s.
        path_speed: f64,
    },
}

/// The independent variable of the inversion and its rate, at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pace {
    pub(super) b: f64,
    pub(super) b_rate: f64,
}

impl SpeedLaw {
    /// `b` and `ḃ` on a flow with the ramp's value.
    ///
    /// Of `q̇* = b φ` and `q̈* = ḃ φ + b² φ'`, with `φ'` the derivative of `φ` along the null vector.
    pub(super) fn pace<const N: usize>(self, flow: &Flow<N>, ramp: RampValue) -> Pace {
        match self {
            Self::Natural { b } => Pace { b: b * ramp.value, b_rate: b * ramp.rate },
            Self::Constant { path_speed } => {
                let b = path_speed * ramp.value / flow.direction.path;
                let b_rate = (path_speed * ramp.rate - b * b * flow.slope.path) / flow.direction.path;
                Pace { b, b_rate }
            }
        }
    }
}

/// Fifth-order start and stop: the speed variable (`b` or `q̇*`) times a factor that rises from 0 to 1 over `rise` seconds
/// with `p(x) = x³ (10 - 15 x + 6 x²)` and falls the same way before `interval` ends. Acceleration is continuous.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp {
    rise: f64,
    interval: f64,
}

/// A ramp at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RampValue {
    /// The factor, in [0, 1].
    pub value: f64,
    /// Its rate, 1/s.
    pub rate: f64,
}

impl Ramp {
    /// A ramp of `rise` seconds at each end of an interval, s. A rise of 0 is no ramp.
    ///
    /// # Errors
    ///
    /// An interval that is not positive and finite; a rise that is negative or longer than half of it.
    pub fn new(rise: f64, interval: f64) -> Result<Self, ProblemError> {
        if !(interval > 0.0 && interval.is_finite()) {
            return Err(ProblemError::value("interval", Fault::NotPositive(interval)));
        }
        if !(rise >= 0.0 && rise <= 0.5 * interval) {
            let fault = Fault::OutOfRange { value: rise, least: 0.0, most: 0.5 * interval };
            return Err(ProblemError::value("rise", fault));
        }
        Ok(Self { rise, interval })
    }

    /// Length of the interval, s.
    #[must_use]
    pub fn interval(&self) -> f64 {
        self.interval
    }

    /// The factor at a time, 0 outside the interval.
    #[must_use]
    pub fn at(&self, time: f64) -> RampValue {
        if self.rise == 0.0 {
            return RampValue { value: 1.0, rate: 0.0 };
        }
        let left = self.interval - time;
        let (nearest, sign) = if time < left { (time, 1.0) } else { (left, -1.0) };
        let x = (nearest / self.rise).clamp(0.0, 1.0);
        RampValue {
            value: x * x * x * (10.0 + x * (6.0 * x - 15.0)),
            rate: sign * 30.0 * x * x * (1.0 - x) * (1.0 - x) / self.rise,
        }
    }
}
