//! Signals that the bounds of a speed law are stated for.

use super::entry::room;
use super::path_drift::Asked;
use super::signals::{Loop, SpeedSignals};
use slideway_conditioner::bounds::{ProgressSums, Signals};

/// The signals of the run without disturbances, with room, and never less than what the path asks of any run.
pub(crate) fn declared(nominal: &SpeedSignals, looked: &Loop, asked: &Asked) -> SpeedSignals {
    let gain_step = looked.control.gain * looked.control.sampling_period;
    let surplus = if asked.surplus.is_finite() { asked.surplus } else { 0.0 };
    SpeedSignals {
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
