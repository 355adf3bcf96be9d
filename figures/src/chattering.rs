//! Chattering of the regulated methods: the change of the desired joint speed in each sample against its rigorous bound and
//! the estimate of `[G11] eq 23`, and the use of the limits against the proven band.

use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::{entry, header, limit_entry};
use crate::render::Figure;
use crate::scale::{Axis, largest, significant, span};
use crate::stack::{self, Layer};
use crate::study::{Checked, Run};
use crate::style::{INK, LIMIT, REFERENCE, Stroke, label, stroke};
use plotters::backend::DrawingBackend;
use slideway_lab::{Chatter, Sample};

pub(crate) struct Chattering<'a> {
    checked: &'a Checked<'a>,
    runs: Vec<&'a Run<'a>>,
}

const PANEL: f64 = 245.0;
/// Curves show the largest value in each of so many parts of the time axis.
const WINDOWS: f64 = 300.0;

/// Decades of the axis: what is smaller than a ten-millionth of the largest is rest.
const DECADES: u32 = 7;

const BOUND: Stroke = Stroke { color: INK, width: 3.0, dashes: &[] };
const ESTIMATE: Stroke = Stroke { width: 9.0, ..REFERENCE };

impl<'a> Chattering<'a> {
    /// Nothing where no trace holds a change of speed while its reference moves.
    pub(crate) fn new(checked: &'a Checked<'a>) -> Option<Self> {
        let moves = |run: &&Run| run.moving().iter().any(|s| s.chatter.is_some());
        let runs: Vec<_> = checked.regulated().filter(moves).collect();
        (!runs.is_empty()).then_some(Self { checked, runs })
    }

    fn values(&self, value: fn(&Chatter) -> f64) -> impl Iterator<Item = f64> {
        self.runs.iter().flat_map(|run| run.moving()).filter_map(|s| s.chatter.as_ref()).map(value)
    }

    fn changes(&self, run: &Run) -> Layer {
        let all = self.values(|c| c.measured).chain(self.values(|c| c.bound)).chain(self.values(|c| c.estimate));
        Layer {
            title: format!("{}: change of desired speed per sample", label(run.method)),
            y: Axis::logarithmic("of limit", span(all.filter(|v| *v > 0.0)), DECADES),
            levels: Vec::new(),
            curves: vec![
                (self.peaks(run, |c| c.estimate), ESTIMATE),
                (self.peaks(run, |c| c.bound), BOUND),
                (self.peaks(run, |c| c.measured), Stroke { width: 3.5, dashes: &[], ..stroke(run.method) }),
            ],
        }
    }

    /// Use of the limits near and above 1: what lies far below is not chattering.
    fn limit_use(&self) -> Layer {
        let used = span(self.runs.iter().flat_map(|run| run.moving()).map(|s| s.limit_ratio));
        let most = used.end.max(self.checked.study.bound.unwrap_or(1.0)).max(1.005);
        let room = 0.2 * (most - 1.0);
        let y = if most < 3.0 {
            Axis::linear("of limit", 1.0 - 3.0 * room..most + room, 3)
        } else {
            Axis::logarithmic("of limit", 0.5..most, DECADES)
        };
        let solid = |run: &Run| Stroke { dashes: &[], ..stroke(run.method) };
        let peaks = |run: &&Run| (self.windowed(run, |s| Some(s.limit_ratio)), solid(run));
        let mut levels = vec![(1.0, Stroke { width: 9.0, ..REFERENCE })];
        levels.extend(self.checked.study.bound.map(|bound| (bound, LIMIT)));
        Layer {
            title: "‖F dq/dt‖∞: use of the speed limits".to_owned(),
            y,
            levels,
            curves: self.runs.iter().map(peaks).collect(),
        }
    }

    fn time(&self, label: &str) -> Axis {
        let moving = self.runs.iter().flat_map(|run| run.moving()).map(|s| s.t);
        Axis::linear(label, span(moving), 7)
    }

    fn peaks(&self, run: &Run, value: fn(&Chatter) -> f64) -> Vec<(f64, f64)> {
        self.windowed(run, |s| s.chatter.as_ref().map(value))
    }

    /// Largest values in short windows: single samples cannot be told apart on paper, their peaks matter.
    fn windowed(&self, run: &Run, value: impl Fn(&Sample) -> Option<f64>) -> Vec<(f64, f64)> {
        let range = self.time("").range();
        let window = |t: f64| ((t - range.start) / (range.end - range.start) * WINDOWS).floor();
        let samples: Vec<_> = run.moving().iter().filter_map(|s| Some((s.t, value(s)?))).collect();
        let peak = |part: &[(f64, f64)]| (part[0].0, part.iter().map(|p| p.1).fold(f64::NEG_INFINITY, f64::max));
        samples.chunk_by(|a, b| window(a.0) == window(b.0)).map(peak).collect()
    }

    /// True if every measured change keeps its bound; rounding apart, 1e-9 of a limit.
    fn keeps_bound(&self) -> bool {
        let chatter = self.runs.iter().flat_map(|run| run.moving()).filter_map(|s| s.chatter.as_ref());
        chatter.into_iter().all(|c| c.measured <= c.bound + 1e-9)
    }

    /// True if some measured change exceeds the estimate.
    fn exceeds_estimate(&self) -> bool {
        let chatter = self.runs.iter().flat_map(|run| run.moving()).filter_map(|s| s.chatter.as_ref());
        chatter.into_iter().any(|c| !(c.measured <= c.estimate + 1e-9))
    }
}

impl Figure for Chattering<'_> {
    const NAME: &'static str = "chattering";

    fn caption(&self) -> String {
        let band = self.checked.study.bound.map(|m| format!(" Proven band: M = {m:.4}.")).unwrap_or_default();
        format!(
            "{}: change of the desired joint speed in one sample as a share of the limit, largest over the joints and over \
             a 300th of the time axis, with its rigorous bound and the estimate |v_i| a λ̇d (filter step a = {}); below, \
             the largest use of a limit while the reference moves.{band}{}",
            self.checked.study.title,
            self.checked.study.filter_step,
            self.checked.remark()
        )
    }

    fn header(&self) -> Header {
        let bound = if self.keeps_bound() { "keeps its bound everywhere" } else { "breaks its bound" };
        let estimate = if self.exceeds_estimate() {
            "exceeds the paper's estimate in places"
        } else {
            "stays below the paper's estimate"
        };
        let meaning = format!("largest change, in limits; it {bound} and {estimate}");
        let largest_change = |run: &Run| {
            let changes = run.moving().iter().filter_map(|s| s.chatter.as_ref()).map(|c| c.measured);
            Some(significant(largest(changes), 2))
        };
        let mut header = header(self.checked, "Chattering", &meaning, self.runs.iter().copied(), largest_change);
        header.legend.iter_mut().for_each(|entry| entry.stroke.dashes = &[]);
        header.legend.push(entry("bound", BOUND));
        header.legend.push(entry("estimate, or 1", ESTIMATE));
        if self.checked.study.bound.is_some() {
            header.legend.push(limit_entry("band M"));
        }
        header
    }

    fn body_height(&self) -> f64 {
        stack::height(self.runs.len() + 1, PANEL)
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let mut layers: Vec<Layer> = self.runs.iter().map(|run| self.changes(run)).collect();
        layers.push(self.limit_use());
        stack::draw(canvas, &self.time("time (s)"), layers, PANEL)
    }
}
