//! Path speed against the path parameter: what each law makes of the same limits.

use super::{CourseStudy, legend};
use crate::canvas::{Canvas, Drawn, Header};
use crate::panel::{Frame, Panel};
use crate::render::Figure;
use crate::scale::{Axis, largest, significant, span};
use plotters::backend::DrawingBackend;

pub(super) struct PathSpeed<'a>(pub(super) &'a CourseStudy<'a>);

impl Figure for PathSpeed<'_> {
    const NAME: &'static str = "laws-path-speed";

    fn caption(&self) -> String {
        format!(
            "{}: path speed against the path parameter under the same joint-speed limits, by constant speed, natural motion, \
             the sliding mode and the time optimum. Natural motion slows down in proportion to the speed factor, constant \
             speed is as slow everywhere as the worst place asks for.",
            self.0.title
        )
    }

    fn header(&self) -> Header {
        Header {
            heading: format!("Speed along the path – {}", self.0.title),
            message: "In brackets: time on the path.".into(),
            legend: legend(self.0, |c| format!("{} s", significant(c.course.seconds(), 4))),
        }
    }

    fn body_height(&self) -> f64 {
        560.0
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let samples = || self.0.courses.iter().flat_map(|c| &c.course.samples);
        let x = Axis::linear("path parameter λ", span(samples().map(|s| s.lambda)), 8);
        let top = 1.06 * largest(samples().map(|s| s.path_rate));
        let panel = Panel::new(canvas, &Frame::LABELLED, x, Axis::linear("dλ/dt (1/s)", 0.0..top, 6))?;
        self.0.courses.iter().try_for_each(|c| panel.curve(&c.points(|s| s.path_rate), &c.law.stroke()))
    }
}
