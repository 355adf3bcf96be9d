//! The statement about a speed law.

use super::Statement;
use super::entry::{ROOM, room};
use super::path_drift::Asked;
use super::signals::{Loop, SETTLED, SpeedMeasures, SpeedSignals};
use super::speed_declared::declared;
use super::speed_loop::loop_on;
use crate::error::VerifyError;
use slideway_conditioner::bounds::Signals;
use slideway_lab::{Experiment, Method, Trace};
use slideway_path::SampledPath;

/// Numbers that a statement about a speed law rests on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SpeedNumbers {
    /// Certified optimum under the speed limits alone, s.
    pub(crate) optimum_s: f64,
    /// Rate at which the filter falls, `-ln(1 - a) / Ts`, 1/s.
    pub(crate) filter_fall_rate: f64,
    /// Rate at which the limit falls along the path at the pace of the loop, 1/s.
    pub(crate) drift_rate: f64,
    /// The same from half as many samples, 1/s: whether the number has settled.
    pub(crate) drift_rate_coarse: f64,
    /// Largest path rate that the limits allow anywhere, 1/s.
    pub(crate) fastest_rate: f64,
    /// Largest overspeed along the path, `λ̇d / λ̇*`.
    pub(crate) overspeed: f64,
    /// Largest change of the demand over one sample, a share of the limits, without the filter's part.
    pub(crate) demand_change: f64,
    /// Samples at which the path was read.
    pub(crate) path_samples: usize,
}

/// Everything a statement is assembled from.
pub(crate) struct SpeedCase {
    pub(crate) experiment: Experiment,
    /// The run without a trial's disturbances.
    pub(crate) trace: Trace,
    pub(crate) looked: Loop,
    pub(crate) numbers: SpeedNumbers,
    pub(crate) asked: Asked,
    pace: f64,
    pub(crate) nominal: SpeedSignals,
    pub(crate) measures: SpeedMeasures,
    /// Signals that the bounds are stated for.
    pub(crate) declared: SpeedSignals,
    pub(crate) optimum: [f64; 2],
    pub(crate) acceleration: Option<Vec<f64>>,
    pub(crate) peak_acceleration: Vec<f64>,
    /// True if speed limits hold at some places only, or limit the tool: the law's own bounds know nothing of them.
    pub(crate) varying: bool,
}

impl SpeedCase {
    /// For a method; the optimum is solved on a grid of so many points.
    pub(crate) fn new(experiment: Experiment, method: Method, grid_points: usize) -> Result<Self, VerifyError> {
        let (looked, path) = loop_on(&experiment, method, grid_points)?;
        let trace = experiment.run(method)?;
        let (nominal, measures) = (looked.signals(&trace), looked.measures(&trace));
        let ([optimum_s, lower_s, upper_s], closed) = (looked.optimum, path.speed_limited_time());
        let (pace, asked) = pace(&looked, &nominal);
        let (fastest, slowest) = looked.drift.slowness_range();
        let fall = fall_rate(&looked);
        let numbers = SpeedNumbers {
            optimum_s,
            filter_fall_rate: fall,
            drift_rate: asked.fall_rate,
            drift_rate_coarse: looked.drift.halved().asked(pace, fall, looked.control.sampling_period).fall_rate,
            fastest_rate: 1.0 / fastest,
            overspeed: looked.control.target_rate * slowest,
            demand_change: nominal.settled.unwrap_or(nominal.whole).demand_change,
            path_samples: looked.drift.samples(),
        };
        let peak_acceleration = slideway_lab::MethodSummary::new(&trace).peak_acceleration;
        Ok(Self {
            declared: declared(&nominal, &looked, &asked),
            numbers,
            asked,
            pace,
            nominal,
            measures,
            optimum: [lower_s.min(closed), upper_s.max(closed)],
            acceleration: path.acceleration.clone(),
            peak_acceleration,
            varying: limits_vary(&path),
            experiment,
            trace,
            looked,
        })
    }
}

/// True if speed limits hold at some places only, or limit the tool: then the regulator's filter does not see what bounds the rate.
fn limits_vary(path: &SampledPath) -> bool {
    path.pieces.iter().flat_map(|piece| &piece.nodes).any(|node| !node.speeds.is_empty())
}

fn fall_rate(looked: &Loop) -> f64 {
    -(-looked.step()).ln_1p() / looked.control.sampling_period
}

/// `R`: at most the path rate over `λ̇*` once settled, and what the path asks at that pace.
///
/// Where the reference waits, `R = 1 + E`. In the published advance `R = Z e^S`, and `S` depends on `R`: a fixed point from below.
fn pace(looked: &Loop, nominal: &SpeedSignals) -> (f64, Asked) {
    let (fall, period) = (fall_rate(looked), looked.control.sampling_period);
    let settled = nominal.settled.unwrap_or(nominal.whole);
    let waits = looked.method != Method::SlidingMode;
    let mut pace = 1.0 + room(settled.feedback);
    let mut asked = looked.drift.asked(pace, fall, period);
    if waits {
        return (pace, asked);
    }
    let (_, slowest) = looked.drift.slowness_range();
    for _ in 0..50 {
        let drift = looked.drift.sample_drift(pace, period);
        let signals = Signals {
            feedback: room(settled.feedback),
            overspeed: looked.control.target_rate * slowest,
            rise: drift,
            surplus: asked.surplus,
            ..Signals::NONE
        };
        let next = signals.feedforward_band(looked.step());
        if !(next.is_finite() && next < 1e3) {
            return (next, Asked { fall_rate: f64::INFINITY, surplus: f64::INFINITY });
        }
        let settled = next <= pace * (1.0 + 1e-9);
        pace = next.max(pace);
        asked = looked.drift.asked(pace, fall, period);
        if settled {
            break;
        }
    }
    (pace, asked)
}

impl Statement {
    /// States the guarantees of a speed law on a path.
    ///
    /// Runs the experiment once; solves for the certified optimum under the speed limits on a grid of so many points.
    ///
    /// # Errors
    ///
    /// A method that cannot be run, or a path without an optimum.
    pub fn for_speed(experiment: Experiment, method: Method, grid_points: usize) -> Result<Self, VerifyError> {
        Ok(SpeedCase::new(experiment, method, grid_points)?.statement())
    }
}

impl SpeedCase {
    /// Chattering's bound per unit of the filter step: the overspeed, with its room.
    pub(crate) fn chattering_per_step(&self) -> f64 {
        self.declared.whole.overspeed
    }

    pub(crate) fn statement(&self) -> Statement {
        let method = self.looked.method;
        let mut statement = Statement {
            method: method.name().to_owned(),
            hypotheses: Vec::new(),
            guarantees: Vec::new(),
            remarks: self.remarks(),
        };
        if method != Method::Ideal {
            statement.guarantees.push(self.command());
        }
        if method.limits_acceleration() {
            statement.guarantees.extend(self.accelerations());
        }
        if method.bounds_chattering() && !self.varying {
            statement.hypotheses = self.hypotheses();
            statement.guarantees.extend(self.demand());
            statement.guarantees.extend(self.changes());
            statement.guarantees.extend(self.times());
        }
        statement.keep_what_holds()
    }

    pub(crate) fn implicit(&self) -> bool {
        self.looked.method == Method::SlidingModeImplicit
    }

    fn remarks(&self) -> Vec<String> {
        let n = &self.numbers;
        let mut list = vec![format!(
            "Bounds are stated for signals {:.0} % larger than those of the run without disturbances. The path was read at {} samples; its \
             steepest drift is {:.4} 1/s, and {:.4} 1/s from half as many. The loop's pace is at most {:.3} λ̇*; over any stretch the drift \
             gains at most {:.3} on the filter (in ln).",
            100.0 * ROOM,
            n.path_samples,
            n.drift_rate,
            n.drift_rate_coarse,
            self.pace,
            self.asked.surplus
        )];
        if self.looked.method.limits_acceleration() {
            list.push("Not guaranteed: that the tool stays on the path, and the travel time.".into());
        } else if !self.looked.method.is_regulated() {
            list.push("Nothing is regulated: the demand, its changes and the time have no bound.".into());
        } else if self.varying {
            list.push("The speed limits vary along the path or limit the tool: only the command is bounded.".into());
        }
        if self.nominal.settled.is_none() {
            list.push(format!(
                "The feedback never stays below {:.0} % of the limits: nothing is stated for the settled loop.",
                100.0 * SETTLED
            ));
        }
        if self.looked.drift.breaks() {
            list.push("The tool stands at a singularity while the joints turn: the drift there has no bound, and the time no bracket.".into());
        }
        list
    }
}

/// Largest ratio of a joint's two limits.
pub(crate) fn asymmetry(looked: &Loop) -> f64 {
    let ends = looked.limits.lower().iter().zip(looked.limits.upper());
    ends.map(|(lo, up)| (lo / up).abs().max((up / lo).abs())).fold(1.0, f64::max)
}

/// Largest change of the demand that signals prove.
pub(crate) fn chattering(looked: &Loop, signals: &Signals) -> f64 {
    let explicit = signals.chattering(looked.step());
    if looked.method != Method::SlidingModeImplicit {
        return explicit;
    }
    slideway_conditioner::bounds::implicit_chattering(signals, looked.step(), asymmetry(looked))
}
