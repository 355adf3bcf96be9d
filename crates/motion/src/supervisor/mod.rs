//! The supervisor: which mode the arm's controller is in, and what changes it.
//!
#![doc = include_str!("../../docs/supervisor.md")]

mod diagram;
mod exits;
mod log;
mod machine;
mod mode;

pub use diagram::diagram;
pub use exits::Cause;
pub use log::{Event, EventLog};
pub use machine::Supervisor;
pub use mode::{AfterBrake, Fault, Inputs, Mode, QueueState, SegmentKind, Signals};
