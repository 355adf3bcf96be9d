//! The push and the correction that it makes (the quantities of `[G12]` Fig. 4, 6, 8, 10, top).

use super::facts::{header, mean_length};
use super::study::{Checked, PathRun, Unit, roomy};
use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::limit_entry;
use crate::render::Figure;
use crate::scale::{Axis, significant};
use crate::stack::{self, Layer};
use crate::style::{LIMIT, path_stroke};
use plotters::backend::DrawingBackend;
use slideway_conditioner::path::SwitchingLaw;
use slideway_lab::conditioning::{ConditionedSample, PathMethod};

pub(crate) struct Push<'a>(pub(crate) &'a Checked<'a>);

const PANEL: f64 = 225.0;

/// Correction that the push adds to the reference, the walk left out: one coordinate, m.
fn correction(s: &ConditionedSample, k: usize) -> f64 {
    s.position[k] - s.reference[k] - s.walk[k]
}

impl<'a> Push<'a> {
    /// Largest push that the explicit forms can make, m.
    fn available(&self) -> Option<f64> {
        let is_explicit = |run: &PathRun| matches!(run.method, PathMethod::SlidingMode | PathMethod::SlidingModePaper);
        match self.0.study.problem.law {
            SwitchingLaw::Normalised { amplitude } if self.0.runs.iter().any(is_explicit) => Some(amplitude),
            _ => None,
        }
    }

    fn mean_push(&self, run: &PathRun) -> Vec<(f64, f64)> {
        mean_length(run.samples, &(0.0..self.0.end()), |s| s.push)
    }

    fn used(&self, run: &PathRun) -> Option<String> {
        let most = self.mean_push(run).iter().map(|p| p.1).fold(0.0, f64::max);
        run.method.is_conditioner().then(|| format!("{} mm", significant(1e3 * most, 2)))
    }

    fn push_layer(&self) -> Layer {
        let means: Vec<_> = self.0.conditioners().map(|run| (run.method, self.mean_push(run))).collect();
        let all = means.iter().flat_map(|(_, mean)| mean.iter().map(|p| p.1)).chain(self.available());
        let range = 0.0..roomy(all).end;
        let unit = Unit::of(&range);
        let scale = |mean: Vec<(f64, f64)>| mean.into_iter().map(|p| (p.0, unit.factor * p.1)).collect();
        Layer {
            title: "push ‖u‖, averaged over short windows".to_owned(),
            y: Axis::linear(unit.name, unit.scale(&range), 4),
            levels: self.available().map(|most| (unit.factor * most, LIMIT)).into_iter().collect(),
            curves: means.into_iter().map(|(method, mean)| (scale(mean), path_stroke(method))).collect(),
        }
    }

    /// One scale for all three components.
    fn correction_layer(&self, k: usize) -> Layer {
        let range = roomy((0..3).flat_map(|k| self.0.shown().map(move |s| correction(s, k))));
        let unit = Unit::of(&range);
        let curve = |run: &PathRun| (run.against_time(unit.apply(move |s| correction(s, k))), path_stroke(run.method));
        Layer {
            title: format!("correction in {}", ["x", "y", "z"][k]),
            y: Axis::linear(unit.name, unit.scale(&range), 4),
            levels: Vec::new(),
            curves: self.0.runs.iter().map(curve).collect(),
        }
    }

    fn layers(&self) -> Vec<Layer> {
        let push = self.0.conditioners().next().map(|_| self.push_layer());
        push.into_iter().chain((0..3).map(|k| self.correction_layer(k))).collect()
    }
}

impl Figure for Push<'_> {
    const NAME: &'static str = "push";

    fn caption(&self) -> String {
        format!(
            "{}: push of the conditioner's forms, as the length of its mean over a 300th of the time axis (a switched push \
             is all or nothing in each sample), and the components of the correction p* − p_ref, the random walk left \
             out.{}",
            self.0.study.title,
            self.0.time_remark()
        )
    }

    fn header(&self) -> Header {
        let meaning = "largest mean push";
        let mut header = header(self.0, "Push and correction", meaning, &self.0.runs, |run| self.used(run));
        if let Some(most) = self.available() {
            header.legend.push(limit_entry(&format!("available ({} mm)", significant(1e3 * most, 2))));
        }
        header
    }

    fn body_height(&self) -> f64 {
        stack::height(3 + self.0.conditioners().count().min(1), PANEL)
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        stack::draw(canvas, &Axis::linear("time (s)", 0.0..self.0.end(), 7), self.layers(), PANEL)
    }
}
