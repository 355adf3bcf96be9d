//! Distance from the reference over time, against the least that the constraints allow.

use super::facts::{header, length};
use super::study::{Checked, PathRun, Unit, roomy};
use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::reference_entry;
use crate::polyline::Point;
use crate::render::Figure;
use crate::scale::Axis;
use crate::stack::{self, Layer};
use crate::style::{REFERENCE, Stroke, path_label, path_stroke};
use plotters::backend::DrawingBackend;
use slideway_lab::conditioning::{ConditionedSample, PathMethod};

pub(crate) struct Deviation<'a>(pub(crate) &'a Checked<'a>);

impl<'a> Deviation<'a> {
    /// All methods but the projection, which is every panel's broad line; alone it is drawn itself.
    fn runs(&self) -> Vec<&PathRun<'a>> {
        let others: Vec<_> = self.0.runs.iter().filter(|run| run.method != PathMethod::Projection).collect();
        if others.is_empty() { self.0.runs.iter().collect() } else { others }
    }

    /// The projection's distance where the run's reference is, on the run's clock.
    fn best(&self, run: &PathRun) -> Vec<Point> {
        let Some(projection) = self.0.run(PathMethod::Projection) else { return Vec::new() };
        let at = |lambda: f64| {
            let samples = projection.samples;
            let after = samples.partition_point(|s| s.lambda < lambda - 1e-12).min(samples.len() - 1);
            samples[after].deviation()
        };
        run.samples.iter().map(|s| (s.t, at(s.lambda))).collect()
    }

    fn layer(&self, run: &PathRun) -> Layer {
        let range = roomy(self.0.shown().map(ConditionedSample::deviation));
        let range = 0.0..range.end;
        let unit = Unit::of(&range);
        let best: Vec<Point> = self.best(run).into_iter().map(|p| (p.0, unit.factor * p.1)).collect();
        let solid = Stroke { width: 4.5, dashes: &[], ..path_stroke(run.method) };
        Layer {
            title: format!("{}: mean {}", path_label(run.method), mean(run).unwrap_or_default()),
            y: Axis::linear(unit.name, unit.scale(&range), 3),
            levels: Vec::new(),
            curves: vec![(best, REFERENCE), (run.against_time(unit.apply(ConditionedSample::deviation)), solid)],
        }
    }

    fn panel_height(&self) -> f64 {
        if self.runs().len() == 1 { 450.0 } else { 205.0 }
    }
}

fn mean(run: &PathRun) -> Option<String> {
    length(run.summary.mean_deviation_m, 3)
}

impl Figure for Deviation<'_> {
    const NAME: &'static str = "deviation";

    fn caption(&self) -> String {
        let best = if self.0.run(PathMethod::Projection).is_some() {
            " The broad line is the projection's distance at the same point of the reference, the nearest \
             allowed point that was found."
        } else {
            ""
        };
        format!(
            "{}: distance of the conditioned reference from the reference over time.{best} Means are over each run's own \
             duration.{}",
            self.0.study.title,
            self.0.time_remark()
        )
    }

    fn header(&self) -> Header {
        // The panels' titles take the place of the legend.
        let header = header(self.0, "Deviation", "", [], mean);
        let best = self.0.run(PathMethod::Projection).and_then(mean);
        let best = best.map(|value| reference_entry(&format!("projection of the reference, mean {value}")));
        let message = "Distance from the reference.".to_owned();
        Header { message, legend: best.into_iter().collect(), ..header }
    }

    fn body_height(&self) -> f64 {
        stack::height(self.runs().len(), self.panel_height())
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let layers = self.runs().into_iter().map(|run| self.layer(run)).collect();
        stack::draw(canvas, &Axis::linear("time (s)", 0.0..self.0.end(), 7), layers, self.panel_height())
    }
}
