//! The ways out of each mode, a type per mode: a rule for one mode cannot name a way out of another.
//!
//! The order of the rules is the tie-break: faults first, then the harder brake, then the softer, then what the queue did, then
//! requests. In a mode at rest requests that keep it there come first.

use super::mode::{AfterBrake, Fault, Mode, QueueState, SegmentKind, Signals};

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

/// Ways out of [`Mode::Idle`].
#[derive(Clone, Copy)]
pub(super) enum FromIdle {
    Fault(Fault),
    Start(SegmentKind),
}

pub(super) fn from_idle(signals: &Signals) -> Option<FromIdle> {
    if let Some(fault) = signals.inputs.fault {
        return Some(FromIdle::Fault(fault));
    }
    match signals.queue {
        // A brake that is asked for at rest forbids to start.
        QueueState::Ready(kind)
            if signals.inputs.start && !signals.inputs.brake_fully && !signals.inputs.brake_on_path =>
        {
            Some(FromIdle::Start(kind))
        }
        QueueState::Ready(_) | QueueState::Paused(_) | QueueState::Resting => None,
    }
}

impl Exit for FromIdle {
    fn to(self) -> Mode {
        match self {
            Self::Fault(fault) => Mode::Fault(fault),
            Self::Start(kind) => moving(kind),
        }
    }

    fn cause(self) -> Cause {
        match self {
            Self::Fault(_) => Cause::Fault,
            Self::Start(_) => Cause::Start,
        }
    }
}

/// Ways out of [`Mode::JointMotion`] and [`Mode::ToolMotion`].
#[derive(Clone, Copy)]
pub(super) enum FromMotion {
    Fault(Fault),
    BrakeFully,
    BrakeOnPath,
    Finished,
    Paused,
    NextSegment(SegmentKind),
}

pub(super) fn from_motion(kind: SegmentKind, signals: &Signals) -> Option<FromMotion> {
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
pub(super) enum FromBrakingOnPath {
    Fault(Fault),
    BrakeFully,
    Overdue,
    Paused,
    Finished,
}

pub(super) fn from_braking_on_path(signals: &Signals) -> Option<FromBrakingOnPath> {
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

/// Ways out of [`Mode::Paused`].
#[derive(Clone, Copy)]
pub(super) enum FromPaused {
    Fault(Fault),
    Discard,
    Resume(SegmentKind),
}

pub(super) fn from_paused(signals: &Signals) -> Option<FromPaused> {
    if let Some(fault) = signals.inputs.fault {
        return Some(FromPaused::Fault(fault));
    }
    match signals.queue {
        // Nothing left to go on with.
        QueueState::Resting => Some(FromPaused::Discard),
        _ if signals.inputs.discard => Some(FromPaused::Discard),
        QueueState::Ready(kind) | QueueState::Paused(kind) => {
            let braked = signals.inputs.brake_fully || signals.inputs.brake_on_path;
            (signals.inputs.resume && !braked).then_some(FromPaused::Resume(kind))
        }
    }
}

impl Exit for FromPaused {
    fn to(self) -> Mode {
        match self {
            Self::Fault(fault) => Mode::Fault(fault),
            Self::Discard => Mode::Idle,
            Self::Resume(kind) => moving(kind),
        }
    }

    fn cause(self) -> Cause {
        match self {
            Self::Fault(_) => Cause::Fault,
            Self::Discard => Cause::Discard,
            Self::Resume(_) => Cause::Resume,
        }
    }
}

/// Ways out of [`Mode::BrakingFully`].
#[derive(Clone, Copy)]
pub(super) enum FromBrakingFully {
    /// The first fault of a brake decides where it leads.
    Fault(Fault),
    Rest(AfterBrake),
}

pub(super) fn from_braking_fully(after: AfterBrake, signals: &Signals) -> Option<FromBrakingFully> {
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

/// Ways out of [`Mode::Fault`].
#[derive(Clone, Copy)]
pub(super) enum FromFault {
    Reset,
    Recover(Fault),
}

pub(super) fn from_fault(fault: Fault, signals: &Signals) -> Option<FromFault> {
    if signals.inputs.fault.is_some() || signals.inputs.brake_fully || signals.inputs.brake_on_path {
        return None;
    }
    match signals.queue {
        _ if signals.inputs.reset => Some(FromFault::Reset),
        QueueState::Ready(SegmentKind::Joint) if signals.inputs.recover => Some(FromFault::Recover(fault)),
        QueueState::Ready(_) | QueueState::Paused(_) | QueueState::Resting => None,
    }
}

impl Exit for FromFault {
    fn to(self) -> Mode {
        match self {
            Self::Reset => Mode::Idle,
            Self::Recover(fault) => Mode::Recovery(fault),
        }
    }

    fn cause(self) -> Cause {
        match self {
            Self::Reset => Cause::Reset,
            Self::Recover(_) => Cause::Recover,
        }
    }
}

/// Ways out of [`Mode::Recovery`]: a recovery that is broken off leads back to its fault, or to a newer one.
#[derive(Clone, Copy)]
pub(super) enum FromRecovery {
    Fault(Fault),
    Brake(Fault),
    Finished,
}

pub(super) fn from_recovery(fault: Fault, signals: &Signals) -> Option<FromRecovery> {
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
