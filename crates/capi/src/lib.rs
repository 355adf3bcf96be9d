//! The conditioners for robot controllers in C and C++.
//!
//! The functions here are what `include/slideway.h` declares; that file is generated from this crate and documents each function for
//! C. `include/slideway.hpp` wraps it for C++17.
//!
//! # Rules of the border
//!
//! - *No panic is meant to be reachable*: pointers, sizes, numbers of joints and choices are checked, and answered by a
//!   [`Status`]. For the core a gate in CI proves that none is; for this crate it is by design and by tests, not proven. What cannot be checked (a pointer to memory that is not there) is the caller's promise.
//! - *NaN fails safe* as in the core: a NaN in an input brakes, it is no error. After a call that fails, a command that could be written
//!   says standstill.
//! - *No allocation* but in `slideway_*_new`, no lock, no global state, no system call, and a bounded number of operations a call.
//! - *Threads*: one object is used by one thread at a time; different objects do not know of one another. An object may move from
//!   thread to thread, given the usual hand-over (a mutex, or the start of a thread).
//! - *Versions*: every structure begins with its size in bytes. A library refuses sizes that it does not know, instead of reading beyond
//!   the end of a structure.
//! - *Inputs may overlap outputs*: all inputs are read before the first output is written.

#![no_std]

#[cfg(feature = "std")]
extern crate std;

mod acceleration;
mod callback;
mod choices;
mod command;
mod constraint;
mod dispatch;
#[cfg(feature = "std")]
mod heap;
mod look_ahead;
mod memory;
#[cfg(feature = "panic-handler")]
mod panic;
mod path;
mod path_output;
mod path_settings;
mod refusal;
mod speed;
mod status;
mod surface;

pub use acceleration::{
    Acceleration, AccelerationSettings, slideway_acceleration_drop, slideway_acceleration_place,
    slideway_acceleration_set_state, slideway_acceleration_size, slideway_acceleration_step,
};
pub use callback::{ConstraintValue, EvaluateConstraint, PathMotion};
pub use choices::{
    AllowedSide, CarrierKind, Form, HoldCause, Keeping, MarginKind, Outcome, Phase, PushLaw, RecoveryKind,
    SaturationKind, ShapeKind, SpeedLaw, WalkKind,
};
pub use command::{AccelerationCommand, SpeedCommand};
pub use constraint::Constraint;
#[cfg(feature = "std")]
pub use heap::{
    slideway_acceleration_free, slideway_acceleration_new, slideway_path_free, slideway_path_new, slideway_speed_free,
    slideway_speed_new,
};
pub use look_ahead::{Preview, slideway_look_ahead_ranges, slideway_look_ahead_rate, slideway_look_ahead_rate_within};
pub use path::{
    Path, slideway_path_drop, slideway_path_place, slideway_path_restart, slideway_path_size, slideway_path_step,
};
pub use path_output::PathOutput;
pub use path_settings::PathSettings;
pub use refusal::{NO_INDEX, Refusal};
pub use speed::{
    Speed, SpeedSettings, slideway_speed_drop, slideway_speed_place, slideway_speed_requested_rate,
    slideway_speed_set_factor, slideway_speed_set_limits, slideway_speed_size, slideway_speed_step,
    slideway_speed_step_affine,
};
pub use status::{Status, slideway_status_message};

/// Version of this interface. It grows when something is added; a library serves every program that was compiled with the same or a
/// smaller one.
pub const ABI_VERSION: u32 = 1;

/// Largest number of joints or coordinates.
pub const MAX_JOINTS: usize = 12;

/// Largest number of constraints of a path conditioner.
pub const MAX_CONSTRAINTS: usize = 4;

/// Largest number of faces of a polytope.
pub const MAX_FACES: usize = 8;

/// Alignment of the memory that an object is placed in, bytes.
pub const ALIGNMENT: usize = 8;

/// Largest number of times that a constraint is evaluated in one step.
pub const MAX_EVALUATIONS: u32 = 20;

/// Bytes that are enough for a speed regulator of any number of joints.
pub const SPEED_SIZE_MAX: usize = 288;

/// Bytes that are enough for an acceleration-limited regulator of any number of joints.
pub const ACCELERATION_SIZE_MAX: usize = 1280;

/// Bytes that are enough for a path conditioner of any size.
pub const PATH_SIZE_MAX: usize = 8192;

/// The version of the library that is linked: [`ABI_VERSION`] of its own header.
#[unsafe(no_mangle)]
pub extern "C" fn slideway_abi_version() -> u32 {
    ABI_VERSION
}
