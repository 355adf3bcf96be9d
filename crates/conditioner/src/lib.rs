//! Sliding-mode reference conditioners.
//!
//! A conditioner sits between a path-following controller and the joints. It sees what the controller asks of the
//! joints and what the joints can do, and decides how fast the reference may go on. It knows neither robot nor path,
//! needs no model and looks at no future sample.
//!
//! The crate is `no_std`, allocates nothing, contains no `unsafe` and no reachable panic, and runs in a bounded number
//! of floating-point operations per sample, so the same code serves a desktop study, a 1-8 kHz loop and a
//! microcontroller.
//!
//! # One sample of speed auto-regulation
//!
//! ```
//! use slideway_conditioner::{Advance, Saturation, SpeedLimits, SpeedRegulator, SpeedSettings, SpeedState};
//!
//! let regulator = SpeedRegulator::new(SpeedSettings {
//!     limits: SpeedLimits::symmetric([0.5, 0.5])?, // rad/s
//!     sampling_period: 1e-3,                       // s
//!     bandwidth: 5.0,                              // rad/s
//!     target_rate: 5.0,                            // 1/s, faster than the joints allow
//!     saturation: Saturation::DirectionPreserving,
//!     advance: Advance::Synchronised,
//! })?;
//!
//! let mut state = SpeedState::at_rest();
//! let mut path_parameter = 0.0;
//! for _ in 0..2000 {
//!     // Any controller: this one turns both joints in proportion to the requested path rate.
//!     let rate = regulator.requested_rate(&state);
//!     let command = regulator.step(&mut state, &[0.2 * rate, 0.3 * rate]);
//!     path_parameter += 1e-3 * command.path_rate;
//! }
//! // The second joint allows 0.5 / 0.3 = 1.67 path units per second; the filter needs a moment to get there.
//! assert!(path_parameter > 2.9 && path_parameter < 2.0 * 0.5 / 0.3);
//! # Ok::<(), slideway_conditioner::ParameterError>(())
//! ```
//!
//! # One reference bent along a wall
//!
//! ```
//! use slideway_conditioner::PathConditioner;
//! use slideway_conditioner::path::{Constraint, Margin, Motion, PathForm, PathSettings};
//! use slideway_conditioner::shapes::HalfSpace;
//!
//! let conditioner = PathConditioner::<2, 1>::new(PathSettings {
//!     sampling_period: 1e-3,                                // s
//!     push_cutoff: 20.0,                                    // rad/s
//!     approach: [0.1],                                      // s
//!     margin: Margin::Fixed([1e-4]),                        // m
//!     form: PathForm::Implicit { recovery_rate: 0.5 },      // m/s
//!     trap: None,
//! })?;
//! let wall = HalfSpace::new(&[1.0, 0.0], 0.2)?;             // x <= 0.2 m
//! let mut state = conditioner.on_reference();
//! for k in 0..2000 {
//!     let time = 1e-3 * f64::from(k);
//!     let reference = Motion { time, position: [0.3 * time.sin(), time], velocity: [0.3 * time.cos(), 1.0] };
//!     let step = conditioner.step(&mut state, &reference, |motion| [wall.sample(motion)]);
//!     assert!(step.sigma[0] <= 0.0);
//! }
//! # Ok::<(), slideway_conditioner::ParameterError>(())
//! ```
//!
//! # Safety of the input
//!
//! A NaN or an infinity anywhere in an input brakes: the switch is [`Switch::Brake`], the joints are commanded to stand
//! still, and the reference does not advance. The path conditioner gives out its last position again, at rest, and says
//! why ([`path::HoldReason`]).
//!
//! # Sources
//!
//! `[G11]` is Garelli, Gracia, Sala, Albertos, "Sliding mode speed auto-regulation technique for robotic tracking",
//! Robotics and Autonomous Systems 59 (2011). `[G12]` is Gracia, Sala, Garelli, "A path conditioning method with trap
//! avoidance", Robotics and Autonomous Systems 60 (2012).

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
