//! dλ/dt against λ and against time (`[G11]` Fig. 5, top, and Fig. 9): how near the regulated speed comes to the optimum.

use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::{entry, header, motion_start, rate_ceiling, reference_entry, travel_meaning, travel_ratio};
use crate::polyline::Point;
use crate::render::Figure;
use crate::scale::{Axis, span};
use crate::stack::{self, Layer};
use crate::study::{Checked, Optimum, Run};
use crate::style::{GAP, LIMIT, REFERENCE, Stroke, label, stroke};
use plotters::backend::DrawingBackend;

/// Path rate against the path parameter.
pub(crate) struct PathRate<'a>(pub(crate) &'a Checked<'a>);

/// Path rate against time.
pub(crate) struct PathRateOverTime<'a>(pub(crate) &'a Checked<'a>);

/// Height of a panel, design units: of the only one, or of each of several.
fn panel_height(panels: usize) -> f64 {
    if panels == 1 { 450.0 } else { 262.0 }
}

/// The optimum and what belongs to it under each regulated method; the fixed speeds, which have no shape to compare, in every panel.
fn layers(checked: &Checked, under: &[(Vec<Point>, Stroke)], curve: fn(&Run) -> Vec<Point>) -> Vec<Layer> {
    let fixed: Vec<&Run> = checked.runs.iter().filter(|run| !run.method.is_regulated()).collect();
    let regulated: Vec<&Run> = checked.regulated().collect();
    let layer = |run: Option<&&Run>| {
        let mut curves = under.to_vec();
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

/// The limit curve, the cells that hold the gap on the axis below it, and the optimum.
fn optimum_curves(optimum: &Optimum) -> Vec<(Vec<Point>, Stroke)> {
    let [first, last] = [optimum.lambda.first(), optimum.lambda.last()].map(|l| l.copied().unwrap_or(0.0));
    // Cells are often narrower than a line is broad.
    let least = 2e-3 * (last - first);
    let mark = |[from, to]: &[f64; 2]| {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from).max(least));
        (vec![(middle - half, 0.0), (middle + half, 0.0)], GAP)
    };
    let cells = optimum.gap_cells.iter().map(mark);
    let limit = (optimum.limit_against_lambda(), LIMIT);
    std::iter::once((optimum.against_lambda(), REFERENCE)).chain([limit]).chain(cells).collect()
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
        let mut header = with_optimum(self.0, header);
        let optimum = self.0.study.optimum;
        if optimum.is_some_and(|o| !o.rate_limit.is_empty()) {
            header.legend.insert(1, entry("largest rate that the limits leave", LIMIT));
        }
        if optimum.is_some_and(|o| !o.gap_cells.is_empty()) {
            header.legend.insert(2, entry("where the bounds of the optimum are farthest apart", GAP));
        }
        header
    }

    fn body_height(&self) -> f64 {
        stack::height(panels(self.0), panel_height(panels(self.0)))
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let optimum = self.0.study.optimum.map(optimum_curves).unwrap_or_default();
        let followed = self.0.runs.iter().flat_map(|run| run.following()).map(|s| s.lambda);
        let of_optimum = self.0.study.optimum.into_iter().flat_map(|o| o.lambda.iter().copied());
        let x = Axis::linear("path parameter λ", span(followed.chain(of_optimum)), 8);
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
        let layers = layers(self.0, &[(optimum, REFERENCE)], |run| run.against_time(|s| s.path_rate));
        stack::draw(canvas, &x, layers, panel_height(panels(self.0)))
    }
}
