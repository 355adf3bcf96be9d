//! Constant speed, natural motion, sliding mode and the optimum on one path: figures, and a sweep over the limits.

use crate::diagnostic::CliError;
use serde::Serialize;
use slideway_baselines::time_optimal::TimeOptimum;
use slideway_figures::{
    CourseLaw, CourseStudy, MeanSpeedLine, MeanSpeedStudy, ModelErrorOfLaw, ModelErrorStudy, NamedCourse, Rendered,
    draw_courses, draw_mean_speed, draw_model_error,
};
use slideway_lab::{Course, Experiment, Method, MethodSummary, ProfilePoint, Trace};
use slideway_path::{ProblemError, SampledPath};
use std::path::Path;

/// The laws of the figures, the largest speeds last. The published form of the sliding mode chatters: its torques would hide
/// the others' and stand in the table.
const DRAWN: [Method; 3] = [Method::ConstantSpeed, Method::NaturalMotion, Method::SlidingModeImplicit];

/// What the scenario's speed limits are multiplied by for the summary figure.
const SHARES: [f64; 5] = [0.4, 0.7, 1.0, 1.5, 2.0];

/// Share by which the controller misjudges the links' masses, as in `[N] Fig. 3`.
const MASS_ERROR: f64 = 0.1;

/// Points of the tool path whose chords make its length.
const CHORDS: usize = 4000;

/// Mean speeds under the scenario's speed limits times a number.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct ScaledLimits {
    /// The number.
    pub(crate) share: f64,
    /// Largest joint-speed limit, rad/s.
    pub(crate) largest_limit: f64,
    /// Mean tool speed of the optimum under the speed limits (closed form), m/s.
    pub(crate) optimum_m_per_s: f64,
    /// Mean tool speed of each method from the start of motion to the robot's arrival, m/s; methods that arrive.
    pub(crate) methods: Vec<MethodSpeed>,
}

/// A method's mean tool speed.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct MethodSpeed {
    pub(crate) method: Method,
    pub(crate) m_per_s: f64,
}

/// What a model with masses wrong by 10 % costs a law.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct ModelErrorEntry {
    /// The method, or `optimum`.
    pub(crate) law: &'static str,
    /// Largest distance of the tool from where the law has it, as fast as the limits allow, m.
    pub(crate) peak_error_m: f64,
    /// The same in the time that the slowest law takes, m.
    pub(crate) peak_error_in_equal_time_m: f64,
}

/// Whether the scenario asks for constant speed and natural motion beside the others.
pub(crate) fn asked_for(experiment: &Experiment) -> bool {
    experiment.methods().contains(&Method::NaturalMotion)
}

/// What the joints do along the optimum.
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
pub(crate) fn sweep_limits(experiment: &Experiment, path: &SampledPath) -> Result<Vec<ScaledLimits>, ProblemError> {
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
            let travel = MethodSummary::new(&scaled.run(method)?).travel_s();
            speeds.extend(travel.map(|t| MethodSpeed { method, m_per_s: length / t }));
        }
        let optimum_m_per_s = length * share / path.speed_limited_time();
        Ok(ScaledLimits { share, largest_limit: share * largest, optimum_m_per_s, methods: speeds })
    };
    SHARES.into_iter().map(entry).collect()
}

/// The laws' courses, the optimum's first; none unless the scenario asks for the laws of `[N]`.
pub(crate) fn courses(experiment: &Experiment, traces: &[Trace], optimum: &Course) -> Vec<NamedCourse> {
    if !asked_for(experiment) {
        return Vec::new();
    }
    let mut courses = vec![NamedCourse { law: CourseLaw::Optimum, course: optimum.clone() }];
    for trace in traces.iter().filter(|t| DRAWN.contains(&t.method) && t.finish_s.is_some()) {
        courses.push(NamedCourse { law: CourseLaw::Method(trace.method), course: experiment.course(trace) });
    }
    courses
}

/// What a wrong model costs each law that computed torque can follow; nothing where the masses are unknown.
pub(crate) fn model_errors(
    experiment: &Experiment,
    courses: &[NamedCourse],
) -> Result<Vec<ModelErrorOfLaw>, ProblemError> {
    let longest = courses.iter().map(|c| c.course.seconds()).fold(0.0, f64::max);
    let mut errors = Vec::new();
    for NamedCourse { law, course } in courses {
        let at_limits = experiment.follow_with_wrong_masses(course, MASS_ERROR)?;
        let in_equal_time = experiment.follow_with_wrong_masses(&course.in_time(longest), MASS_ERROR)?;
        if let (Some(at_limits), Some(in_equal_time)) = (at_limits, in_equal_time) {
            errors.push(ModelErrorOfLaw { law: *law, at_limits, in_equal_time });
        }
    }
    Ok(errors)
}

impl From<&ModelErrorOfLaw> for ModelErrorEntry {
    fn from(error: &ModelErrorOfLaw) -> Self {
        let law = match error.law {
            CourseLaw::Optimum => "optimum",
            CourseLaw::Method(method) => method.name(),
        };
        let (peak_error_m, peak_error_in_equal_time_m) = (error.at_limits.peak(), error.in_equal_time.peak());
        Self { law, peak_error_m, peak_error_in_equal_time_m }
    }
}

/// The figures of the laws; none unless the scenario asks for them.
pub(crate) fn figures(
    title: &str,
    courses: &[NamedCourse],
    model_errors: &[ModelErrorOfLaw],
    path: &SampledPath,
    sweep: &[ScaledLimits],
    dir: &Path,
) -> Result<Vec<Rendered>, CliError> {
    if courses.is_empty() {
        return Ok(Vec::new());
    }
    let (speed_lower, speed_upper) = (&path.speed_lower, &path.speed_upper);
    let mut rendered = draw_courses(&CourseStudy { title, courses, speed_lower, speed_upper }, dir)?;
    let lines = lines(sweep);
    if lines.len() > 1 {
        rendered.insert(0, draw_mean_speed(&MeanSpeedStudy { title, lines: &lines }, dir)?);
    }
    if !model_errors.is_empty() {
        let study = ModelErrorStudy { title, share: MASS_ERROR, laws: model_errors };
        rendered.push(draw_model_error(&study, dir)?);
    }
    Ok(rendered)
}

/// The optimum's line first, then one for each method that arrives under two limits or more.
fn lines(sweep: &[ScaledLimits]) -> Vec<MeanSpeedLine> {
    let points = |value: &dyn Fn(&ScaledLimits) -> Option<f64>| -> Vec<(f64, f64)> {
        sweep.iter().filter_map(|entry| Some((entry.largest_limit, value(entry)?))).collect()
    };
    let of =
        |method| points(&|entry: &ScaledLimits| entry.methods.iter().find(|m| m.method == method).map(|m| m.m_per_s));
    let mut lines = vec![MeanSpeedLine { law: CourseLaw::Optimum, points: points(&|e| Some(e.optimum_m_per_s)) }];
    for method in Method::ALL {
        lines.push(MeanSpeedLine { law: CourseLaw::Method(method), points: of(method) });
    }
    lines.retain(|line| line.points.len() > 1);
    lines
}
