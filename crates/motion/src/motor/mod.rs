//! Between command and arm: delay, speed loop, current loop, heat, encoder.
//!
//! Friction and rotor inertia belong to the joint (`Drive` of the robot's dynamics) and are part of the plant.

mod delay;
mod encoder;
mod heat;
mod loops;

pub use delay::{Delay, DelayLine, LONGEST_DELAY};
pub use encoder::Encoder;
pub use heat::Winding;
pub use loops::{Motor, MotorCommand, MotorOutput, MotorSettings, MotorState};
