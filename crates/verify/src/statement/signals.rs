//! Readings of one run of a speed law: the signals that the claims set conditions on, and the quantities that they bound.

use super::path_drift::PathDrift;
use slideway_conditioner::SpeedLimits;
use slideway_conditioner::bounds::{Progress, ProgressForm, ProgressSums, SignalBand, Signals};
use slideway_lab::{ControlSettings, MAX_JOINTS, Method, MethodSummary, Sample, Trace};
use slideway_path::SampledPath;

/// Below this use of the limits the feedback counts as settled.
pub(crate) const SETTLED: f64 = 0.05;

/// Signals of a run that the hypotheses are about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SpeedSignals {
    /// From the first released sample on.
    pub(crate) whole: Signals,
    /// From the first released sample after which the feedback uses at most [`SETTLED`]; `None` if it never settles.
    pub(crate) settled: Option<Signals>,
    /// `E` while the reference moves.
    pub(crate) feedback: f64,
    /// Sums on which the travel time depends, over the samples in which the reference moves.
    pub(crate) sums: ProgressSums,
    /// Distance from the path's end once the reference is there, in tolerances of arrival.
    pub(crate) trail: f64,
    /// Largest ratio of that distance to the one a sample before, while the robot settles.
    pub(crate) contraction: f64,
}

/// Measured values of the quantities that the guarantees bound, from one run. `None` where there was nothing to measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SpeedMeasures {
    /// Largest use of a limit by the commanded speed.
    pub(crate) command: f64,
    /// Largest use of a limit by the demand while the reference moves.
    pub(crate) demand: f64,
    /// The same from the settled sample on.
    pub(crate) demand_settled: Option<f64>,
    /// Largest change of a desired speed over a sample, in limits.
    pub(crate) chattering: Option<f64>,
    /// The same from the settled sample on.
    pub(crate) chattering_settled: Option<f64>,
    /// From the start of motion to the reference's end, s.
    pub(crate) reference_s: Option<f64>,
    /// From the start of motion to the robot's arrival, s.
    pub(crate) travel_s: Option<f64>,
}

/// The loop a run is judged in.
#[derive(Clone, Debug)]
pub(crate) struct Loop {
    pub(crate) method: Method,
    pub(crate) control: ControlSettings,
    pub(crate) limits: SpeedLimits<MAX_JOINTS>,
    pub(crate) drift: PathDrift,
    /// Certified optimum under the speed limits alone, s: the profile's time, and its bounds.
    pub(crate) optimum: [f64; 3],
    /// True if arrival is judged by the joints.
    pub(crate) by_joints: bool,
}

impl Loop {
    /// Speed limits padded with joints that never move.
    pub(crate) fn limits(path: &SampledPath) -> Option<SpeedLimits<MAX_JOINTS>> {
        let pad = |given: &[f64], rest: f64| std::array::from_fn(|i| given.get(i).copied().unwrap_or(rest));
        SpeedLimits::new(pad(&path.speed_lower, -1.0), pad(&path.speed_upper, 1.0)).ok()
    }

    pub(crate) fn step(&self) -> f64 {
        self.control.filter_step()
    }

    /// Largest share of the smaller limits.
    pub(crate) fn narrow(&self, v: &[f64; MAX_JOINTS]) -> f64 {
        let ends = self.limits.lower().iter().zip(self.limits.upper());
        let shares = v.iter().zip(ends).map(|(v, (lo, up))| v.abs() / up.min(-lo));
        shares.fold(0.0, |a, b| if b.is_nan() { f64::INFINITY } else { a.max(b) })
    }

    /// Looks at a run.
    pub(crate) fn signals(&self, trace: &Trace) -> SpeedSignals {
        let moving = moving(trace);
        let settled = self.settled_from(moving);
        let band = |samples: &[Sample]| {
            let mut band = SignalBand::new(self.step());
            for s in samples {
                band.update(&self.limits, &s.split, s.factor, s.switch);
            }
            band.signals()
        };
        let feedback = |s: &Sample| self.narrow(&s.split.feedback);
        let (trail, contraction) = self.settling(trace);
        SpeedSignals {
            whole: band(trace.following()),
            settled: settled.map(|from| band(&moving[from..])),
            feedback: moving.iter().map(feedback).fold(0.0, f64::max),
            sums: self.progress(moving),
            trail,
            contraction,
        }
    }

    /// Measures a run.
    pub(crate) fn measures(&self, trace: &Trace) -> SpeedMeasures {
        let summary = MethodSummary::new(trace);
        let moving = moving(trace);
        let settled = self.settled_from(moving).map(|from| &moving[from..]);
        let peak = |samples: &[Sample]| samples.iter().map(|s| s.limit_ratio).fold(0.0, f64::max);
        let change = |samples: &[Sample]| {
            samples.iter().skip(1).filter_map(|s| s.chatter).map(|c| c.measured).fold(0.0, f64::max)
        };
        SpeedMeasures {
            command: trace.samples.iter().map(|s| self.limits.ratio(&s.commanded)).fold(0.0, f64::max),
            demand: summary.limit_ratio_peak,
            demand_settled: settled.map(peak),
            chattering: summary.chattering.map(|c| c.measured),
            chattering_settled: settled.map(change),
            reference_s: summary.duration_s.zip(summary.motion_start_s).map(|(end, start)| end - start),
            travel_s: summary.travel_s(),
        }
    }

    /// Index of the first released sample after which the feedback uses at most [`SETTLED`].
    fn settled_from(&self, moving: &[Sample]) -> Option<usize> {
        let last = moving.iter().rposition(|s| !(self.narrow(&s.split.feedback) <= SETTLED));
        let from = last.map_or(0, |last| last + 1);
        // The implicit form is inside the limits at every sample: any will do.
        let implicit = self.method == Method::SlidingModeImplicit;
        moving[from..].iter().position(|s| implicit || s.switch >= 1.0).map(|k| from + k)
    }

    fn progress(&self, moving: &[Sample]) -> ProgressSums {
        let implicit = self.method == Method::SlidingModeImplicit;
        let form = if implicit { ProgressForm::Implicit } else { ProgressForm::Explicit };
        let mut progress = Progress::new(form, self.step());
        for s in moving {
            let on_path = self.drift.at(s.lambda).exp() * self.control.target_rate;
            progress.update(&self.limits, &s.split, s.factor, on_path);
        }
        progress.sums()
    }

    /// Distance at the first sample after the reference's end, and the largest ratio of two after one another.
    fn settling(&self, trace: &Trace) -> (f64, f64) {
        let after = &trace.samples[trace.following().len()..];
        let distances: Vec<f64> = after.iter().map(|s| self.distance(s)).collect();
        let ratios = distances.windows(2).map(|w| w[1] / w[0]);
        (distances.first().copied().unwrap_or(0.0), ratios.fold(0.0, f64::max))
    }

    /// In tolerances of arrival; for joints in the smallest of them, that of a sliding joint.
    fn distance(&self, s: &Sample) -> f64 {
        let norm = |part: &[f64]| part.iter().map(|e| e * e).sum::<f64>().sqrt();
        if self.by_joints {
            let worst = s.split.feedback.iter().fold(0.0_f64, |a, v| a.max(v.abs()));
            return worst / self.control.gain / slideway_lab::ARRIVAL_POSITION;
        }
        (norm(&s.error[..3]) / slideway_lab::ARRIVAL_POSITION)
            .max(norm(&s.error[3..]) / slideway_lab::ARRIVAL_ORIENTATION)
    }
}

/// The samples from the first in which the path parameter moves to the reference's end.
fn moving(trace: &Trace) -> &[Sample] {
    let following = trace.following();
    let start = following.iter().position(|s| s.path_rate > 0.0).unwrap_or(following.len());
    &following[start..]
}
