//! dλ/dt against time (the quantity of `[G11]` Fig. 5, top, and Fig. 9).

use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::{header, motion_start, per_run, rate_ceiling};
use crate::panel::{Frame, Panel};
use crate::render::Figure;
use crate::scale::Axis;
use crate::study::Checked;
use crate::style::{REFERENCE, stroke};
use plotters::backend::DrawingBackend;

pub(crate) struct PathRateOverTime<'a>(pub(crate) &'a Checked<'a>);

impl Figure for PathRateOverTime<'_> {
    const NAME: &'static str = "path-rate-time";

    fn caption(&self) -> String {
        let optimum = if self.0.study.optimum.is_some() {
            " The optimum (broad line) is placed at the start of motion of the earliest regulated method."
        } else {
            ""
        };
        format!("{}: path rate dλ/dt against time.{optimum}{}", self.0.study.title, self.0.remark())
    }

    fn header(&self) -> Header {
        let arrival = per_run(&self.0.runs, |run| {
            Some(run.trace.arrival_s.map_or_else(|| "never".to_owned(), |t| format!("{t:.3} s")))
        });
        header(self.0, format!("Robot arrives: {arrival}."), self.0.study.optimum.map(|_| "optimum"), &self.0.runs)
    }

    fn body_height(&self) -> f64 {
        540.0
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let x = Axis::linear("time (s)", 0.0..self.0.end(), 7);
        let y = Axis::linear("path rate dλ/dt (1/s)", 0.0..rate_ceiling(self.0), 6);
        let panel = Panel::new(canvas, &Frame::LABELLED, x, y)?;
        if let Some(optimum) = self.0.study.optimum {
            panel.curve(&optimum.against_time(motion_start(self.0)), &REFERENCE)?;
        }
        for run in &self.0.runs {
            panel.curve(&run.against_time(|s| s.path_rate), &stroke(run.method))?;
        }
        Ok(())
    }
}
