#![doc = include_str!("../README.md")]
#![no_std]
#![forbid(unsafe_code)]

pub mod acceleration;
pub mod bounds;
mod error;
mod filter;
mod implicit;
mod limits;
pub mod path;
pub mod shapes;
mod speed;

pub use acceleration::{AccelerationLimits, AccelerationRegulator, LookAhead};
pub use error::ParameterError;
pub use filter::FirstOrderFilter;
pub use implicit::{AffineSpeed, ImplicitSpeedRegulator};
pub use limits::{Saturated, Saturation, SpeedLimits};
pub use path::PathConditioner;
pub use speed::{Advance, SpeedCommand, SpeedRegulator, SpeedSettings, SpeedState, Switch};
