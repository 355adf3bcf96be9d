//! Guarantees of a statement about a speed law.

use super::Guarantee;
use super::speed::{SpeedCase, asymmetry, chattering};
use super::speed_words::{TIMES, words};
use slideway_conditioner::bounds::{ProgressSums, TravelInputs, travel_bracket};
use slideway_lab::Method;

/// An entry with a greatest value.
fn up_to(name: &str, bound: f64, rests_on: &[&str], measured: Option<f64>) -> Guarantee {
    let words = words(name);
    Guarantee {
        name: name.into(),
        claim: words.claim.into(),
        text: words.text.into(),
        lower: None,
        upper: Some(bound),
        unit: words.unit.into(),
        rests_on: rests_on.iter().map(|&name| name.to_owned()).collect(),
        measured,
    }
}

fn between(name: &str, [lower, upper]: [f64; 2], rests_on: &[&str], measured: Option<f64>) -> Guarantee {
    Guarantee { lower: Some(lower), ..up_to(name, upper, rests_on, measured) }
}

impl SpeedCase {
    pub(crate) fn command(&self) -> Guarantee {
        up_to("command", 1.0, &[], Some(self.measures.command))
    }

    /// Rounding: command and change are rounded once each, claim `acceleration-box`.
    pub(crate) fn accelerations(&self) -> Option<Guarantee> {
        let limits = self.acceleration.as_ref()?;
        let period = self.looked.control.sampling_period;
        let share = |values: &[f64]| values.iter().zip(limits).map(|(v, limit)| v / limit).fold(0.0, f64::max);
        let speeds = self.looked.limits.upper().iter().zip(self.looked.limits.lower()).map(|(up, lo)| up.max(-lo));
        let rounding = speeds.zip(limits).map(|(v, limit)| 4.0 * f64::EPSILON * (1.0 + v / (limit * period)));
        let bound = 1.0 + rounding.fold(0.0, f64::max);
        Some(up_to("command-acceleration", bound, &[], Some(share(&self.peak_acceleration))))
    }

    /// The demand's use of the limits.
    pub(crate) fn demand(&self) -> Vec<Guarantee> {
        let (declared, measured, a) = (&self.declared, &self.measures, self.looked.step());
        if self.implicit() {
            let one = up_to("demand", 1.0 + self.implicit_rounding(), &["feedback-inside"], Some(measured.demand));
            return vec![Guarantee { claim: "implicit-band".into(), ..one }];
        }
        let (band, rest) = (declared.whole.band(a), ["signal-band", "signal-band-settled"]);
        // A last step cut short lies between A and the whole one: once settled A is inside the band anyway.
        let Some(settled) = &declared.settled else {
            let bound = band.max(declared.feedback);
            return vec![up_to("demand", bound, &["signal-band", "feedback"], Some(measured.demand))];
        };
        vec![
            up_to("demand", band.max(settled.feedback), &rest, Some(measured.demand)),
            up_to("demand-settled", settled.band(a), &rest[1..], measured.demand_settled),
        ]
    }

    /// Claim `implicit-band`: `e (2 + 3 (1 + κ))`, `e` half a unit in the last place of 1.
    fn implicit_rounding(&self) -> f64 {
        1.001 * 0.5 * f64::EPSILON * (2.0 + 3.0 * (1.0 + asymmetry(&self.looked)))
    }

    /// The demand's changes.
    pub(crate) fn changes(&self) -> Vec<Guarantee> {
        let (declared, measured) = (&self.declared, &self.measures);
        let whole = chattering(&self.looked, &declared.whole);
        let mut list = vec![up_to("chattering", whole, &["signal-chattering"], measured.chattering)];
        if let Some(settled) = &declared.settled {
            let bound = chattering(&self.looked, settled);
            let rest = ["signal-chattering-settled"];
            list.push(up_to("chattering-settled", bound, &rest, measured.chattering_settled));
        }
        if self.implicit() {
            list.iter_mut().for_each(|g| g.claim = "implicit-chattering".into());
        }
        list
    }

    /// Times of the reference and of the robot.
    pub(crate) fn times(&self) -> Vec<Guarantee> {
        let (declared, measured) = (&self.declared, &self.measures);
        let Some([lower, upper]) = self.bracket() else { return Vec::new() };
        // The end of the path lies within the last sample, where the synchronised form's rate is that of a step cut short, which the limits
        // may not hold back: the time is known to a sample.
        let synchronised = self.looked.method == Method::SlidingModeSynchronised;
        let lower = if synchronised { lower - self.looked.control.sampling_period } else { lower };
        let mut rests = vec!["target-rate", "pace"];
        let published = self.published();
        rests.extend(TIMES.iter().map(|(name, _)| *name).filter(|name| published || *name != "overrun-time"));
        let mut list = vec![between("reference-time", [lower, upper], &rests, measured.reference_s)];
        if declared.contraction < 1.0 {
            rests.extend(["trail", "settling"]);
            let samples = 2.0 + (declared.trail.ln() / -declared.contraction.ln()).ceil();
            let ends = [lower, upper + self.looked.control.sampling_period * samples];
            list.push(between("travel-time", ends, &rests, measured.travel_s));
            let optimum = self.numbers.optimum_s;
            let share = measured.travel_s.map(|t| t / optimum);
            list.push(between("time-over-optimum", ends.map(|t| t / optimum), &rests, share));
        }
        list
    }

    fn published(&self) -> bool {
        self.looked.method == Method::SlidingMode
    }

    /// Where the joints turn while the tool stands there is none.
    fn bracket(&self) -> Option<[f64; 2]> {
        let (sums, drift) = (self.declared.sums, &self.looked.drift);
        let period = self.looked.control.sampling_period;
        let inputs = TravelInputs {
            sums: ProgressSums { overrun: if self.published() { sums.overrun } else { 0.0 }, ..sums },
            optimum: self.optimum,
            period,
            variation: drift.variation(),
            sample_drift: drift.sample_drift(sums.pace, period),
        };
        travel_bracket(&inputs).filter(|_| !drift.breaks())
    }
}
