use core::fmt;

use crate::path::PathQuantity;
use crate::shapes::ShapeParameter;

/// Why a set of parameters was refused.
///
/// Every variant carries the value that was refused, so that whoever shows the error can say what to change.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ParameterError {
    /// An upper joint-speed limit is not a positive finite number.
    UpperLimit {
        /// Joint, counted from 0.
        joint: usize,
        /// The limit that was given.
        value: f64,
    },
    /// A lower joint-speed limit is not a negative finite number.
    LowerLimit {
        /// Joint, counted from 0.
        joint: usize,
        /// The limit that was given.
        value: f64,
    },
    /// An upper joint-acceleration limit is not a positive finite number.
    UpperAcceleration {
        /// Joint, counted from 0.
        joint: usize,
        /// The limit that was given.
        value: f64,
    },
    /// A lower joint-acceleration limit is not a negative finite number.
    LowerAcceleration {
        /// Joint, counted from 0.
        joint: usize,
        /// The limit that was given.
        value: f64,
    },
    /// A joint speed to start from lies outside its limits.
    Speed {
        /// Joint, counted from 0.
        joint: usize,
        /// The speed that was given.
        value: f64,
    },
    /// The gain of the position loop is not a positive finite number.
    Gain(f64),
    /// Gain times sampling period exceeds one half.
    GainStep {
        /// `gain * sampling_period`.
        step: f64,
    },
    /// The look-ahead's margin is not in [0, 1).
    AccelerationMargin(f64),
    /// The sampling period is not a positive finite number of seconds.
    SamplingPeriod(f64),
    /// The filter bandwidth is not a positive finite number of radians per second.
    Bandwidth(f64),
    /// The target rate of the path parameter is not positive and finite.
    TargetRate(f64),
    /// Bandwidth times sampling period exceeds 1: the discrete filter would leave [0, 1].
    FilterStep {
        /// `bandwidth * sampling_period`.
        step: f64,
    },
    /// A speed factor outside [0, 1].
    Factor(f64),
    /// A parameter of the path conditioner is out of its range.
    Path {
        /// Which one.
        quantity: PathQuantity,
        /// The value that was given.
        value: f64,
    },
    /// The safe walk was asked for without the explicit form and its reserve, which its guarantee rests on.
    SafeWalkWithoutReserve,
    /// A parameter of a shape is out of its range.
    Shape {
        /// Which one.
        parameter: ShapeParameter,
        /// The value that was given.
        value: f64,
    },
}

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::UpperLimit { joint, value } => {
                write!(f, "upper speed limit of joint {} is {value}; it must be positive and finite", joint + 1)
            }
            Self::LowerLimit { joint, value } => {
                write!(f, "lower speed limit of joint {} is {value}; it must be negative and finite", joint + 1)
            }
            Self::UpperAcceleration { joint, value } => {
                write!(f, "upper acceleration limit of joint {} is {value}; it must be positive and finite", joint + 1)
            }
            Self::LowerAcceleration { joint, value } => {
                write!(f, "lower acceleration limit of joint {} is {value}; it must be negative and finite", joint + 1)
            }
            Self::Speed { joint, value } => {
                write!(f, "initial speed of joint {} is {value}, outside its speed limits", joint + 1)
            }
            Self::Gain(value) => write!(f, "position gain is {value} 1/s; it must be positive and finite"),
            Self::GainStep { step } => {
                write!(
                    f,
                    "gain times sampling period is {step}, which must not exceed 0.5; lower the gain or sample faster"
                )
            }
            Self::AccelerationMargin(value) => {
                write!(f, "the share of the acceleration limits kept in reserve is {value}; it must lie in [0, 1)")
            }
            Self::SamplingPeriod(value) => {
                write!(f, "sampling period is {value} s; it must be positive and finite")
            }
            Self::Bandwidth(value) => {
                write!(f, "filter bandwidth is {value} rad/s; it must be positive and finite")
            }
            Self::TargetRate(value) => {
                write!(f, "target rate of the path parameter is {value} 1/s; it must be positive and finite")
            }
            Self::FilterStep { step } => {
                write!(
                    f,
                    "bandwidth times sampling period is {step}, which must not exceed 1; lower the bandwidth or sample faster"
                )
            }
            Self::Factor(value) => write!(f, "speed factor is {value}; it must lie in [0, 1]"),
            Self::SafeWalkWithoutReserve => {
                write!(f, "the safe walk needs the explicit zero-order-hold form with its reserve switched on")
            }
            Self::Shape { parameter, value } => write!(f, "{parameter} is {value}, which is out of its range"),
            Self::Path { quantity, value } => write!(f, "{quantity} is {value}, which is out of its range"),
        }
    }
}

impl core::error::Error for ParameterError {}

/// Accepts positive finite numbers only; NaN is refused.
pub(crate) fn positive(value: f64, error: fn(f64) -> ParameterError) -> Result<f64, ParameterError> {
    if value > 0.0 && value.is_finite() { Ok(value) } else { Err(error(value)) }
}
