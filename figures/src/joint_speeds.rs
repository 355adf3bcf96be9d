//! Commanded joint speeds with their limits (the quantities of `[G11]` Fig. 4 and Fig. 8).

use crate::canvas::{Canvas, Drawn, Header};
use crate::facts::{header, limit_entry};
use crate::multiples::{self, Multiple};
use crate::render::Figure;
use crate::scale::{largest, significant};
use crate::study::{Checked, Run};
use crate::style::label;
use plotters::backend::DrawingBackend;
use slideway_lab::{Method, Sample};

/// The axes reach to this many times the limits at most: an ideal arm next to a singularity has no scale of its own.
const REACH: f64 = 2.0;

pub(crate) struct JointSpeeds<'a> {
    checked: &'a Checked<'a>,
    panels: Vec<Multiple>,
}

impl<'a> JointSpeeds<'a> {
    pub(crate) fn new(checked: &'a Checked<'a>) -> Self {
        let panels = (0..checked.joints).map(|joint| panel(checked, joint)).collect();
        Self { checked, panels }
    }

    /// The fastest commanded speed, if it lies beyond its axis: method, joint and speed.
    fn cut_off(&self) -> Option<String> {
        let mut worst: Option<(f64, String)> = None;
        for run in &self.checked.runs {
            for (joint, panel) in self.panels.iter().enumerate() {
                let speed = largest(run.samples.iter().map(|s| s.commanded[joint].abs()));
                let is_worse = worst.as_ref().is_none_or(|(most, _)| speed > *most);
                if speed > 1.001 * panel.range.end.max(-panel.range.start) && is_worse {
                    let (method, most, unit) = (label(run.method), significant(speed, 2), &panel.label);
                    let text = format!("{method} {}, up to {most} {unit}", self.checked.joint_name(joint));
                    worst = Some((speed, text));
                }
            }
        }
        worst.map(|(_, text)| text)
    }

    /// Share of the moving time in which some joint is within 1 % of its limit.
    fn at_limit(&self, run: &Run) -> Option<String> {
        if run.method == Method::Ideal || run.moving().is_empty() {
            return None;
        }
        let study = self.checked.study;
        let use_of =
            |s: &Sample, i: usize| (s.commanded[i] / study.speed_upper[i]).max(s.commanded[i] / study.speed_lower[i]);
        let is_at = |s: &&Sample| (0..run.trace.joints).any(|i| use_of(s, i) >= 0.99);
        let share = run.moving().iter().filter(is_at).count() as f64 / run.moving().len() as f64;
        Some(format!("{:.0} %", 100.0 * share))
    }
}

fn panel(checked: &Checked, joint: usize) -> Multiple {
    let (lower, upper) = (checked.study.speed_lower[joint], checked.study.speed_upper[joint]);
    let all = || checked.runs.iter().flat_map(|run| run.samples).map(|s| s.commanded[joint]);
    let most = all().fold(upper, f64::max).min(REACH * upper);
    let least = all().fold(lower, f64::min).max(REACH * lower);
    let room = 0.08 * (upper - lower);
    Multiple {
        title: checked.joint_name(joint).to_owned(),
        label: checked.units(joint).speed.to_owned(),
        range: least.min(lower) - room..most.max(upper) + room,
        levels: vec![lower, upper],
        value: Box::new(move |s| s.commanded[joint]),
    }
}

impl Figure for JointSpeeds<'_> {
    const NAME: &'static str = "joint-speeds";

    fn caption(&self) -> String {
        let cut = self.cut_off().map(|worst| format!(" Curves beyond the axes are cut off ({worst})."));
        format!(
            "{}: commanded joint speeds with their limits.{}{}",
            self.checked.study.title,
            cut.unwrap_or_default(),
            self.checked.time_remark()
        )
    }

    fn header(&self) -> Header {
        let meaning = "share of the moving time with a joint at its limit";
        let mut header = header(self.checked, "Joint speeds", meaning, &self.checked.runs, |run| self.at_limit(run));
        if let Some(worst) = self.cut_off() {
            header.message.push_str(&format!(" Cut off: {worst}."));
        }
        header.legend.push(limit_entry("limits"));
        header
    }

    fn body_height(&self) -> f64 {
        multiples::height(self.panels.len())
    }

    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        multiples::draw(self.checked, canvas, &self.panels)
    }
}
