use crate::method::Method;
use crate::run::trace::{Sample, Trace};
use serde::{Deserialize, Serialize};

/// The robot has arrived when the reference is at its end and the tool this near to it, m.
pub const ARRIVAL_POSITION: f64 = 1e-4;
/// The robot has arrived when the reference is at its end and the tool's orientation this near to it, rad.
pub const ARRIVAL_ORIENTATION: f64 = 1e-3;

/// Summary of one run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MethodSummary {
    /// The method.
    pub method: Method,
    /// True if the reference reached the path's end.
    pub completed: bool,
    /// When the reference reached the path's end, s.
    pub duration_s: Option<f64>,
    /// When the path parameter first moved, s: the approach ends here.
    pub motion_start_s: Option<f64>,
    /// When the tool was within 0.1 mm and 1 mrad of the path's end, the reference being there, s.
    pub robot_arrival_s: Option<f64>,
    /// Root mean square of each error coordinate over the samples up to the reference's end, m and rad.
    pub rms_error: [f64; 6],
    /// Root mean square of the error's Euclidean norm.
    pub rms_error_norm: f64,
    /// Largest absolute value of each error coordinate up to the reference's end.
    pub peak_error: [f64; 6],
    /// Largest distance of the tool from its reference while the reference moves, m.
    pub peak_path_error_m: f64,
    /// Largest distance of the tool from the path's end once the reference is there, m: how far it trails or overshoots.
    pub peak_end_error_m: f64,
    /// Largest norm of the Euler-angle error while the reference moves, rad.
    pub peak_path_error_rad: f64,
    /// Largest `‖F_N q̇d‖∞` while the reference moves.
    pub limit_ratio_peak: f64,
    /// Largest joint acceleration while the reference moves, as the change of the commanded speed over the period that the
    /// controller counts on, rad/s².
    pub peak_acceleration: Vec<f64>,
    /// Samples of the whole run whose demand was out of the joints' reach at any path rate; `None` for methods without acceleration
    /// limits.
    pub samples_off_path: Option<usize>,
    /// Chattering, for the regulated methods.
    pub chattering: Option<Chattering>,
}

/// Largest change of a desired joint speed over one sample while the reference moves, as a share of the speed limit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Chattering {
    /// The largest value measured.
    pub measured: f64,
    /// The largest value of the rigorous bound.
    pub bound: f64,
    /// The largest value of the paper's estimate.
    pub paper_estimate: f64,
}

impl MethodSummary {
    /// Summarises a trace.
    #[must_use]
    pub fn new(trace: &Trace) -> Self {
        let following = trace.following();
        let moving = moving(following);
        Self {
            method: trace.method,
            completed: trace.finish_s.is_some(),
            duration_s: trace.finish_s,
            motion_start_s: trace.motion_start(),
            robot_arrival_s: trace.arrival_s,
            rms_error: std::array::from_fn(|i| root_mean(following, |s| s.error[i].powi(2))),
            rms_error_norm: root_mean(following, |s| s.error.iter().map(|e| e * e).sum()),
            peak_error: std::array::from_fn(|i| largest(following, |s| s.error[i].abs())),
            peak_path_error_m: largest(moving, |s| norm(&s.error[..3])),
            peak_end_error_m: largest(&trace.samples[following.len()..], |s| norm(&s.error[..3])),
            peak_path_error_rad: largest(moving, |s| norm(&s.error[3..])),
            limit_ratio_peak: largest(moving, |s| s.limit_ratio),
            peak_acceleration: peak_acceleration(trace, moving),
            samples_off_path: trace
                .method
                .limits_acceleration()
                .then(|| trace.samples.iter().filter(|s| s.direction_factor < 1.0).count()),
            chattering: trace.method.bounds_chattering().then(|| chattering(moving)),
        }
    }

    /// The time that is compared with the optimum, s: from the start of motion to the *robot's* arrival.
    ///
    /// A reference that finishes while the robot still trails has not beaten anything.
    #[must_use]
    pub fn travel_s(&self) -> Option<f64> {
        Some(self.robot_arrival_s? - self.motion_start_s?)
    }
}

/// The samples from the first one in which the path parameter moves.
fn moving(following: &[Sample]) -> &[Sample] {
    let start = following.iter().position(|s| s.path_rate > 0.0).unwrap_or(following.len());
    &following[start..]
}

fn norm(part: &[f64]) -> f64 {
    part.iter().map(|e| e * e).sum::<f64>().sqrt()
}

fn largest(samples: &[Sample], value: impl Fn(&Sample) -> f64) -> f64 {
    samples.iter().map(value).fold(0.0, f64::max)
}

#[allow(clippy::cast_precision_loss)]
fn root_mean(samples: &[Sample], square: impl Fn(&Sample) -> f64) -> f64 {
    (samples.iter().map(square).sum::<f64>() / samples.len().max(1) as f64).sqrt()
}

fn chattering(moving: &[Sample]) -> Chattering {
    let largest = |value: fn(&crate::run::trace::Chatter) -> f64| {
        moving.iter().filter_map(|s| s.chatter.as_ref()).map(value).fold(0.0, f64::max)
    };
    Chattering {
        measured: largest(|c| c.measured),
        bound: largest(|c| c.bound),
        paper_estimate: largest(|c| c.estimate),
    }
}

fn peak_acceleration(trace: &Trace, moving: &[Sample]) -> Vec<f64> {
    (0..trace.joints)
        .map(|i| {
            moving
                .windows(2)
                .map(|w| (w[1].commanded[i] - w[0].commanded[i]).abs() / trace.sampling_period)
                .fold(0.0, f64::max)
        })
        .collect()
}
