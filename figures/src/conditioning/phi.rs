//! `φ_i = σ_i + K_i σ̇_i` over time: how it is kept at zero and how it chatters there (the quantities of `[G12]` Fig. 4, 6, 8,
//! 10).

use super::facts::length;
use super::study::{Checked, PathRun, Unit};
use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::{entry, limit_entry};
use crate::polyline::Point;
use crate::render::Figure;
use crate::scale::{Axis, span};
use crate::stack::{self, Layer};
use crate::style::{INK, LIMIT, REFERENCE, Stroke, path_label, path_stroke};
use plotters::backend::DrawingBackend;
use std::ops::Range;

pub(crate) struct Phi<'a> {
    checked: &'a Checked<'a>,
    runs: Vec<&'a PathRun<'a>>,
}

const PANEL: f64 = 200.0;
/// Where a constraint acts.
const CONTACT: Stroke = Stroke { color: INK, width: 7.0, dashes: &[] };
const ZERO: Stroke = Stroke { width: 5.0, ..REFERENCE };

impl<'a> Phi<'a> {
    /// Nothing where no trace has a velocity.
    pub(crate) fn new(checked: &'a Checked<'a>) -> Option<Self> {
        let has_phi =
            |run: &&PathRun| run.samples.iter().any(|s| s.phi[..checked.constraints()].iter().any(|p| p.is_finite()));
        let runs: Vec<_> = checked.runs.iter().filter(has_phi).collect();
        (!runs.is_empty()).then_some(Self { checked, runs })
    }

    /// Largest `|φ_i|` in the stretches in which constraint `i` acts in any of the runs.
    fn amplitude(&self, i: usize) -> f64 {
        let acting = self.runs.iter().flat_map(|run| run.touching(i)).map(|s| s.phi[i].abs());
        let mut sizes: Vec<f64> = acting.filter(|p| p.is_finite()).collect();
        // A single sample of a recovery does not set the scale: all but a 200th of them are shown.
        sizes.sort_unstable_by(f64::total_cmp);
        sizes.get(sizes.len().saturating_sub(1 + sizes.len() / 200)).copied().unwrap_or_default()
    }

    /// Around zero: what chattering and bands need.
    fn range(&self, i: usize) -> Range<f64> {
        let bands = self.checked.study.bands.iter().filter(|b| b.constraint == i);
        let band = bands.flat_map(|b| [b.lower.abs(), b.upper.abs()]).fold(0.0, f64::max);
        let most = self.amplitude(i).max(band);
        if most > 0.0 {
            return -1.25 * most..1.25 * most;
        }
        let all = span(self.runs.iter().flat_map(|run| run.samples).map(|s| s.phi[i]));
        let size = all.end.abs().max(all.start.abs());
        if size.is_finite() { -size..size } else { -1.0..1.0 }
    }

    fn layer(&self, run: &PathRun, i: usize) -> Layer {
        let range = self.range(i);
        let unit = Unit::of(&range);
        let mut levels = vec![(0.0, ZERO)];
        let bands = self.checked.study.bands.iter().filter(|b| b.constraint == i && b.method == run.method);
        levels.extend(bands.flat_map(|b| [b.lower, b.upper]).map(|level| (unit.factor * level, LIMIT)));
        let name = path_label(run.method);
        let title =
            if self.checked.constraints() == 1 { name.to_owned() } else { format!("{name}: {}", self.checked.name(i)) };
        let height = unit.factor * (range.start + 0.95 * (range.end - range.start));
        let solid = Stroke { width: 3.0, dashes: &[], ..path_stroke(run.method) };
        Layer {
            title,
            y: Axis::linear(&format!("φ ({})", unit.name), unit.scale(&range), 4),
            levels,
            curves: vec![(contacts(run, i, height), CONTACT), (run.against_time(unit.apply(|s| s.phi[i])), solid)],
        }
    }

    /// Constraints side by side, two at a time; methods below each other.
    fn columns(&self) -> [Vec<Layer>; 2] {
        let mut columns = [Vec::new(), Vec::new()];
        for pair in (0..self.checked.constraints()).collect::<Vec<_>>().chunks(2) {
            for run in &self.runs {
                for (column, &i) in columns.iter_mut().zip(pair) {
                    column.push(self.layer(run, i));
                }
            }
        }
        columns
    }

    fn rows(&self) -> usize {
        self.runs.len() * self.checked.constraints().div_ceil(2)
    }

    /// Runs and constraints with `φ` above the proven band, rounding apart.
    fn exceeding(&self) -> usize {
        let exceeds = |band: &&super::PhiBand| {
            let runs = self.runs.iter().filter(|run| run.method == band.method);
            let room = 1e-9 * band.upper.abs().max(1e-3);
            runs.flat_map(|run| run.samples).any(|s| s.phi[band.constraint] > band.upper + room)
        };
        self.checked.study.bands.iter().filter(exceeds).count()
    }
}

/// A bar over the stretches in which constraint `i` acts, with gaps between them.
fn contacts(run: &PathRun, i: usize, height: f64) -> Vec<Point> {
    let bar = |c: &slideway_lab::conditioning::Contact| [(c.from_s, height), (c.to_s, height), (c.to_s, f64::NAN)];
    run.summary.active_intervals[i].iter().flat_map(bar).collect()
}

impl Figure for Phi<'_> {
    const NAME: &'static str = "phi";

    fn caption(&self) -> String {
        format!(
            "{}: φ = σ + K dσ/dt over time near zero; bars mark when the constraint acts, contacts less than 0.1 s apart \
             joined. Above zero the limit would be approached faster than allowed. Axes show 199 of 200 samples in these stretches; a \
             safety margin keeps φ that much below zero.{}",
            self.checked.study.title,
            self.checked.time_remark()
        )
    }

    fn header(&self) -> Header {
        let worst = |run: &PathRun| {
            let worst = run.summary.max_phi_m.iter().flatten().copied().fold(f64::NEG_INFINITY, f64::max);
            format!("{} {}", path_label(run.method), length(worst, 2).unwrap_or_default())
        };
        let worst: Vec<String> = self.runs.iter().map(|run| worst(run)).collect();
        let mut message = format!("Largest φ: {}.", worst.join(", "));
        let mut legend = vec![entry("constraint acts", CONTACT), entry("φ = 0", ZERO)];
        if !self.checked.study.bands.is_empty() {
            legend.push(limit_entry("proven band"));
            message.push_str(&match self.exceeding() {
                0 => " Every φ stays below its proven band's upper end.".to_owned(),
                count => format!(" The band's upper end is exceeded in {count} of {}.", self.checked.study.bands.len()),
            });
        }
        Header { heading: format!("Approach and chattering – {}", self.checked.study.title), message, legend }
    }

    fn body_height(&self) -> f64 {
        stack::height(self.rows(), PANEL)
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        let [left, right] = self.columns();
        if right.is_empty() {
            return stack::draw(canvas, &Axis::linear("time (s)", 0.0..self.checked.end(), 7), left, PANEL);
        }
        let x = Axis::linear("time (s)", 0.0..self.checked.end(), 4);
        let (first, second) = canvas.split_at_width(canvas.size().0 / 2.0);
        stack::draw(&first, &x, left, PANEL)?;
        stack::draw(&second, &x, right, PANEL)
    }
}
