//! Ways out of the modes in motion.

use super::{Cause, Exit, moving};
use crate::supervisor::mode::{AfterBrake, Fault, Mode, QueueState, SegmentKind, Signals};

/// Ways out of [`Mode::JointMotion`] and [`Mode::ToolMotion`].
#[derive(Clone, Copy)]
pub(in crate::supervisor) enum FromMotion {
    Fault(Fault),
    BrakeFully,
    BrakeOnPath,
    Finished,
    Paused,
    NextSegment(SegmentKind),
}

pub(in crate::supervisor) fn from_motion(kind: SegmentKind, signals: &Signals) -> Option<FromMotion> {
    if let Some(fault) = signals.inputs.fault {
        return Some(FromMotion::Fault(fault));
    }
    if signals.inputs.brake_fully {
        return Some(FromMotion::BrakeFully);
    }
    if signals.inputs.brake_on_path {
        return Some(FromMotion::BrakeOnPath);
    }
    match signals.queue {
        QueueState::Resting => Some(FromMotion::Finished),
        QueueState::Paused(_) => Some(FromMotion::Paused),
        QueueState::Ready(next) => (next != kind).then_some(FromMotion::NextSegment(next)),
    }
}

impl Exit for FromMotion {
    fn to(self) -> Mode {
        match self {
            Self::Fault(fault) => Mode::BrakingFully(AfterBrake::Fault(fault)),
            Self::BrakeFully => Mode::BrakingFully(AfterBrake::Idle),
            Self::BrakeOnPath => Mode::BrakingOnPath,
            Self::Finished => Mode::Idle,
            Self::Paused => Mode::Paused,
            Self::NextSegment(kind) => moving(kind),
        }
    }

    fn cause(self) -> Cause {
        match self {
            Self::Fault(_) => Cause::Fault,
            Self::BrakeFully => Cause::BrakeFully,
            Self::BrakeOnPath => Cause::BrakeOnPath,
            Self::Finished => Cause::Finished,
            Self::Paused => Cause::Rest,
            Self::NextSegment(_) => Cause::NextSegment,
        }
    }
}

/// Ways out of [`Mode::BrakingOnPath`].
#[derive(Clone, Copy)]
pub(in crate::supervisor) enum FromBrakingOnPath {
    Fault(Fault),
    BrakeFully,
    Overdue,
    Paused,
    Finished,
}

pub(in crate::supervisor) fn from_braking_on_path(signals: &Signals) -> Option<FromBrakingOnPath> {
    if let Some(fault) = signals.inputs.fault {
        return Some(FromBrakingOnPath::Fault(fault));
    }
    if signals.inputs.brake_fully {
        return Some(FromBrakingOnPath::BrakeFully);
    }
    match signals.queue {
        QueueState::Resting => Some(FromBrakingOnPath::Finished),
        QueueState::Paused(_) => Some(FromBrakingOnPath::Paused),
        QueueState::Ready(_) => signals.overdue.then_some(FromBrakingOnPath::Overdue),
    }
}

impl Exit for FromBrakingOnPath {
    fn to(self) -> Mode {
        match self {
            Self::Fault(fault) => Mode::BrakingFully(AfterBrake::Fault(fault)),
            Self::BrakeFully | Self::Overdue => Mode::BrakingFully(AfterBrake::Idle),
            Self::Paused => Mode::Paused,
            Self::Finished => Mode::Idle,
        }
    }

    fn cause(self) -> Cause {
        match self {
            Self::Fault(_) => Cause::Fault,
            Self::BrakeFully => Cause::BrakeFully,
            Self::Overdue => Cause::Overdue,
            Self::Paused => Cause::Rest,
            Self::Finished => Cause::Finished,
        }
    }
}

/// Ways out of [`Mode::BrakingFully`].
#[derive(Clone, Copy)]
pub(in crate::supervisor) enum FromBrakingFully {
    /// The first fault of a brake decides where it leads.
    Fault(Fault),
    Rest(AfterBrake),
}

pub(in crate::supervisor) fn from_braking_fully(after: AfterBrake, signals: &Signals) -> Option<FromBrakingFully> {
    match (after, signals.inputs.fault, signals.queue) {
        (AfterBrake::Idle, Some(fault), _) => Some(FromBrakingFully::Fault(fault)),
        (after, _, QueueState::Resting) => Some(FromBrakingFully::Rest(after)),
        (_, _, QueueState::Ready(_) | QueueState::Paused(_)) => None,
    }
}

impl Exit for FromBrakingFully {
    fn to(self) -> Mode {
        match self {
            Self::Fault(fault) => Mode::BrakingFully(AfterBrake::Fault(fault)),
            Self::Rest(AfterBrake::Idle) => Mode::Idle,
            Self::Rest(AfterBrake::Fault(fault)) => Mode::Fault(fault),
        }
    }

    fn cause(self) -> Cause {
        match self {
            Self::Fault(_) => Cause::Fault,
            Self::Rest(_) => Cause::Rest,
        }
    }
}

/// Ways out of [`Mode::Recovery`]: a recovery that is broken off leads back to its fault, or to a newer one.
#[derive(Clone, Copy)]
pub(in crate::supervisor) enum FromRecovery {
    Fault(Fault),
    Brake(Fault),
    Finished,
}

pub(in crate::supervisor) fn from_recovery(fault: Fault, signals: &Signals) -> Option<FromRecovery> {
    if let Some(newer) = signals.inputs.fault {
        return Some(FromRecovery::Fault(newer));
    }
    match signals.queue {
        _ if signals.inputs.brake_fully || signals.inputs.brake_on_path => Some(FromRecovery::Brake(fault)),
        QueueState::Resting => Some(FromRecovery::Finished),
        // Only joint motions lead out of a fault, and none stops on the way.
        QueueState::Ready(SegmentKind::Tool) | QueueState::Paused(_) => Some(FromRecovery::Brake(fault)),
        QueueState::Ready(SegmentKind::Joint) => None,
    }
}

impl Exit for FromRecovery {
    fn to(self) -> Mode {
        match self {
            Self::Fault(fault) | Self::Brake(fault) => Mode::BrakingFully(AfterBrake::Fault(fault)),
            Self::Finished => Mode::Idle,
        }
    }

    fn cause(self) -> Cause {
        match self {
            Self::Fault(_) => Cause::Fault,
            Self::Brake(_) => Cause::BrakeFully,
            Self::Finished => Cause::Finished,
        }
    }
}
