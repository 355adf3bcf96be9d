//! Constant speed, natural motion, sliding mode and the optimum on one path: their courses, a sweep over the limits, and the cost of
//! wrong masses.

use crate::error::CompareError;
use crate::progress::{Stage, Steps};
use serde::Serialize;
use slideway_baselines::time_optimal::TimeOptimum;
use slideway_lab::natural::ModelErrorRun;
use slideway_lab::{Course, Experiment, Method, MethodSummary, ProfilePoint, Trace};
use slideway_path::{ProblemError, SampledPath};

/// The laws of the figures, the largest speeds last. The published form of the sliding mode chatters: its torques would hide
/// the others' and stand in the table.
const DRAWN: [Method; 3] = [Method::ConstantSpeed, Method::NaturalMotion, Method::SlidingModeImplicit];

/// Factors of the scenario's speed limits.
const SHARES: [f64; 5] = [0.4, 0.7, 1.0, 1.5, 2.0];

/// Share by which the controller misjudges the links' masses, as in `[N] Fig. 3`.
pub const MASS_ERROR: f64 = 0.1;

/// Points of the tool path whose chords make its length.
const CHORDS: usize = 4000;

/// Mean speeds under the scenario's speed limits times a number.
#[derive(Clone, Debug, Serialize)]
pub struct ScaledLimits {
    /// The number.
    pub share: f64,
    /// Largest joint-speed limit, rad/s.
    pub largest_limit: f64,
    /// Mean tool speed of the optimum under the speed limits (closed form), m/s.
    pub optimum_m_per_s: f64,
    /// Mean tool speed of each method from the start of motion to the robot's arrival, m/s; methods that arrive.
    pub methods: Vec<MethodSpeed>,
}

/// A method's mean tool speed.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct MethodSpeed {
    /// The method.
    pub method: Method,
    /// Its mean speed, m/s.
    pub m_per_s: f64,
}

/// Whose course it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// The offline optimum.
    Optimum,
    /// A method.
    Method(Method),
}

/// The course of the joints under a law.
#[derive(Clone, Debug)]
pub struct LawCourse {
    /// The law.
    pub law: Law,
    /// The course.
    pub course: Course,
}

/// Runs of a law under computed torque with masses wrong by [`MASS_ERROR`].
#[derive(Clone, Debug)]
pub struct LawModelError {
    /// The law.
    pub law: Law,
    /// Run as fast as the limits allow.
    pub at_limits: ModelErrorRun,
    /// Run in the time that the slowest of the laws takes.
    pub in_equal_time: ModelErrorRun,
}

/// The cost for a law of a model with masses wrong by 10 %.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct ModelErrorEntry {
    /// The method, or `optimum`.
    pub law: &'static str,
    /// Largest distance of the tool from where the law has it, as fast as the limits allow, m.
    pub peak_error_m: f64,
    /// The same in the time that the slowest law takes, m.
    pub peak_error_in_equal_time_m: f64,
}

/// True if the scenario asks for constant speed and natural motion beside the others.
pub(crate) fn asked_for(experiment: &Experiment) -> bool {
    experiment.methods().contains(&Method::NaturalMotion)
}

/// The joints' course along the optimum.
pub(crate) fn optimum_course(experiment: &Experiment, optimum: &TimeOptimum) -> Result<Course, ProblemError> {
    let mut points = Vec::new();
    let mut begin = 0.0;
    for (piece, profile) in optimum.pieces.iter().enumerate() {
        let times = profile.times();
        let place = |((&s, &b), &t): ((&f64, &f64), &f64)| ProfilePoint { piece, s, rate: b.sqrt(), t: begin + t };
        points.extend(profile.s.iter().zip(&profile.b).zip(&times).map(place));
        begin += times.last().copied().unwrap_or(0.0);
    }
    experiment.course_along(&points)
}

/// Runs the methods under limits from [`SHARES`] times the scenario's; nothing unless the scenario asks for the laws of `[N]`
/// under constant speed limits alone.
pub(crate) fn sweep_limits(
    experiment: &Experiment,
    path: &SampledPath,
    steps: &mut Steps<'_, '_>,
) -> Result<Vec<ScaledLimits>, CompareError> {
    let limits_more = path.pieces.iter().any(|piece| path.limits_acceleration(piece));
    let varies = path.pieces.iter().any(|piece| piece.nodes.iter().any(|node| !node.speeds.is_empty()));
    if !asked_for(experiment) || limits_more || varies {
        return Ok(Vec::new());
    }
    let tool = experiment.tool_path(CHORDS);
    let chord = |w: &[[f64; 3]]| (0..3).map(|i| (w[1][i] - w[0][i]).powi(2)).sum::<f64>().sqrt();
    let length: f64 = tool.windows(2).map(chord).sum();
    let largest = path.speed_upper.iter().chain(&path.speed_lower).fold(0.0_f64, |most, l| most.max(l.abs()));
    let methods = [Method::ConstantSpeed, Method::NaturalMotion, Method::SlidingMode, Method::SlidingModeImplicit];
    let entry = |share: f64| {
        let scaled = experiment.with_speed_limits_scaled(share)?;
        let mut speeds = Vec::new();
        for method in methods {
            steps.at(Stage::Variations)?;
            let travel = MethodSummary::new(&scaled.run(method)?).travel_s();
            speeds.extend(travel.map(|t| MethodSpeed { method, m_per_s: length / t }));
        }
        let optimum_m_per_s = length * share / path.speed_limited_time();
        Ok(ScaledLimits { share, largest_limit: share * largest, optimum_m_per_s, methods: speeds })
    };
    SHARES.into_iter().map(entry).collect()
}

/// The laws' courses, the optimum's first; none unless the scenario asks for the laws of `[N]`.
pub(crate) fn courses(experiment: &Experiment, traces: &[Trace], optimum: &Course) -> Vec<LawCourse> {
    if !asked_for(experiment) {
        return Vec::new();
    }
    let mut courses = vec![LawCourse { law: Law::Optimum, course: optimum.clone() }];
    for trace in traces.iter().filter(|t| DRAWN.contains(&t.method) && t.finish_s.is_some()) {
        courses.push(LawCourse { law: Law::Method(trace.method), course: experiment.course(trace) });
    }
    courses
}

/// What a wrong model costs each law that computed torque can follow; nothing where the masses are unknown.
pub(crate) fn model_errors(experiment: &Experiment, courses: &[LawCourse]) -> Result<Vec<LawModelError>, ProblemError> {
    let longest = courses.iter().map(|c| c.course.seconds()).fold(0.0, f64::max);
    let mut errors = Vec::new();
    for LawCourse { law, course } in courses {
        let at_limits = experiment.follow_with_wrong_masses(course, MASS_ERROR)?;
        let in_equal_time = experiment.follow_with_wrong_masses(&course.in_time(longest), MASS_ERROR)?;
        if let (Some(at_limits), Some(in_equal_time)) = (at_limits, in_equal_time) {
            errors.push(LawModelError { law: *law, at_limits, in_equal_time });
        }
    }
    Ok(errors)
}

impl Law {
    /// Name of the method, or `optimum`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Optimum => "optimum",
            Self::Method(method) => method.name(),
        }
    }
}

impl From<&LawModelError> for ModelErrorEntry {
    fn from(error: &LawModelError) -> Self {
        let (peak_error_m, peak_error_in_equal_time_m) = (error.at_limits.peak(), error.in_equal_time.peak());
        Self { law: error.law.name(), peak_error_m, peak_error_in_equal_time_m }
    }
}
