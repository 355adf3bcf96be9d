use crate::error::FigureError;
use crate::style::label;
use slideway_lab::{JointUnits, Method, Sample, Trace};
use slideway_path::SampledPath;

/// Data of the figures of a comparison of speed laws.
#[derive(Clone, Copy, Debug)]
pub struct SpeedStudy<'a> {
    /// Heading of every figure: the scenario, in a few words.
    pub title: &'a str,
    /// One trace per method, any subset of the methods in any order.
    pub traces: &'a [Trace],
    /// Points of the desired tool path, m.
    pub tool_path: &'a [[f64; 3]],
    /// Tool position at every sample of each trace, in the order of `traces`, m.
    pub tool_traces: &'a [Vec<[f64; 3]>],
    /// Lower joint-speed limits, rad/s.
    pub speed_lower: &'a [f64],
    /// Upper joint-speed limits, rad/s.
    pub speed_upper: &'a [f64],
    /// The offline optimum to compare with.
    pub optimum: Option<&'a Optimum>,
    /// Filter step `a = af Ts` of the regulated methods, for the captions.
    pub filter_step: f64,
    /// Proven band `M`: `‖F_N q̇d‖∞ ≤ M` while the reference moves.
    pub bound: Option<f64>,
}

/// An offline optimum as three columns of equal length.
///
/// The path rate may jump: give the values before and after at the same path parameter. A rate that is infinite or not a
/// number, where the path asks nothing of the joints, leaves a gap in the curve.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Optimum {
    /// Time since the start of motion, s, in order.
    pub time: Vec<f64>,
    /// Path parameter, in order.
    pub lambda: Vec<f64>,
    /// Path rate `dλ/dt`, 1/s; 0 during a self-motion.
    pub path_rate: Vec<f64>,
    /// The largest rate that the limits leave at each of these places, 1/s; empty where it is not known.
    pub rate_limit: Vec<f64>,
    /// Path parameters between which the bounds of the optimum are farthest apart.
    pub gap_cells: Vec<[f64; 2]>,
}

impl Optimum {
    /// The optimum under speed limits alone: `ds/dt = 1 / max_i(q_i'(s) / limit_i)` everywhere.
    ///
    /// Time is the trapezoidal rule on the samples, so the last one equals [`SampledPath::speed_limited_time`].
    #[must_use]
    pub fn under_speed_limits(path: &SampledPath) -> Self {
        let mut optimum = Self::default();
        let mut clock = 0.0;
        for piece in &path.pieces {
            let mut before: Option<(f64, f64)> = None;
            for sample in piece.in_order() {
                let slowness = path.slowness(sample);
                if let Some((s, slow)) = before {
                    clock += 0.5 * (sample.s - s) * (slow + slowness);
                }
                before = Some((sample.s, slowness));
                optimum.time.push(clock);
                optimum.lambda.push(sample.lambda);
                optimum.path_rate.push(if piece.is_self_motion { 0.0 } else { slowness.recip() });
            }
        }
        optimum
    }

    /// Duration, s.
    #[must_use]
    pub fn duration(&self) -> Option<f64> {
        self.time.last().copied()
    }

    /// Points of dλ/dt against λ.
    pub(crate) fn against_lambda(&self) -> Vec<(f64, f64)> {
        self.lambda.iter().copied().zip(self.path_rate.iter().copied()).collect()
    }

    /// Points of the limit curve against λ.
    pub(crate) fn limit_against_lambda(&self) -> Vec<(f64, f64)> {
        self.lambda.iter().copied().zip(self.rate_limit.iter().copied()).collect()
    }

    /// Points of dλ/dt against time, motion starting at `start`.
    pub(crate) fn against_time(&self, start: f64) -> Vec<(f64, f64)> {
        self.time.iter().map(|t| t + start).zip(self.path_rate.iter().copied()).collect()
    }
}

/// A study found fit to draw.
#[derive(Clone, Debug)]
pub(crate) struct Checked<'a> {
    pub(crate) study: &'a SpeedStudy<'a>,
    /// Fixed-speed methods first: what is drawn later lies on top.
    pub(crate) runs: Vec<Run<'a>>,
    pub(crate) joints: usize,
}

/// One trace as far as it is finite.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Run<'a> {
    pub(crate) trace: &'a Trace,
    pub(crate) method: Method,
    pub(crate) samples: &'a [Sample],
    pub(crate) tool: &'a [[f64; 3]],
}

impl<'a> Checked<'a> {
    pub(crate) fn new(study: &'a SpeedStudy<'a>) -> Result<Self, FigureError> {
        let joints = study.traces.iter().map(|t| t.joints).max().ok_or(FigureError::NoTraces)?;
        check_length("tool traces", study.traces.len(), study.tool_traces.len())?;
        check_limits(study, joints)?;
        check_each("points of the tool path", study.tool_path, |p| p.iter().all(|v| v.is_finite()))?;
        if let Some(optimum) = study.optimum {
            check_length("path parameters of the optimum", optimum.time.len(), optimum.lambda.len())?;
            check_length("path rates of the optimum", optimum.time.len(), optimum.path_rate.len())?;
            check_each("times of the optimum", &optimum.time, |t| t.is_finite())?;
            check_each("path parameters of the optimum", &optimum.lambda, |l| l.is_finite())?;
        }
        let mut runs = study
            .traces
            .iter()
            .zip(study.tool_traces)
            .map(|(trace, tool)| Run::new(trace, tool))
            .collect::<Result<Vec<_>, _>>()?;
        runs.sort_by_key(|run| Method::ALL.iter().position(|&m| m == run.method));
        Ok(Self { study, runs, joints })
    }

    /// Units of a joint: all runs are of one arm.
    pub(crate) fn units(&self, joint: usize) -> JointUnits {
        let units = self.study.traces.iter().max_by_key(|t| t.joints).and_then(|t| t.units.get(joint));
        units.copied().unwrap_or(JointUnits::TURNING)
    }

    /// Name of a joint: all runs are of one arm.
    pub(crate) fn joint_name(&self, joint: usize) -> &'a str {
        let most = self.study.traces.iter().max_by_key(|t| t.joints);
        most.map_or("", |t| &t.joint_names[joint])
    }

    /// The regulated runs.
    pub(crate) fn regulated(&self) -> impl Iterator<Item = &Run<'a>> {
        self.runs.iter().filter(|run| run.method.is_regulated())
    }

    /// When the last reference that reaches the path's end does so, with a little room for the robot to arrive, s.
    ///
    /// Constant speed and natural motion may take many times as long as the others: they do not set the axis, unless alone.
    pub(crate) fn end(&self) -> f64 {
        let others = self.runs.iter().any(|run| !run.method.surveys_the_path());
        let counted = self.runs.iter().filter(|run| !(others && run.method.surveys_the_path()));
        let finish = counted.filter_map(|run| run.trace.finish_s).fold(0.0, f64::max);
        let last = self.runs.iter().filter_map(|run| run.samples.last()).map(|s| s.t).fold(0.0, f64::max);
        if finish > 0.0 { last.min(1.1 * finish) } else { last }
    }

    /// Tells which runs outlast the time axis.
    pub(crate) fn time_remark(&self) -> String {
        let end = self.end();
        let longer = self.runs.iter().filter(|run| run.samples.last().is_some_and(|s| s.t > end));
        let names: Vec<&str> = longer.map(|run| label(run.method)).collect();
        if names.is_empty() {
            return self.remark();
        }
        format!(" The time axis ends at {end:.3} s; longer runs: {}.{}", names.join(", "), self.remark())
    }

    /// Tells which curves end early because their trace stops being finite.
    pub(crate) fn remark(&self) -> String {
        let broken = self.runs.iter().filter(|run| run.samples.len() < run.trace.samples.len());
        broken
            .filter_map(|run| Some((run.method, run.samples.last()?.t)))
            .map(|(m, t)| format!(" The trace of {} is not finite after {t:.3} s and is drawn up to there.", label(m)))
            .collect()
    }
}

impl<'a> Run<'a> {
    fn new(trace: &'a Trace, tool: &'a [[f64; 3]]) -> Result<Self, FigureError> {
        let method = trace.method;
        check_length("names of the joints", trace.joints, trace.joint_names.len())?;
        if trace.samples.is_empty() {
            return Err(FigureError::EmptyTrace { method });
        }
        check_length("points of a tool trace", trace.samples.len(), tool.len())?;
        let finite = trace.samples.iter().zip(tool).take_while(|(s, p)| is_finite(s, p)).count();
        if finite == 0 {
            return Err(FigureError::NotFinite { method });
        }
        Ok(Self { trace, method, samples: &trace.samples[..finite], tool: &tool[..finite] })
    }

    /// Samples up to the reference's end.
    pub(crate) fn following(&self) -> &'a [Sample] {
        &self.samples[..self.trace.following().len().min(self.samples.len())]
    }

    /// Samples in which the reference moves: from its first motion to its end.
    pub(crate) fn moving(&self) -> &'a [Sample] {
        let following = self.following();
        let start = following.iter().position(|s| s.path_rate > 0.0).unwrap_or(following.len());
        &following[start..]
    }

    /// Points of a quantity against time.
    pub(crate) fn against_time(&self, value: impl Fn(&Sample) -> f64) -> Vec<(f64, f64)> {
        self.samples.iter().map(|s| (s.t, value(s))).collect()
    }
}

fn is_finite(sample: &Sample, tool: &[f64; 3]) -> bool {
    let scalars =
        [sample.t, sample.lambda, sample.path_rate, sample.factor, sample.direction_factor, sample.limit_ratio];
    let lists = [&sample.error[..], &sample.q, &sample.desired, &sample.commanded, tool];
    scalars.iter().chain(lists.into_iter().flatten()).all(|v| v.is_finite())
}

fn check_limits(study: &SpeedStudy, joints: usize) -> Result<(), FigureError> {
    for (what, limits) in [("lower speed limits", study.speed_lower), ("upper speed limits", study.speed_upper)] {
        if limits.len() < joints {
            return Err(FigureError::Length { what, expected: joints, found: limits.len() });
        }
    }
    check_each("lower speed limits", study.speed_lower, |l| l.is_finite() && *l < 0.0)?;
    check_each("upper speed limits", study.speed_upper, |l| l.is_finite() && *l > 0.0)
}

fn check_length(what: &'static str, expected: usize, found: usize) -> Result<(), FigureError> {
    if expected == found { Ok(()) } else { Err(FigureError::Length { what, expected, found }) }
}

fn check_each<T>(what: &'static str, list: &[T], usable: impl Fn(&T) -> bool) -> Result<(), FigureError> {
    match list.iter().position(|value| !usable(value)) {
        Some(index) => Err(FigureError::Value { what, index }),
        None => Ok(()),
    }
}
