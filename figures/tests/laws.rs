//! Figures of several laws on one path.

use slideway_figures::{
    CourseLaw, CourseStudy, FigureError, MeanSpeedLine, MeanSpeedStudy, ModelErrorOfLaw, ModelErrorStudy, NamedCourse,
    draw_courses, draw_mean_speed, draw_model_error,
};
use slideway_lab::natural::{ModelErrorRun, ModelErrorSample};
use slideway_lab::{Course, CourseSample, JointUnits, Method};

/// A joint that speeds up and slows down, with or without a torque.
fn course(torque: Option<f64>) -> Course {
    let sample = |i: u32| {
        let lambda = f64::from(i) / 100.0;
        let speed = [lambda.sin(), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let torque = torque.map(|t| speed.map(|v| t * v));
        CourseSample { t: lambda, dt: 0.01, lambda, path_rate: 1.0 + lambda, speed, acceleration: speed, torque }
    };
    Course {
        joints: 1,
        units: [JointUnits::TURNING; 7],
        path: 0.0..6.0,
        settled_s: 0.0,
        start: [0.0; 7],
        samples: (0..600).map(sample).collect(),
    }
}

fn courses(torque: Option<f64>) -> Vec<NamedCourse> {
    [CourseLaw::Optimum, CourseLaw::Method(Method::NaturalMotion)]
        .map(|law| NamedCourse { law, course: course(torque) })
        .to_vec()
}

fn names(courses: &[NamedCourse]) -> Result<Vec<&'static str>, FigureError> {
    let dir = tempfile::tempdir().expect("folder");
    let study = CourseStudy {
        title: "test",
        joint_names: &["elbow".to_owned()],
        courses,
        speed_lower: &[-1.0],
        speed_upper: &[1.0],
    };
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

#[test]
fn errors_of_a_wrong_model_are_drawn_with_both_peaks_in_millimetres() -> Result<(), FigureError> {
    let dir = tempfile::tempdir().expect("folder");
    let run = |peak: f64| ModelErrorRun {
        samples: [0.0, 0.5, 1.0].map(|t| ModelErrorSample { t, lambda: t, distance: t * peak }).to_vec(),
    };
    let law = CourseLaw::Method(Method::NaturalMotion);
    let mut laws = [ModelErrorOfLaw { law, at_limits: run(0.01), in_equal_time: run(0.002) }];
    let figure = draw_model_error(&ModelErrorStudy { title: "test", share: 0.1, laws: &laws }, dir.path())?;
    assert!(figure.svg.contains("natural motion (10.0; 2.00 mm)"));
    assert!(figure.caption.contains("10 %"));
    laws[0].at_limits.samples[1].distance = f64::NAN;
    let refused = draw_model_error(&ModelErrorStudy { title: "test", share: 0.1, laws: &laws }, dir.path());
    assert!(matches!(refused, Err(FigureError::Value { index: 1, .. })));
    Ok(())
}

#[test]
fn without_any_error_the_figure_is_still_drawn() -> Result<(), FigureError> {
    let dir = tempfile::tempdir().expect("folder");
    let still = ModelErrorRun { samples: vec![ModelErrorSample { t: 0.0, lambda: 0.0, distance: 0.0 }; 2] };
    let laws = [ModelErrorOfLaw { law: CourseLaw::Optimum, at_limits: still.clone(), in_equal_time: still }];
    let figure = draw_model_error(&ModelErrorStudy { title: "test", share: 0.1, laws: &laws }, dir.path())?;
    assert!(figure.svg.contains("optimum (0; 0 mm)"));
    Ok(())
}
