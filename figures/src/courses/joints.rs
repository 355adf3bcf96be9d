//! Joint speeds and torques against the path parameter, one panel for each joint.

use super::{CourseStudy, NamedCourse, legend};
use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::limit_entry;
use crate::multiples;
use crate::panel::{Frame, Panel};
use crate::render::Figure;
use crate::scale::{Axis, largest, significant, span};
use crate::style::{LIMIT, Stroke};
use plotters::backend::DrawingBackend;
use slideway_lab::{CourseSample, JointUnits};
use std::ops::Range;

/// Joint speeds with their limits.
pub(super) struct JointSpeedsAlongPath<'a>(pub(super) &'a CourseStudy<'a>);

/// Joint torques.
pub(super) struct JointTorquesAlongPath<'a>(pub(super) &'a CourseStudy<'a>);

impl Figure for JointSpeedsAlongPath<'_> {
    const NAME: &'static str = "laws-joint-speeds";

    fn caption(&self) -> String {
        format!(
            "{}: joint speeds against the path parameter under the same limits (dashed). The optimum and the sliding mode keep \
             some joint at its limit, natural motion and constant speed reach a limit at one place.",
            self.0.title
        )
    }

    fn header(&self) -> Header {
        let share = |c: &NamedCourse| format!("{:.0} %", 100.0 * share_at_limit(self.0, c));
        let mut legend = legend(self.0, share);
        legend.push(limit_entry("limits"));
        Header {
            heading: format!("Joint speeds along the path – {}", self.0.title),
            message: "In brackets: share of the time with a joint within 1 % of its limit.".into(),
            legend,
        }
    }

    fn body_height(&self) -> f64 {
        multiples::height(joints(self.0))
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let levels = |joint: usize| vec![self.0.speed_lower[joint], self.0.speed_upper[joint]];
        draw(self.0, canvas, |units| units.speed, levels, |s, joint| s.speed[joint])
    }
}

impl Figure for JointTorquesAlongPath<'_> {
    const NAME: &'static str = "laws-joint-torques";

    fn caption(&self) -> String {
        format!(
            "{}: rigid-body torques against the path parameter under the same joint-speed limits. Torque grows with the square of \
             the speed: what is faster needs more, and constant speed needs its peak at one place.",
            self.0.title
        )
    }

    fn header(&self) -> Header {
        let peak = |c: &NamedCourse| {
            let peak = c.course.effort().and_then(|e| e.peak_torque);
            format!("{} N·m", peak.map_or("-".into(), |t| significant(t, 3)))
        };
        Header {
            heading: format!("Joint torques along the path – {}", self.0.title),
            message: "In brackets: peak torque once under way.".into(),
            legend: legend(self.0, peak),
        }
    }

    fn body_height(&self) -> f64 {
        multiples::height(joints(self.0))
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        draw(self.0, canvas, |units| units.load, |_| Vec::new(), |s, joint| s.torque.map_or(0.0, |t| t[joint]))
    }
}

/// Units of a joint: all courses are of one arm.
fn units(study: &CourseStudy, joint: usize) -> JointUnits {
    let units = study.courses.iter().max_by_key(|c| c.course.joints).and_then(|c| c.course.units.get(joint));
    units.copied().unwrap_or(JointUnits::TURNING)
}

fn joints(study: &CourseStudy) -> usize {
    study.courses.iter().map(|c| c.course.joints).max().unwrap_or(0)
}

/// Share of the time in which some joint is within 1 % of its limit.
fn share_at_limit(study: &CourseStudy, named: &NamedCourse) -> f64 {
    let limits = || study.speed_lower.iter().zip(study.speed_upper);
    let is_at =
        |s: &&CourseSample| s.speed.iter().zip(limits()).any(|(v, (lower, upper))| (v / upper).max(v / lower) >= 0.99);
    named.course.samples.iter().filter(is_at).map(|s| s.dt).sum::<f64>() / named.course.seconds()
}

/// Range of a panel: all of what happens once a law is under way.
fn range(study: &CourseStudy, joint: usize, levels: &[f64], value: impl Fn(&CourseSample, usize) -> f64) -> Range<f64> {
    let values = study.courses.iter().flat_map(|c| c.course.under_way()).map(|s| value(s, joint));
    let range = span(values.chain(levels.iter().copied()));
    let room = 0.08 * (range.end - range.start).max(1e-9 * largest([range.end, -range.start]));
    range.start - room..range.end + room
}

fn draw<DB: DrawingBackend>(
    study: &CourseStudy,
    canvas: &Canvas<DB>,
    unit: impl Fn(JointUnits) -> &'static str,
    levels: impl Fn(usize) -> Vec<f64>,
    value: impl Fn(&CourseSample, usize) -> f64 + Copy,
) -> Drawn<DB> {
    let parameters = study.courses.iter().flat_map(|c| &c.course.samples).map(|s| s.lambda);
    let x = Axis::linear("path parameter λ", span(parameters), 4);
    multiples::place(canvas, joints(study), |place, joint, bottom| {
        let x = if bottom > Frame::TICKS { x.clone() } else { x.unlabelled() };
        let levels = levels(joint);
        let y = Axis::linear(unit(units(study, joint)), range(study, joint, &levels, value), 4);
        let panel = Panel::new(place, &Frame { title: &study.joint_names[joint], bottom, ..Frame::LABELLED }, x, y)?;
        for level in levels {
            panel.level(level, &LIMIT)?;
        }
        for named in study.courses {
            let full = named.law.stroke();
            // Small panels want thinner lines.
            panel.curve(&named.points(|s| value(s, joint)), &Stroke { width: 0.75 * full.width, ..full })?;
        }
        Ok(())
    })
}
