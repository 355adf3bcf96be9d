//! dλ/dt against λ and against time (`[G11]` Fig. 5, top, and Fig. 9): how near the regulated speed comes to the optimum.

use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::{header, motion_start, rate_ceiling, reference_entry, travel_meaning, travel_ratio};
use crate::polyline::Point;
use crate::render::Figure;
use crate::scale::{Axis, span};
use crate::stack::{self, Layer};
use crate::study::{Checked, Run};
use crate::style::{REFERENCE, label, stroke};
use plotters::backend::DrawingBackend;

/// Path rate against the path parameter.
pub(crate) struct PathRate<'a>(pub(crate) &'a Checked<'a>);

/// Path rate against time.
pub(crate) struct PathRateOverTime<'a>(pub(crate) &'a Checked<'a>);

/// Height of a panel, design units: of the only one, or of each of several.
fn panel_height(panels: usize) -> f64 {
    if panels == 1 { 450.0 } else { 262.0 }
}

/// The optimum under each regulated method; the fixed speeds, which have no shape to compare, in every panel.
fn layers(checked: &Checked, optimum: &[Point], curve: fn(&Run) -> Vec<Point>) -> Vec<Layer> {
    let fixed: Vec<&Run> = checked.runs.iter().filter(|run| !run.method.is_regulated()).collect();
    let regulated: Vec<&Run> = checked.regulated().collect();
    let layer = |run: Option<&&Run>| {
        let mut curves = vec![(optimum.to_vec(), REFERENCE)];
        let shown = fixed.iter().chain(run);
        curves.extend(shown.map(|run| (curve(run), stroke(run.method))));
        let title = run.map(|run| label(run.method).to_owned()).unwrap_or_default();
        let y = Axis::linear("dλ/dt (1/s)", 0.0..rate_ceiling(checked), if regulated.len() > 1 { 4 } else { 6 });
        Layer { title, y, levels: Vec::new(), curves }
    };
    if regulated.is_empty() { vec![layer(None)] } else { regulated.iter().map(|run| layer(Some(run))).collect() }
}

/// Rate against path parameter up to the last motion: a reference at rest on the path's end has no rate to show.
fn against_lambda(run: &Run) -> Vec<Point> {
    let following = run.following();
    let end = following.iter().rposition(|s| s.path_rate > 0.0).map_or(0, |last| last + 1);
    following[..end].iter().map(|s| (s.lambda, s.path_rate)).collect()
}

fn panels(checked: &Checked) -> usize {
    checked.regulated().count().max(1)
}

fn with_optimum(checked: &Checked, mut header: Header) -> Header {
    if checked.study.optimum.is_some() {
        header.legend.insert(0, reference_entry("optimum"));
    }
    header
}

impl Figure for PathRate<'_> {
    const NAME: &'static str = "path-rate";

    fn caption(&self) -> String {
        format!(
            "{}: path rate dλ/dt against the path parameter λ, one panel for each regulated method; the broad line is the \
             offline optimum. Travel time runs from the start of motion to the robot's arrival within 0.1 mm and 1 mrad; \
             the methods may use such errors, the optimum has none.{}",
            self.0.study.title,
            self.0.remark()
        )
    }

    fn header(&self) -> Header {
        let value = |run: &Run| travel_ratio(self.0, run);
        let header = header(self.0, "Path rate along the path", &travel_meaning(self.0), &self.0.runs, value);
        with_optimum(self.0, header)
    }

    fn body_height(&self) -> f64 {
        stack::height(panels(self.0), panel_height(panels(self.0)))
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let optimum = self.0.study.optimum.map(|o| o.against_lambda()).unwrap_or_default();
        let followed = self.0.runs.iter().flat_map(|run| run.following()).map(|s| s.lambda);
        let x = Axis::linear("path parameter λ", span(followed.chain(optimum.iter().map(|p| p.0))), 8);
        stack::draw(canvas, &x, layers(self.0, &optimum, against_lambda), panel_height(panels(self.0)))
    }
}

impl Figure for PathRateOverTime<'_> {
    const NAME: &'static str = "path-rate-time";

    fn caption(&self) -> String {
        let optimum = if self.0.study.optimum.is_some() {
            " The optimum (broad line) begins where the earliest regulated method starts to move."
        } else {
            ""
        };
        format!(
            "{}: path rate dλ/dt against time, one panel for each regulated method.{optimum} The robot has arrived when it \
             is within 0.1 mm and 1 mrad of the path's end.{}",
            self.0.study.title,
            self.0.time_remark()
        )
    }

    fn header(&self) -> Header {
        let arrival = |run: &Run| Some(run.trace.arrival_s.map_or("never".to_owned(), |t| format!("{t:.3} s")));
        let header = header(self.0, "Path rate over time", "when the robot arrives", &self.0.runs, arrival);
        with_optimum(self.0, header)
    }

    fn body_height(&self) -> f64 {
        stack::height(panels(self.0), panel_height(panels(self.0)))
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let optimum = self.0.study.optimum.map(|o| o.against_time(motion_start(self.0))).unwrap_or_default();
        let x = Axis::linear("time (s)", 0.0..self.0.end(), 7);
        let layers = layers(self.0, &optimum, |run| run.against_time(|s| s.path_rate));
        stack::draw(canvas, &x, layers, panel_height(panels(self.0)))
    }
}
