//! Distance of the tool from where each law has it under a controller with a wrong model, as in `[N] Fig. 3`.

use super::CourseLaw;
use crate::canvas::{Canvas, Drawn, Header};
use crate::error::FigureError;
use crate::facts::entry;
use crate::polyline::Point;
use crate::render::{Figure, Rendered, make_directory, render};
use crate::scale::{Axis, largest, significant, span};
use crate::stack::{self, Layer};
use plotters::backend::DrawingBackend;
use slideway_lab::natural::{ModelErrorRun, ModelErrorSample};
use std::path::Path;

/// Errors of several laws on one path under a wrong model.
#[derive(Clone, Copy, Debug)]
pub struct ModelErrorStudy<'a> {
    /// Heading of the figure: the scenario, in a few words.
    pub title: &'a str,
    /// By what share the masses are wrong.
    pub share: f64,
    /// One entry for each law; what comes later lies on top.
    pub laws: &'a [ModelErrorOfLaw],
}

/// Errors of one law under a wrong model.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelErrorOfLaw {
    /// The law.
    pub law: CourseLaw,
    /// Run as fast as the limits allow.
    pub at_limits: ModelErrorRun,
    /// Run in the time that the slowest of the laws takes.
    pub in_equal_time: ModelErrorRun,
}

/// Draws the tool's error against the path parameter, at the limits and in equal time.
///
/// # Errors
///
/// No law, one without samples or with a value that is not finite, or files that cannot be written.
pub fn draw_model_error(study: &ModelErrorStudy, dir: &Path) -> Result<Rendered, FigureError> {
    crate::style::register_fonts()?;
    if study.laws.is_empty() {
        return Err(FigureError::NoTraces);
    }
    for run in study.laws.iter().flat_map(|l| [&l.at_limits, &l.in_equal_time]) {
        if run.samples.is_empty() {
            return Err(FigureError::Length { what: "samples of a model's error", expected: 1, found: 0 });
        }
        let broken = |s: &ModelErrorSample| !(s.lambda.is_finite() && s.distance.is_finite());
        if let Some(index) = run.samples.iter().position(broken) {
            return Err(FigureError::Value { what: "samples of a model's error", index });
        }
    }
    make_directory(dir)?;
    render(&ModelError(study), dir)
}

struct ModelError<'a>(&'a ModelErrorStudy<'a>);

/// Height of a panel without the labels below, design units.
const PANEL: f64 = 330.0;

/// Metres to millimetres.
const MILLI: f64 = 1e3;

/// Chooses the run of a law that a panel shows.
type Pick = fn(&ModelErrorOfLaw) -> &ModelErrorRun;

impl ModelError<'_> {
    fn layer(&self, title: &str, pick: Pick) -> Layer {
        let top = MILLI * largest(self.0.laws.iter().map(|l| pick(l).peak()));
        let points = |run: &ModelErrorRun| -> Vec<Point> {
            run.samples.iter().map(|s| (s.lambda, MILLI * s.distance)).collect()
        };
        Layer {
            title: title.into(),
            // Without any error at all the axis still needs a length.
            y: Axis::linear("error (mm)", 0.0..(1.06 * top).max(1e-6), 5),
            levels: Vec::new(),
            curves: self.0.laws.iter().map(|l| (points(pick(l)), l.law.stroke())).collect(),
        }
    }
}

impl Figure for ModelError<'_> {
    const NAME: &'static str = "laws-model-error";

    fn caption(&self) -> String {
        format!(
            "{}: distance of the tool from where each law has it, followed by computed torque (poles at −10 1/s) with a model whose \
             links are too heavy and too light by {} %, by turns from the base. Above at the same joint-speed limits, where a \
             faster law leaves the controller more to miss; below all in the time of the slowest.",
            self.0.title,
            significant(100.0 * self.0.share, 2)
        )
    }

    fn header(&self) -> Header {
        let peak = |run: &ModelErrorRun| significant(MILLI * run.peak(), 3);
        let name =
            |l: &ModelErrorOfLaw| format!("{} ({}; {} mm)", l.law.name(), peak(&l.at_limits), peak(&l.in_equal_time));
        Header {
            heading: format!("Tool error under a wrong model – {}", self.0.title),
            message: "In brackets: peak error at the limits; in equal time.".into(),
            legend: self.0.laws.iter().map(|l| entry(&name(l), l.law.stroke())).collect(),
        }
    }

    fn body_height(&self) -> f64 {
        stack::height(2, PANEL)
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let samples = self.0.laws.iter().flat_map(|l| &l.at_limits.samples);
        let x = Axis::linear("path parameter λ", span(samples.map(|s| s.lambda)), 8);
        let layers = vec![
            self.layer("as fast as the joint-speed limits allow", |l| &l.at_limits),
            self.layer("all in the time of the slowest", |l| &l.in_equal_time),
        ];
        stack::draw(canvas, &x, layers, PANEL)
    }
}
