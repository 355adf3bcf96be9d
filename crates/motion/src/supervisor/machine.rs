use super::exits::{
    Exit, from_braking_fully, from_braking_on_path, from_fault, from_idle, from_motion, from_paused, from_recovery,
};
use super::{Cause, Event, EventLog, Mode, SegmentKind, Signals};

/// The state machine that decides what the arm's controller does.
///
/// One change of mode a sample at most, decided by the signals of the sample alone. Its mode can only be changed by the rules:
/// each mode has a type for its ways out, so that a change that does not exist cannot be written down.
///
/// Guaranteed, by exhaustive exploration of all modes and signals: in a moving mode a fault or a request to brake always leads
/// to a braking mode; a braking mode is only left for rest or for a harder brake; a fault is only left when it is no longer
/// present.
#[derive(Clone, Debug, PartialEq)]
pub struct Supervisor {
    mode: Mode,
    sample: u64,
    log: EventLog,
}

impl Default for Supervisor {
    fn default() -> Self {
        Self { mode: Mode::Idle, sample: 0, log: EventLog::default() }
    }
}

impl Supervisor {
    /// The mode.
    #[must_use]
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// The last changes of mode.
    #[must_use]
    pub fn log(&self) -> &EventLog {
        &self.log
    }

    /// One sample: the change of mode, if there is one.
    pub fn step(&mut self, signals: &Signals) -> Option<Event> {
        let event =
            next(self.mode, signals).map(|(to, cause)| Event { sample: self.sample, from: self.mode, to, cause });
        self.sample += 1;
        if let Some(event) = event {
            self.mode = event.to;
            self.log.record(event);
        }
        event
    }
}

/// The rules as one function of mode and signals.
pub(super) fn next(mode: Mode, signals: &Signals) -> Option<(Mode, Cause)> {
    fn out<E: Exit>(exit: Option<E>) -> Option<(Mode, Cause)> {
        exit.map(|e| (e.to(), e.cause()))
    }
    match mode {
        Mode::Idle => out(from_idle(signals)),
        Mode::JointMotion => out(from_motion(SegmentKind::Joint, signals)),
        Mode::ToolMotion => out(from_motion(SegmentKind::Tool, signals)),
        Mode::BrakingOnPath => out(from_braking_on_path(signals)),
        Mode::Paused => out(from_paused(signals)),
        Mode::BrakingFully(after) => out(from_braking_fully(after, signals)),
        Mode::Fault(fault) => out(from_fault(fault, signals)),
        Mode::Recovery(fault) => out(from_recovery(fault, signals)),
    }
}
