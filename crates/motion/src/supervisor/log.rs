use super::{Cause, Mode};
use arrayvec::ArrayVec;

/// A change of mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Event {
    /// Number of the sample, counted from 0.
    pub sample: u64,
    /// Mode left.
    pub from: Mode,
    /// Mode entered.
    pub to: Mode,
    /// Why.
    pub cause: Cause,
}

/// Events that are kept.
const CAPACITY: usize = 64;

/// The last 64 changes of mode; older ones are overwritten.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EventLog {
    events: ArrayVec<Event, CAPACITY>,
    /// The oldest event, once the log is full.
    oldest: usize,
}

impl EventLog {
    pub(super) fn record(&mut self, event: Event) {
        if self.events.try_push(event).is_ok() {
            return;
        }
        if let Some(slot) = self.events.get_mut(self.oldest) {
            *slot = event;
        }
        self.oldest = (self.oldest + 1) % CAPACITY;
    }

    /// The events, oldest first.
    pub fn iter(&self) -> impl Iterator<Item = &Event> {
        let (newer, older) = self.events.split_at(self.oldest);
        older.iter().chain(newer)
    }

    /// The last event.
    #[must_use]
    pub fn last(&self) -> Option<&Event> {
        self.iter().last()
    }
}
