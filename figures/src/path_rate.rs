//! dλ/dt against λ: how near the regulated speed comes to the optimum.

use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::{header, rate_ceiling, travel_ratios};
use crate::panel::{Frame, Panel};
use crate::render::Figure;
use crate::scale::{Axis, span};
use crate::study::Checked;
use crate::style::{REFERENCE, stroke};
use plotters::backend::DrawingBackend;

pub(crate) struct PathRate<'a>(pub(crate) &'a Checked<'a>);

impl Figure for PathRate<'_> {
    const NAME: &'static str = "path-rate";

    fn caption(&self) -> String {
        format!(
            "{}: path rate dλ/dt against the path parameter λ, with the offline optimum under the same limits as the broad \
             line. Travel time runs from the start of motion to the robot's arrival.{}",
            self.0.study.title,
            self.0.remark()
        )
    }

    fn header(&self) -> Header {
        let message = travel_ratios(self.0).unwrap_or_default();
        header(self.0, message, self.0.study.optimum.map(|_| "optimum"), &self.0.runs)
    }

    fn body_height(&self) -> f64 {
        540.0
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let lambdas = self.0.runs.iter().flat_map(|run| run.following()).map(|s| s.lambda);
        let optimum = self.0.study.optimum;
        let x = Axis::linear(
            "path parameter λ",
            span(lambdas.chain(optimum.into_iter().flat_map(|o| o.lambda.iter().copied()))),
            8,
        );
        let y = Axis::linear("path rate dλ/dt (1/s)", 0.0..rate_ceiling(self.0), 6);
        let panel = Panel::new(canvas, &Frame::LABELLED, x, y)?;
        if let Some(optimum) = optimum {
            panel.curve(&optimum.against_lambda(), &REFERENCE)?;
        }
        for run in &self.0.runs {
            let points: Vec<_> = run.following().iter().map(|s| (s.lambda, s.path_rate)).collect();
            panel.curve(&points, &stroke(run.method))?;
        }
        Ok(())
    }
}
