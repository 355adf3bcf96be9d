//! The ways out of each mode, a type per mode: a rule for one mode cannot name a way out of another.
//!
//! The order of the rules is the tie-break: faults first, then the harder brake, then the softer, then what the queue did, then
//! requests. In a mode at rest requests that keep it there come first.

mod motion;
mod rest;

pub(super) use motion::{from_braking_fully, from_braking_on_path, from_motion, from_recovery};
pub(super) use rest::{from_fault, from_idle, from_paused};

use super::mode::{Mode, SegmentKind};

/// Why a mode was left.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Cause {
    /// A fault.
    Fault,
    /// A request for a full brake.
    BrakeFully,
    /// A brake on the path took too long.
    Overdue,
    /// A request for a brake on the path.
    BrakeOnPath,
    /// The joints came to rest.
    Rest,
    /// The queue ran empty.
    Finished,
    /// The next segment is of the other kind.
    NextSegment,
    /// A request to start.
    Start,
    /// A request to go on.
    Resume,
    /// A request to give up the path.
    Discard,
    /// A request to reset a fault.
    Reset,
    /// A request to recover from a fault.
    Recover,
}

/// A way out of a mode.
pub(super) trait Exit: Copy {
    fn to(self) -> Mode;
    fn cause(self) -> Cause;
}

fn moving(kind: SegmentKind) -> Mode {
    match kind {
        SegmentKind::Joint => Mode::JointMotion,
        SegmentKind::Tool => Mode::ToolMotion,
    }
}
