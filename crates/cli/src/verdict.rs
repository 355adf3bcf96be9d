use crate::summary::{MethodEntry, OptimumEntry, excess_in_words};
use serde::Serialize;
use slideway_lab::{Method, PositionExcess, PositionSource, Trace};

/// Whether the sliding mode matches the optimum.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Verdict {
    /// The method judged.
    pub(crate) method: Method,
    /// From the start of motion to the robot's arrival, over the optimum.
    pub(crate) ratio: Option<f64>,
    /// By how much the ratio may differ from 1.
    pub(crate) tolerance: f64,
    /// Whether it holds.
    pub(crate) holds: bool,
    /// The verdict in words.
    pub(crate) sentence: String,
}

/// By how much a limit, measured from whole samples, may be exceeded before the times count as not comparable.
const LIMIT_SLACK: f64 = 0.01;

impl Verdict {
    pub(crate) fn new(
        method: Method,
        methods: &[MethodEntry],
        traces: &[Trace],
        optimum: &OptimumEntry,
        tolerance: f64,
    ) -> Self {
        let entry = methods.iter().find(|m| m.summary.method == method);
        let trace = traces.iter().find(|t| t.method == method);
        let ratio = entry.and_then(|e| e.ratio);
        let reason =
            entry.map_or(Some("the sliding mode was not run".to_owned()), |entry| obstacle(entry, trace, optimum));
        let near = ratio.is_some_and(|r| (r - 1.0).abs() <= tolerance);
        let holds = reason.is_none() && near;
        let sentence = match (reason, entry, ratio) {
            (Some(reason), ..) => format!("No: {reason}."),
            (None, Some(entry), Some(ratio)) => {
                let state = Comparison { entry, trace, ratio, optimum, tolerance, holds };
                state.sentence()
            }
            _ => "No: there is nothing to compare.".into(),
        };
        Self { method, ratio, tolerance, holds, sentence }
    }

    /// The same verdict, unless the path leaves position ranges that the scenario gives: then no time counts.
    pub(crate) fn under_position_limits(self, excesses: &[PositionExcess]) -> Self {
        match excesses.iter().find(|excess| excess.source == PositionSource::Scenario) {
            None => self,
            Some(excess) => Self { holds: false, sentence: format!("No: {}.", excess_in_words(excess)), ..self },
        }
    }
}

/// What keeps the two times from being compared at all.
fn obstacle(entry: &MethodEntry, trace: Option<&Trace>, optimum: &OptimumEntry) -> Option<String> {
    if !optimum.certified {
        return Some(format!("the optimum is not certified, its bounds are {:.1e} apart", optimum.gap));
    }
    if entry.summary.motion_start_s.is_none() {
        return Some("the reference never moved: the position error alone used up the speed limits".into());
    }
    if !entry.summary.completed {
        let reached = trace.and_then(|t| t.samples.last()).map_or(0.0, |s| s.lambda);
        return Some(format!("the reference did not reach the path's end, it stopped at path parameter {reached:.4}"));
    }
    if entry.travel_s.is_none() {
        return Some("the robot never came within 0.1 mm and 1 mrad of the path's end".into());
    }
    let worst = entry.limit_use.iter().max_by(|a, b| a.share.total_cmp(&b.share))?;
    (!(worst.share <= 1.0 + LIMIT_SLACK)).then(|| {
        format!(
            "the optimum keeps the limits on {kind} and the {name}, which does not know them, exceeds them \
             {:.1} times; its time is not comparable (see the optimum under speed limits alone)",
            worst.share,
            kind = worst.kind,
            name = subject(entry.summary.method)
        )
    })
}

/// The judged method in words.
fn subject(method: Method) -> String {
    match method {
        Method::AccelerationLookAhead => "look-ahead".into(),
        Method::SlidingMode => "sliding mode".into(),
        Method::SlidingModeSynchronised => "synchronised sliding mode".into(),
        Method::SlidingModeImplicit => "implicit sliding mode".into(),
        other => format!("method `{other}`"),
    }
}

/// Two comparable times.
struct Comparison<'a> {
    entry: &'a MethodEntry,
    trace: Option<&'a Trace>,
    ratio: f64,
    optimum: &'a OptimumEntry,
    tolerance: f64,
    holds: bool,
}

impl Comparison<'_> {
    fn sentence(&self) -> String {
        let Self { entry, ratio, optimum, .. } = self;
        let travel = entry.travel_s.unwrap_or(f64::NAN);
        let difference = 100.0 * (ratio - 1.0);
        let name = subject(entry.summary.method);
        let knows = if entry.summary.samples_off_path.is_some() { entry.knows } else { "nothing" };
        let mut text = if self.holds {
            format!("Yes: the {name}, knowing {knows} in advance, needs {travel:.4} s")
        } else {
            format!("No: the {name} needs {travel:.4} s")
        };
        let apart = match difference {
            d if d >= 100.0 => format!("{ratio:.1} times as long"),
            d if d >= 0.0 => format!("{d:.2} % slower"),
            d => format!("{:.2} % less", -d),
        };
        text += &format!(
            " where the certified optimum, knowing the whole path, is {:.4} s: {apart} (tolerance {} %).",
            optimum.duration_s,
            100.0 * self.tolerance
        );
        if *ratio < 1.0 {
            text += &format!(
                " It did not beat the optimum: it left the path by up to {:.3} mm, which the optimum may not.",
                1e3 * entry.summary.peak_path_error_m
            );
        }
        text + &self.trailing() + &self.idle()
    }

    /// The reference's end and the robot's arrival, where they differ by more than a sample.
    fn trailing(&self) -> String {
        let summary = &self.entry.summary;
        let period = self.trace.map_or(0.0, |t| t.sampling_period);
        match (summary.duration_s, summary.robot_arrival_s) {
            (Some(end), Some(arrival)) if arrival - end > period => format!(
                " The reference finished at {end:.4} s while the robot still trailed; the robot arrived at {arrival:.4} s."
            ),
            _ => String::new(),
        }
    }

    /// A target rate that never reaches the limits leaves nothing to regulate.
    fn idle(&self) -> String {
        let acted = self.trace.is_some_and(|t| t.following().iter().any(|s| s.switch < 1.0));
        if acted || self.holds {
            String::new()
        } else {
            " The limits were never reached: raise `control.target_rate`.".into()
        }
    }
}
