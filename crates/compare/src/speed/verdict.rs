use crate::speed::entries::{ExcessEntry, MethodEntry};
use crate::speed::judged::{Judged, subject};
use crate::speed::obstacle::{LIMIT_SLACK, obstacle, reached_a_limit};
use crate::words::short;
use serde::Serialize;
use slideway_lab::{ARRIVAL_ORIENTATION, ARRIVAL_POSITION, Method};
use slideway_path::PositionSource;

/// A verdict on speed: does the judged method match the optimum?
#[derive(Clone, Debug, Serialize)]
pub struct SpeedVerdict {
    /// The method judged.
    pub method: Method,
    /// From the start of motion to the robot's arrival, over the optimum.
    pub ratio: Option<f64>,
    /// By how much the ratio may differ from 1.
    pub tolerance: f64,
    /// Whether it holds.
    pub holds: bool,
    /// The verdict in words.
    pub sentence: String,
}

impl SpeedVerdict {
    /// The verdict about a method, from its run if there is one.
    pub(crate) fn new(method: Method, tolerance: f64, judged: Option<&Judged<'_>>) -> Self {
        let Some(judged) = judged else {
            let sentence = format!("No: the {} was not run.", subject(method));
            return Self { method, ratio: None, tolerance, holds: false, sentence };
        };
        let ratio = judged.entry.ratio;
        let near = ratio.is_some_and(|r| (r - 1.0).abs() <= tolerance);
        let reason = obstacle(judged);
        let holds = reason.is_none() && near;
        let sentence = match (reason, ratio) {
            (Some(reason), _) => format!("No: {reason}."),
            (None, Some(ratio)) => Comparison { judged: *judged, ratio, holds }.sentence(),
            (None, None) => "No: there is nothing to compare.".into(),
        };
        Self { method, ratio, tolerance, holds, sentence }
    }

    /// The same verdict, unless the path leaves position ranges that the scenario gives: then no time counts.
    pub(crate) fn under_position_limits(self, excesses: &[ExcessEntry]) -> Self {
        match excesses.iter().find(|excess| excess.source == PositionSource::Scenario) {
            None => self,
            Some(excess) => Self { holds: false, sentence: format!("No: {}.", excess.in_words()), ..self },
        }
    }
}

/// What the method goes by, in words.
fn knowing(entry: &MethodEntry) -> String {
    match entry.summary.method {
        Method::Ideal | Method::Saturated | Method::DirectionPreserving => "run at a speed fixed beforehand".into(),
        method if method.surveys_the_path() || method.limits_acceleration() => {
            format!("knowing {} in advance", entry.knows)
        }
        _ => "knowing nothing in advance".into(),
    }
}

/// Two comparable times.
struct Comparison<'a> {
    judged: Judged<'a>,
    ratio: f64,
    holds: bool,
}

impl Comparison<'_> {
    fn sentence(&self) -> String {
        let Judged { entry, optimum, tolerance, .. } = self.judged;
        let travel = entry.travel_s.unwrap_or(f64::NAN);
        let name = subject(entry.summary.method);
        let head = if self.holds {
            format!("Yes: the {name}, {}, needs {travel:.4} s", knowing(entry))
        } else {
            format!("No: the {name} needs {travel:.4} s")
        };
        format!(
            "{head} where the certified optimum, knowing the whole path, is {:.4} s: {} (tolerance {} %).{}{}{}",
            optimum.duration_s,
            self.apart(),
            100.0 * tolerance,
            self.less(),
            self.trailing(),
            self.idle()
        )
    }

    /// Whether the method's time is less than the optimum's by no more than a sample. The reference's end is extrapolated within its
    /// last sample with the path rate before that was cut to what was left, so less than a sample says nothing.
    fn unresolved(&self) -> bool {
        let missing = self.judged.optimum.duration_s - self.judged.entry.travel_s.unwrap_or(f64::NAN);
        self.ratio < 1.0 && missing < self.judged.trace.sampling_period
    }

    fn apart(&self) -> String {
        match 100.0 * (self.ratio - 1.0) {
            _ if self.unresolved() => format!(
                "within a sample of the optimum ({} s), and times are resolved no finer",
                self.judged.trace.sampling_period
            ),
            d if d >= 100.0 => format!("{:.1} times as long", self.ratio),
            d if d >= 0.0 => format!("{d:.2} % slower"),
            d => format!("{:.2} % less", -d),
        }
    }

    /// Why a time below the optimum's is none that the optimum could have.
    fn less(&self) -> String {
        let Judged { entry, optimum, disturbances, .. } = self.judged;
        if !(self.ratio < 1.0) || self.unresolved() {
            return String::new();
        }
        let (distance, turn) = (entry.summary.peak_path_error_m, entry.summary.peak_path_error_rad);
        // The methods that survey the path run undisturbed.
        let disturbed = !disturbances.are_none() && !entry.summary.method.surveys_the_path();
        let cause = if disturbed {
            format!("the run is disturbed ({disturbances}), the optimum is not")
        } else if distance > ARRIVAL_POSITION || turn > ARRIVAL_ORIENTATION {
            format!(
                "its tool was up to {} mm and {} mrad from its reference, lag included, where the optimum's is on the path",
                short(1e3 * distance),
                short(1e3 * turn)
            )
        } else {
            format!(
                "a method's use of a limit counts to {} %, and the optimum is as exact as its grid of {} points",
                100.0 * LIMIT_SLACK,
                optimum.grid_points
            )
        };
        format!(" It did not beat the optimum: {cause}.")
    }

    /// The reference's end and the robot's arrival, where they differ by more than a sample.
    fn trailing(&self) -> String {
        let summary = &self.judged.entry.summary;
        match (summary.duration_s, summary.robot_arrival_s) {
            (Some(end), Some(arrival)) if arrival - end > self.judged.trace.sampling_period => format!(
                " The reference finished at {end:.4} s while the robot still trailed; the robot arrived at {arrival:.4} s."
            ),
            _ => String::new(),
        }
    }

    /// A target rate that never reaches the limits leaves a regulated method nothing to regulate.
    fn idle(&self) -> String {
        let Judged { entry, trace, .. } = self.judged;
        if self.holds || !entry.summary.method.is_regulated() || reached_a_limit(entry, trace) {
            String::new()
        } else {
            " The limits were never reached: raise `control.target_rate`.".into()
        }
    }
}
