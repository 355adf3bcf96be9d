//! Ways out of the modes at rest.

use super::{Cause, Exit, moving};
use crate::supervisor::mode::{Fault, Mode, QueueState, SegmentKind, Signals};

/// Ways out of [`Mode::Idle`].
#[derive(Clone, Copy)]
pub(in crate::supervisor) enum FromIdle {
    Fault(Fault),
    Start(SegmentKind),
}

pub(in crate::supervisor) fn from_idle(signals: &Signals) -> Option<FromIdle> {
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

/// Ways out of [`Mode::Paused`].
#[derive(Clone, Copy)]
pub(in crate::supervisor) enum FromPaused {
    Fault(Fault),
    Discard,
    Resume(SegmentKind),
}

pub(in crate::supervisor) fn from_paused(signals: &Signals) -> Option<FromPaused> {
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

/// Ways out of [`Mode::Fault`].
#[derive(Clone, Copy)]
pub(in crate::supervisor) enum FromFault {
    Reset,
    Recover(Fault),
}

pub(in crate::supervisor) fn from_fault(fault: Fault, signals: &Signals) -> Option<FromFault> {
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
