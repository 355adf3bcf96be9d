//! Chattering of the regulated methods: the change of the desired joint speed in each sample against its rigorous bound and
//! the estimate of `[G11] eq 23`, and the use of the limits against the proven band.

use crate::canvas::{Canvas, Drawn, Entry, Header};
use crate::facts::{header, limit_entry};
use crate::panel::{Frame, Panel};
use crate::render::Figure;
use crate::scale::{Axis, span};
use crate::study::{Checked, Run};
use crate::style::{GRID, INK, LIMIT, REFERENCE, Stroke, label, stroke};
use plotters::backend::DrawingBackend;
use slideway_lab::Chatter;

pub(crate) struct Chattering<'a> {
    checked: &'a Checked<'a>,
    runs: Vec<&'a Run<'a>>,
}

const PANEL: f64 = 230.0;
const LABELS: f64 = 84.0;
const BARE: f64 = 14.0;
const LEFT: f64 = 132.0;
/// Curves show the largest value in each of so many parts of the time axis.
const WINDOWS: f64 = 300.0;

/// Decades of the axis: what is smaller than a millionth of the largest change is rest.
const DECADES: u32 = 5;

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

    fn changes<DB: DrawingBackend>(&self, canvas: &Canvas<DB>, run: &Run) -> Drawn<DB> {
        let all = self.values(|c| c.measured).chain(self.values(|c| c.bound)).chain(self.values(|c| c.estimate));
        let y = Axis::logarithmic("share of limit", span(all.filter(|v| *v > 0.0)), DECADES);
        let frame = Frame { title: label(run.method), left: LEFT, bottom: BARE };
        let panel = Panel::new(canvas, &frame, self.time(""), y)?;
        panel.curve(&self.peaks(run, |c| c.estimate), &ESTIMATE)?;
        panel.curve(&self.peaks(run, |c| c.bound), &BOUND)?;
        panel.curve(&self.peaks(run, |c| c.measured), &Stroke { width: 3.5, dashes: &[], ..stroke(run.method) })
    }

    fn ratios<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let used = span(self.runs.iter().flat_map(|run| run.moving()).map(|s| s.limit_ratio));
        let most = used.end.max(self.checked.study.bound.unwrap_or(1.0)).max(1.0);
        // What lies far below the limit is not chattering.
        let least = used.start.max(1.0 - 4.0 * (most - 1.0).max(0.005));
        let room = 0.1 * (most - least);
        let y = Axis::linear("limit use", least.min(1.0) - room..most + room, 3);
        let frame = Frame { title: "largest use of a joint-speed limit", left: LEFT, bottom: LABELS };
        let panel = Panel::new(canvas, &frame, self.time("time (s)"), y)?;
        panel.level(1.0, &Stroke { color: GRID, width: 6.0, dashes: &[] })?;
        if let Some(bound) = self.checked.study.bound {
            panel.level(bound, &LIMIT)?;
        }
        for run in &self.runs {
            let points: Vec<_> = run.moving().iter().map(|s| (s.t, s.limit_ratio)).collect();
            panel.curve(&points, &stroke(run.method))?;
        }
        Ok(())
    }

    fn time(&self, label: &str) -> Axis {
        let moving = self.runs.iter().flat_map(|run| run.moving()).map(|s| s.t);
        Axis::linear(label, span(moving), 7)
    }

    /// Largest values in short windows: single samples cannot be told apart on paper, their peaks matter.
    fn peaks(&self, run: &Run, value: fn(&Chatter) -> f64) -> Vec<(f64, f64)> {
        let range = self.time("").range();
        let window = |t: f64| ((t - range.start) / (range.end - range.start) * WINDOWS).floor();
        let samples: Vec<_> = run.moving().iter().filter_map(|s| Some((s.t, value(s.chatter.as_ref()?)))).collect();
        let peak = |part: &[(f64, f64)]| (part[0].0, part.iter().map(|p| p.1).fold(f64::NEG_INFINITY, f64::max));
        samples.chunk_by(|a, b| window(a.0) == window(b.0)).map(peak).collect()
    }

    /// Whether every measured change keeps its bound; rounding apart, 1e-9 of a limit.
    fn keeps_bound(&self) -> bool {
        let chatter = self.runs.iter().flat_map(|run| run.moving()).filter_map(|s| s.chatter.as_ref());
        chatter.into_iter().all(|c| c.measured <= c.bound + 1e-9)
    }

    /// Whether some measured change exceeds the estimate.
    fn exceeds_estimate(&self) -> bool {
        let chatter = self.runs.iter().flat_map(|run| run.moving()).filter_map(|s| s.chatter.as_ref());
        chatter.into_iter().any(|c| c.measured > c.estimate + 1e-9)
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
        let bound = if self.keeps_bound() { "keeps its bound" } else { "breaks its bound" };
        let estimate = if self.exceeds_estimate() { "exceeds" } else { "stays below" };
        let message = format!("Change of speed per sample: {bound} everywhere, {estimate} the paper's estimate.");
        let mut header = header(self.checked, message, None, self.runs.iter().copied());
        header.legend.push(Entry { label: "bound".to_owned(), stroke: BOUND });
        header.legend.push(Entry { label: "estimate".to_owned(), stroke: ESTIMATE });
        if self.checked.study.bound.is_some() {
            header.legend.push(limit_entry("band M"));
        }
        header
    }

    fn body_height(&self) -> f64 {
        self.runs.len() as f64 * (PANEL + BARE) + PANEL + LABELS
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let mut rest = Canvas { area: canvas.area.clone(), scale: canvas.scale };
        for run in &self.runs {
            let (above, below) = rest.split_at_height(PANEL + BARE);
            self.changes(&above, run)?;
            rest = below;
        }
        self.ratios(&rest)
    }
}
