//! Figures of constant speed, natural motion, sliding mode and the optimum on one path.

use crate::say::diagnostic::CliError;
use slideway_compare::{Law, LawCourse, LawModelError, MASS_ERROR, ScaledLimits, SpeedComparison};
use slideway_figures::{
    CourseLaw, CourseStudy, MeanSpeedLine, MeanSpeedStudy, ModelErrorOfLaw, ModelErrorStudy, NamedCourse, Rendered,
    draw_courses, draw_mean_speed, draw_model_error,
};
use slideway_lab::Method;
use std::path::Path;

/// The figures of the laws; none unless the scenario asks for them.
pub(crate) fn draw(
    title: &str,
    joint_names: &[String],
    comparison: &SpeedComparison,
    dir: &Path,
) -> Result<Vec<Rendered>, CliError> {
    let SpeedComparison { summary, courses, model_errors, path, .. } = comparison;
    if courses.is_empty() {
        return Ok(Vec::new());
    }
    let named = |of: &LawCourse| NamedCourse { law: drawn(of.law), course: of.course.clone() };
    let courses = &courses.iter().map(named).collect::<Vec<_>>();
    let (speed_lower, speed_upper) = (&path.speed_lower, &path.speed_upper);
    let mut rendered = draw_courses(&CourseStudy { title, joint_names, courses, speed_lower, speed_upper }, dir)?;
    let lines = lines(&summary.scaled_limits);
    if lines.len() > 1 {
        rendered.insert(0, draw_mean_speed(&MeanSpeedStudy { title, lines: &lines }, dir)?);
    }
    if !model_errors.is_empty() {
        let of_law = |of: &LawModelError| {
            let LawModelError { law, at_limits, in_equal_time } = of.clone();
            ModelErrorOfLaw { law: drawn(law), at_limits, in_equal_time }
        };
        let laws = &model_errors.iter().map(of_law).collect::<Vec<_>>();
        rendered.push(draw_model_error(&ModelErrorStudy { title, share: MASS_ERROR, laws }, dir)?);
    }
    Ok(rendered)
}

/// A law as the figures name it.
fn drawn(law: Law) -> CourseLaw {
    match law {
        Law::Optimum => CourseLaw::Optimum,
        Law::Method(method) => CourseLaw::Method(method),
    }
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
