//! A run of a speed law in the terms of its statement.

use super::observed::{Observed, Reading};
use super::signals::{Loop, SpeedMeasures, SpeedSignals};
use super::speed::chattering;
use super::speed_words::TIMES;
use slideway_conditioner::bounds::Signals;

/// Reads a run in the terms of the statement: its hypotheses and its guarantees, by name.
pub(crate) fn observed(signals: &SpeedSignals, measures: &SpeedMeasures, looked: &Loop) -> Observed {
    let a = looked.step();
    let mut hypotheses = vec![
        Reading { name: "feedback-inside", value: signals.feedback },
        Reading { name: "signal-band", value: signals.whole.band(a) },
        Reading { name: "signal-chattering", value: chattering(looked, &signals.whole) },
        Reading { name: "feedback", value: signals.feedback },
        Reading { name: "pace", value: signals.sums.pace },
        Reading { name: "trail", value: signals.trail },
        Reading { name: "settling", value: signals.contraction },
    ];
    let period = looked.control.sampling_period;
    hypotheses.extend(TIMES.iter().map(|(name, sum)| Reading { name, value: period * sum(&signals.sums) }));
    // A loop that never settles has no settled band.
    let settled = |of: fn(&Signals, &Loop) -> f64| signals.settled.as_ref().map_or(f64::INFINITY, |s| of(s, looked));
    hypotheses.push(Reading { name: "signal-band-settled", value: settled(|s, l| s.band(l.step())) });
    hypotheses.push(Reading { name: "signal-chattering-settled", value: settled(|s, l| chattering(l, s)) });
    let mut guarantees = vec![
        Reading { name: "command", value: measures.command },
        Reading { name: "demand", value: measures.demand },
        Reading { name: "reference-time", value: measures.reference_s.unwrap_or(f64::INFINITY) },
        Reading { name: "travel-time", value: measures.travel_s.unwrap_or(f64::INFINITY) },
        Reading {
            name: "time-over-optimum",
            value: measures.travel_s.map_or(f64::INFINITY, |t| t / looked.optimum[0]),
        },
    ];
    let optional = [
        ("demand-settled", measures.demand_settled),
        ("chattering", measures.chattering),
        ("chattering-settled", measures.chattering_settled),
    ];
    guarantees.extend(optional.into_iter().filter_map(|(name, value)| Some(Reading { name, value: value? })));
    Observed { hypotheses, guarantees }
}
