//! Figures of several laws on one path.

use slideway_figures::{
    CourseLaw, CourseStudy, FigureError, MeanSpeedLine, MeanSpeedStudy, NamedCourse, draw_courses, draw_mean_speed,
};
use slideway_lab::{Course, CourseSample, Method};

/// A joint that speeds up and slows down, with or without a torque.
fn course(torque: Option<f64>) -> Course {
    let sample = |i: u32| {
        let lambda = f64::from(i) / 100.0;
        let speed = [lambda.sin(), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let torque = torque.map(|t| speed.map(|v| t * v));
        CourseSample { t: lambda, dt: 0.01, lambda, path_rate: 1.0 + lambda, speed, acceleration: speed, torque }
    };
    Course { joints: 1, path: 0.0..6.0, settled_s: 0.0, samples: (0..600).map(sample).collect() }
}

fn courses(torque: Option<f64>) -> Vec<NamedCourse> {
    [CourseLaw::Optimum, CourseLaw::Method(Method::NaturalMotion)]
        .map(|law| NamedCourse { law, course: course(torque) })
        .to_vec()
}

fn names(courses: &[NamedCourse]) -> Result<Vec<&'static str>, FigureError> {
    let dir = tempfile::tempdir().expect("folder");
    let study = CourseStudy { title: "test", courses, speed_lower: &[-1.0], speed_upper: &[1.0] };
    Ok(draw_courses(&study, dir.path())?.iter().map(|figure| figure.name).collect())
}

#[test]
fn torques_are_drawn_where_they_are_known() -> Result<(), FigureError> {
    assert_eq!(names(&courses(None))?, ["laws-path-speed", "laws-joint-speeds"]);
    assert_eq!(names(&courses(Some(3.0)))?, ["laws-path-speed", "laws-joint-speeds", "laws-joint-torques"]);
    Ok(())
}

#[test]
fn what_cannot_be_drawn_is_an_error() {
    assert!(matches!(names(&[]), Err(FigureError::NoTraces)));
    let mut broken = courses(None);
    broken[1].course.samples[7].speed[0] = f64::NAN;
    assert!(matches!(names(&broken), Err(FigureError::Value { index: 7, .. })));
    let mut many = courses(None);
    many[0].course.joints = 2;
    assert!(matches!(names(&many), Err(FigureError::Length { expected: 2, found: 1, .. })));
}

#[test]
fn mean_speeds_are_drawn_with_their_share_of_the_optimum() -> Result<(), FigureError> {
    let dir = tempfile::tempdir().expect("folder");
    let line = |law, slope: f64| MeanSpeedLine { law, points: vec![(1.0, slope), (2.0, 2.0 * slope)] };
    let lines = [line(CourseLaw::Optimum, 1.0), line(CourseLaw::Method(Method::ConstantSpeed), 0.25)];
    let figure = draw_mean_speed(&MeanSpeedStudy { title: "test", lines: &lines }, dir.path())?;
    assert!(figure.svg.contains("constant speed (0.250)"));
    let bad = [MeanSpeedLine { law: CourseLaw::Optimum, points: vec![(1.0, 1.0), (2.0, f64::NAN)] }];
    let refused = draw_mean_speed(&MeanSpeedStudy { title: "test", lines: &bad }, dir.path());
    assert!(matches!(refused, Err(FigureError::Value { index: 1, .. })));
    Ok(())
}
