//! Trap avoidance: the reference's pace and the walk (the quantities of `[G12]` Fig. 6, 8, 10).

use super::facts::header;
use super::study::{Checked, PathRun, Unit, roomy};
use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::reference_entry;
use crate::polyline::Point;
use crate::render::Figure;
use crate::scale::Axis;
use crate::stack::{self, Layer};
use crate::style::{REFERENCE, Stroke, path_label, path_stroke};
use plotters::backend::DrawingBackend;
use slideway_lab::conditioning::{ConditionedSample, Phase};

pub(crate) struct Trap<'a> {
    checked: &'a Checked<'a>,
    runs: Vec<&'a PathRun<'a>>,
}

const PACE: f64 = 170.0;

fn walked(s: &ConditionedSample) -> f64 {
    s.walk.iter().map(|x| x * x).sum::<f64>().sqrt()
}

impl<'a> Trap<'a> {
    /// Nothing where no trap acted.
    pub(crate) fn new(checked: &'a Checked<'a>) -> Option<Self> {
        let runs: Vec<_> = checked.runs.iter().filter(|run| run.is_trapped()).collect();
        (!runs.is_empty()).then_some(Self { checked, runs })
    }

    /// Rate of the reference over time, as a share of its rate without a trap.
    fn pace(&self, run: &PathRun) -> Vec<Point> {
        let reference = &self.checked.study.problem.reference;
        let rate = reference.lambda(1.0) - reference.lambda(0.0);
        let pace = |w: &[ConditionedSample]| (w[0].t, (w[1].lambda - w[0].lambda) / (rate * (w[1].t - w[0].t)));
        run.samples.windows(2).map(pace).collect()
    }

    fn layers(&self, run: &PathRun) -> [Layer; 2] {
        let range = roomy(self.runs.iter().flat_map(|run| run.samples).map(walked));
        let range = 0.0..range.end;
        let unit = Unit::of(&range);
        let solid = Stroke { width: 4.0, dashes: &[], ..path_stroke(run.method) };
        let name = path_label(run.method);
        [
            Layer {
                title: format!("{name}: pace of the reference"),
                y: Axis::linear("of full", 0.0..1.1, 2),
                levels: Vec::new(),
                curves: vec![(stops(run, 0.04), REFERENCE), (self.pace(run), solid)],
            },
            Layer {
                title: format!("{name}: length of the walk"),
                y: Axis::linear(unit.name, unit.scale(&range), 3),
                levels: Vec::new(),
                curves: vec![(run.against_time(unit.apply(walked)), solid)],
            },
        ]
    }
}

/// A bar over the stretches in which the reference is stopped.
fn stops(run: &PathRun, height: f64) -> Vec<Point> {
    run.against_time(|s| if s.phase == Phase::Trapped { height } else { f64::NAN })
}

/// Time for which the reference was stopped, in words.
fn stopped(run: &PathRun) -> String {
    match run.summary.escape_s {
        Some(time) => format!("{time:.2} s"),
        None => "not freed".to_owned(),
    }
}

impl Figure for Trap<'_> {
    const NAME: &'static str = "trap";

    fn caption(&self) -> String {
        format!(
            "{}: trap avoidance. The reference waits (bar; its pace drops to 0) while the walk leads the conditioned \
             reference out and back to it. The walk is random; another seed takes another time.{}",
            self.checked.study.title,
            self.checked.time_remark()
        )
    }

    fn header(&self) -> Header {
        let runs = self.runs.iter().copied();
        let meaning = "how long the trap stopped the reference";
        let mut header = header(self.checked, "Trap", meaning, runs, |run| Some(stopped(run)));
        header.legend.iter_mut().for_each(|entry| entry.stroke.dashes = &[]);
        header.legend.push(reference_entry("reference stopped"));
        header
    }

    fn body_height(&self) -> f64 {
        stack::height(2 * self.runs.len(), PACE)
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let layers = self.runs.iter().flat_map(|run| self.layers(run)).collect();
        stack::draw(canvas, &Axis::linear("time (s)", 0.0..self.checked.end(), 7), layers, PACE)
    }
}
