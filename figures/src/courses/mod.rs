//! Several laws on one path against the path parameter: the quantities of `[N]` Figs. 2, 3 and 5, the optimum among them.

mod joints;
mod model_error;
mod path_speed;

pub use model_error::{ModelErrorOfLaw, ModelErrorStudy, draw_model_error};

use crate::canvas::Entry;
use crate::error::FigureError;
use crate::facts::entry;
use crate::polyline::Point;
use crate::render::{Rendered, make_directory, render};
use crate::style::{REFERENCE, Stroke, label, stroke};
use slideway_lab::{Course, CourseSample, Method};
use std::path::Path;

/// Runs of several laws on one path.
#[derive(Clone, Copy, Debug)]
pub struct CourseStudy<'a> {
    /// Heading of every figure: the scenario, in a few words.
    pub title: &'a str,
    /// Names of the joints, from base to tip.
    pub joint_names: &'a [String],
    /// The runs; what comes later lies on top.
    pub courses: &'a [NamedCourse],
    /// Lower joint-speed limits, rad/s.
    pub speed_lower: &'a [f64],
    /// Upper joint-speed limits, rad/s.
    pub speed_upper: &'a [f64],
}

/// A course and whose it is.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedCourse {
    /// The law.
    pub law: CourseLaw,
    /// Course of the joints.
    pub course: Course,
}

/// The law that a course belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CourseLaw {
    /// The offline optimum.
    Optimum,
    /// A method.
    Method(Method),
}

/// Draws path speed, joint speeds and, where the masses are known, joint torques against the path parameter.
///
/// # Errors
///
/// No course, one without samples or with a value that is not finite, too few limits, or files that cannot be written.
pub fn draw_courses(study: &CourseStudy, dir: &Path) -> Result<Vec<Rendered>, FigureError> {
    crate::style::register_fonts()?;
    check(study)?;
    make_directory(dir)?;
    let mut rendered =
        vec![render(&path_speed::PathSpeed(study), dir)?, render(&joints::JointSpeedsAlongPath(study), dir)?];
    if study.courses.iter().all(|c| c.course.samples.iter().all(|s| s.torque.is_some())) {
        rendered.push(render(&joints::JointTorquesAlongPath(study), dir)?);
    }
    Ok(rendered)
}

fn check(study: &CourseStudy) -> Result<(), FigureError> {
    if study.courses.is_empty() {
        return Err(FigureError::NoTraces);
    }
    for NamedCourse { course, .. } in study.courses {
        if course.samples.is_empty() {
            return Err(FigureError::Length { what: "samples of a course", expected: 1, found: 0 });
        }
        if let Some(index) = course.samples.iter().position(|s| !is_finite(s)) {
            return Err(FigureError::Value { what: "samples of a course", index });
        }
        let named = study.joint_names.len();
        if named < course.joints {
            return Err(FigureError::Length { what: "names of the joints", expected: course.joints, found: named });
        }
        let fewest = study.speed_lower.len().min(study.speed_upper.len());
        if fewest < course.joints {
            return Err(FigureError::Length { what: "speed limits", expected: course.joints, found: fewest });
        }
    }
    Ok(())
}

fn is_finite(sample: &CourseSample) -> bool {
    let lists = [&sample.speed[..], &sample.acceleration, sample.torque.as_ref().map_or(&[][..], |t| &t[..])];
    [sample.t, sample.lambda, sample.path_rate].iter().chain(lists.into_iter().flatten()).all(|v| v.is_finite())
}

impl CourseLaw {
    pub(crate) fn stroke(self) -> Stroke {
        match self {
            Self::Optimum => REFERENCE,
            Self::Method(method) => stroke(method),
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Optimum => "optimum",
            Self::Method(Method::SlidingModeImplicit) => "sliding mode (implicit)",
            Self::Method(method) => label(method),
        }
    }
}

impl NamedCourse {
    fn points(&self, value: impl Fn(&CourseSample) -> f64) -> Vec<Point> {
        self.course.samples.iter().map(|s| (s.lambda, value(s))).collect()
    }
}

/// A legend of all courses, each with a value in brackets.
fn legend(study: &CourseStudy, value: impl Fn(&NamedCourse) -> String) -> Vec<Entry> {
    study.courses.iter().map(|c| entry(&format!("{} ({})", c.law.name(), value(c)), c.law.stroke())).collect()
}
