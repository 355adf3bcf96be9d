//! Hypotheses of a statement about a speed law.

use super::entry::{ROOM, failing, shown_down, shown_up};
use super::speed::{SpeedCase, chattering};
use super::speed_words::{TIMES, words};
use super::{Hypothesis, Relation};

/// An entry with a value that has to be at most another.
fn at_most(name: &str, value: f64, needed: f64) -> Hypothesis {
    let words = words(name);
    Hypothesis {
        name: name.into(),
        claim: words.claim.into(),
        text: words.text.into(),
        value,
        relation: Relation::AtMost,
        needed,
        unit: words.unit.into(),
        remedy: None,
    }
}

fn at_least(name: &str, value: f64, needed: f64) -> Hypothesis {
    Hypothesis { relation: Relation::AtLeast, ..at_most(name, value, needed) }
}

impl SpeedCase {
    pub(crate) fn hypotheses(&self) -> Vec<Hypothesis> {
        let mut list = self.settings();
        if !self.implicit() {
            list.push(self.drift());
        }
        list.extend(self.bands());
        list.extend(self.motion());
        list
    }

    /// Hypotheses about the scenario's settings.
    fn settings(&self) -> Vec<Hypothesis> {
        let control = &self.looked.control;
        let period = control.sampling_period;
        let mut gain = at_most("gain-step", control.gain * period, 1.0);
        gain.remedy = failing(&gain, || format!("`control.gain`: at most {}", shown_down(1.0 / period)));
        let mut target = at_least("target-rate", control.target_rate, self.numbers.fastest_rate);
        target.remedy = failing(&target, || format!("`control.target_rate`: at least {}", shown_up(target.needed)));
        vec![gain, target]
    }

    /// Drift against filter.
    fn drift(&self) -> Hypothesis {
        let mut drift = at_least("drift-against-filter", self.numbers.filter_fall_rate, self.asked.fall_rate);
        drift.remedy = failing(&drift, || self.faster_filter());
        drift
    }

    /// The bandwidth at which the filter falls as fast as the limit: `a = 1 - exp(-rate Ts)`. A faster filter also widens the pace of
    /// the published advance a little, for which the room is added.
    fn faster_filter(&self) -> String {
        let period = self.looked.control.sampling_period;
        if !self.asked.fall_rate.is_finite() {
            return "no `control.bandwidth` is enough: the limit falls without bound where the path meets a singularity, or within one sample; \
                    lead the path around it, sample faster, or use `sliding-mode-implicit`"
                .to_owned();
        }
        let step = -(-self.asked.fall_rate * (1.0 + 0.5 * ROOM) * period).exp_m1();
        format!("`control.bandwidth`: at least {}", shown_up(step / period))
    }

    /// Hypotheses about the band and the changes of the demand.
    fn bands(&self) -> Vec<Hypothesis> {
        let (seen, stated, a) = (&self.nominal, &self.declared, self.looked.step());
        let mut list = if self.implicit() {
            vec![at_most("feedback-inside", seen.feedback, 1.0)]
        } else {
            vec![at_most("signal-band", seen.whole.band(a), stated.whole.band(a))]
        };
        let change = |signals| chattering(&self.looked, signals);
        list.push(at_most("signal-chattering", change(&seen.whole), change(&stated.whole)));
        if let (Some(seen), Some(stated)) = (&seen.settled, &stated.settled) {
            if !self.implicit() {
                list.push(at_most("signal-band-settled", seen.band(a), stated.band(a)));
            }
            list.push(at_most("signal-chattering-settled", change(seen), change(stated)));
        }
        list
    }

    /// Hypotheses on which the travel time depends.
    fn motion(&self) -> Vec<Hypothesis> {
        let (seen, stated) = (&self.nominal, &self.declared);
        let period = self.looked.control.sampling_period;
        let mut list = vec![
            at_most("feedback", seen.feedback, stated.feedback),
            at_most("pace", seen.sums.pace, stated.sums.pace),
            at_most("trail", seen.trail, stated.trail),
            at_most("settling", seen.contraction, stated.contraction),
        ];
        list.extend(TIMES.map(|(name, sum)| at_most(name, period * sum(&seen.sums), period * sum(&stated.sums))));
        list
    }
}
