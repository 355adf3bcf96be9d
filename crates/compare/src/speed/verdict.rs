use crate::speed::entries::{ExcessEntry, MethodEntry};
use crate::speed::judged::{Judged, subject};
use crate::speed::obstacle::{LIMIT_SLACK, obstacle, reached_a_limit};
use crate::speed::whole::CertifiedFor;
use crate::words::{fixed, short};
use serde::Serialize;
use slideway_lab::{ARRIVAL_ORIENTATION, ARRIVAL_POSITION, Method};
use slideway_path::{LimitKind, PositionSource};

/// A verdict on speed: does the judged method match the optimum?
#[derive(Clone, Debug, Serialize)]
pub struct SpeedVerdict {
    /// The method judged.
    pub method: Method,
    /// From the start of motion to the robot's arrival, over the optimum.
    pub ratio: Option<f64>,
    /// The least that the ratio can be: over the optimum's upper bound.
    pub ratio_lower: Option<f64>,
    /// The most that the ratio can be: over the optimum's lower bound; null where that is 0.
    pub ratio_upper: Option<f64>,
    /// By how much the ratio may differ from 1.
    pub tolerance: f64,
    /// Whether the bounds of the optimum decide it, and how.
    pub status: VerdictStatus,
    /// Whether it holds.
    pub holds: bool,
    /// The verdict in words.
    pub sentence: String,
}

/// A verdict with bounds in place of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum VerdictStatus {
    /// It holds with either bound of the optimum.
    Holds,
    /// It fails with every time between the bounds.
    Fails,
    /// It depends on where between its bounds the optimum is.
    Open,
}

impl VerdictStatus {
    /// Whether a ratio between two bounds is within a tolerance of 1. NaN is not.
    fn of([lower, upper]: [f64; 2], tolerance: f64) -> Self {
        let near = |ratio: f64| (ratio - 1.0).abs() <= tolerance;
        if near(lower) && near(upper) {
            Self::Holds
        } else if lower <= 1.0 + tolerance && upper >= 1.0 - tolerance {
            Self::Open
        } else {
            Self::Fails
        }
    }
}

impl SpeedVerdict {
    /// The verdict about a method, from its run if there is one.
    pub(crate) fn new(method: Method, tolerance: f64, judged: Option<&Judged<'_>>) -> Self {
        let fails = |sentence: String| Self {
            method,
            ratio: None,
            ratio_lower: None,
            ratio_upper: None,
            tolerance,
            status: VerdictStatus::Fails,
            holds: false,
            sentence,
        };
        let Some(judged) = judged else {
            return fails(format!("No: the {} was not run.", subject(method)));
        };
        let fails = |sentence: String| {
            let MethodEntry { ratio, ratio_range, .. } = *judged.entry;
            let [ratio_lower, ratio_upper] = [0, 1].map(|end| ratio_range.map(|range| range[end]));
            Self { ratio, ratio_lower, ratio_upper, ..fails(sentence) }
        };
        let (ratio, range) = match (obstacle(judged), judged.entry.ratio, judged.entry.ratio_range) {
            (Some(reason), ..) => return fails(format!("No: {reason}.")),
            (None, Some(ratio), Some(range)) => (ratio, range),
            (None, ..) => return fails("No: there is nothing to compare.".into()),
        };
        let status = VerdictStatus::of(range, tolerance);
        let sentence = Comparison { judged: *judged, ratio, range, status }.sentence();
        Self { status, holds: status == VerdictStatus::Holds, ..fails(sentence) }
    }

    /// The same verdict, unless the path leaves position ranges that the scenario gives: then no time counts.
    pub(crate) fn under_position_limits(self, excesses: &[ExcessEntry]) -> Self {
        match excesses.iter().find(|excess| excess.source == PositionSource::Scenario) {
            None => self,
            Some(excess) => {
                let sentence = format!("No: {}.", excess.in_words());
                Self { holds: false, status: VerdictStatus::Fails, sentence, ..self }
            }
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
    range: [f64; 2],
    status: VerdictStatus,
}

impl Comparison<'_> {
    fn sentence(&self) -> String {
        let Judged { entry, optimum, tolerance, .. } = self.judged;
        let [travel, best] = fixed([entry.travel_s.unwrap_or(f64::NAN), optimum.duration_s], 4);
        let name = subject(entry.summary.method);
        let head = match self.status {
            VerdictStatus::Holds => format!("Yes: the {name}, {}, needs {travel} s", knowing(entry)),
            VerdictStatus::Fails => format!("No: the {name} needs {travel} s"),
            VerdictStatus::Open => format!("Open: the {name} needs {travel} s"),
        };
        format!(
            "{head} where the {}: {} (tolerance {} %).{}{}{}{}",
            optimum.in_words(&best),
            self.apart(),
            100.0 * tolerance,
            self.open(),
            self.less(),
            self.trailing(),
            self.idle()
        )
    }

    /// What an open verdict lacks.
    fn open(&self) -> String {
        if self.status != VerdictStatus::Open {
            return String::new();
        }
        let [lower, upper] = self.range;
        let narrower = match self.judged.optimum.certified_for {
            CertifiedFor::Nodes => "raise `optimum.grid_points`",
            CertifiedFor::Path | CertifiedFor::Spline => "ask for a smaller `optimum.gap` with more `optimum.cells`",
        };
        format!(
            " The bounds of the optimum leave the ratio between {lower:.6} and {upper:.6}, with the tolerance's edge between: \
             {narrower}, or change `compare.tolerance`."
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
            d if d >= 0.0 => format!("{} % slower", self.beside_tolerance(d)),
            d => format!("{} % less", self.beside_tolerance(-d)),
        }
    }

    /// A difference in per cent that reads as the tolerance only where it is the tolerance.
    fn beside_tolerance(&self, difference: f64) -> String {
        let [difference, _] = fixed([difference, 100.0 * self.judged.tolerance], 2);
        difference
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
        } else if let Some((distance, turn)) = self.begun_off() {
            format!(
                "its robot began {} mm and {} mrad off the path, where the optimum's begins on it",
                short(1e3 * distance),
                short(1e3 * turn)
            )
        } else if distance > ARRIVAL_POSITION || turn > ARRIVAL_ORIENTATION {
            format!(
                "its tool was up to {} mm and {} mrad from its reference, lag included, where the optimum's is on the path",
                short(1e3 * distance),
                short(1e3 * turn)
            )
        } else {
            self.beyond_a_limit().unwrap_or_else(|| match optimum.certified_for {
                CertifiedFor::Path | CertifiedFor::Spline => "it keeps every limit, as far as it was sampled".into(),
                CertifiedFor::Nodes => {
                    let grid = &optimum.on_grid;
                    let [time, refined] = fixed([optimum.duration_s, grid.refined_s], 6);
                    format!(
                        "it keeps every limit, and the optimum is as exact as its grid of {} points: {time} s, and {refined} s on one twice as fine",
                        grid.grid_points
                    )
                }
            })
        };
        format!(" It did not beat the optimum: {cause}.")
    }

    /// How far off the path the robot was when the reference began to move, m and rad, where that is the most it ever was.
    fn begun_off(&self) -> Option<(f64, f64)> {
        let Judged { entry, trace, .. } = self.judged;
        let norm = |part: &[f64]| part.iter().map(|e| e * e).sum::<f64>().sqrt();
        let first = trace.following().iter().find(|sample| sample.path_rate > 0.0)?;
        let (distance, turn) = (norm(&first.error[..3]), norm(&first.error[3..]));
        let most = (entry.summary.peak_path_error_m, entry.summary.peak_path_error_rad);
        let off = distance > ARRIVAL_POSITION && distance >= most.0 || turn > ARRIVAL_ORIENTATION && turn >= most.1;
        off.then_some((distance, turn))
    }

    /// The limit that is exceeded most, within what counts as kept.
    fn beyond_a_limit(&self) -> Option<String> {
        let entry = self.judged.entry;
        let uses = entry.limit_use.iter().map(|u| (u.kind, u.share));
        let (kind, share) =
            uses.chain([(LimitKind::JointSpeed, entry.command_use)]).max_by(|a, b| a.1.total_cmp(&b.1))?;
        (share > 1.0).then(|| {
            let (excess, counts) = (short(100.0 * (share - 1.0)), 100.0 * LIMIT_SLACK);
            format!("it exceeds the limits on {kind} by {excess} %, and up to {counts} % counts as kept")
        })
    }

    /// The reference's end and the robot's arrival, where they differ by more than a sample.
    fn trailing(&self) -> String {
        let summary = &self.judged.entry.summary;
        match (summary.duration_s, summary.robot_arrival_s) {
            (Some(end), Some(arrival)) if arrival - end > self.judged.trace.sampling_period => {
                let [end, arrival] = fixed([end, arrival], 4);
                format!(
                    " The reference finished at {end} s while the robot still trailed; the robot arrived at {arrival} s."
                )
            }
            _ => String::new(),
        }
    }

    /// A target rate that never reaches the limits leaves a regulated method nothing to regulate.
    fn idle(&self) -> String {
        let Judged { entry, trace, .. } = self.judged;
        if self.status == VerdictStatus::Holds || !entry.summary.method.is_regulated() || reached_a_limit(entry, trace)
        {
            String::new()
        } else {
            " The limits were never reached: raise `control.target_rate`.".into()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_bounds_that_agree_decide_a_verdict() {
        let of = |lower, upper| VerdictStatus::of([lower, upper], 0.02);
        assert_eq!([of(1.0, 1.01), of(0.99, 1.019)], [VerdictStatus::Holds; 2]);
        assert_eq!([of(1.03, 1.04), of(0.9, 0.97)], [VerdictStatus::Fails; 2]);
        assert_eq!([of(1.01, 1.03), of(0.97, 1.01), of(0.9, 1.1), of(1.0, f64::INFINITY)], [VerdictStatus::Open; 4]);
        assert_eq!(of(f64::NAN, f64::NAN), VerdictStatus::Fails);
    }
}
