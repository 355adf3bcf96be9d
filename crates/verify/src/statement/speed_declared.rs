//! What the bounds about a speed law are stated for.

use super::entry::room;
use super::path_drift::Asked;
use super::signals::{Loop, SpeedSignals};
use slideway_conditioner::bounds::{ProgressSums, Signals};

/// What the bounds are stated for: the nominal numbers with room.
pub(crate) struct Declared {
    pub(crate) whole: Signals,
    pub(crate) settled: Option<Signals>,
    pub(crate) feedback: f64,
    pub(crate) sums: ProgressSums,
    pub(crate) trail: f64,
    pub(crate) contraction: f64,
}

fn with_room(signals: &Signals, surplus: f64) -> Signals {
    Signals {
        feedback: room(signals.feedback),
        overspeed: room(signals.overspeed),
        rise: room(signals.rise),
        surplus: room(signals.surplus.max(surplus)),
        released_change: room(signals.released_change),
        braked_change: room(signals.braked_change),
        demand_change: room(signals.demand_change),
        start: signals.start,
    }
}

impl Declared {
    pub(crate) fn new(nominal: &SpeedSignals, looked: &Loop, asked: &Asked) -> Self {
        let period = looked.control.sampling_period;
        let gain_step = looked.control.gain * period;
        let surplus = if asked.surplus.is_finite() { asked.surplus } else { 0.0 };
        Self {
            whole: with_room(&nominal.whole, surplus),
            settled: nominal.settled.as_ref().map(|s| with_room(s, surplus)),
            feedback: room(nominal.feedback),
            sums: ProgressSums {
                feedback: room(nominal.sums.feedback),
                overrun: room(nominal.sums.overrun),
                shift: room(nominal.sums.shift),
                held_back: room(nominal.sums.held_back) + 2.0,
                pace: room(nominal.sums.pace),
            },
            trail: room(nominal.trail).max(1.0),
            contraction: (1.0 - 0.5 * gain_step).max(0.5 * (1.0 + nominal.contraction)),
        }
    }
}
