//! Ranges, round tick values and their labels.

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use std::ops::Range;

/// Spacing of values along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Spacing {
    Linear,
    Logarithmic,
}

/// Decimals of a label that fit beside an axis.
const MOST_DECIMALS: usize = 4;

/// One axis: what it shows and over which range.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    pub(crate) label: String,
    pub(crate) spacing: Spacing,
    /// In the values' unit, or as decimal logarithms of it.
    range: Range<f64>,
    ticks: Vec<f64>,
    decimals: usize,
    /// Number taken off the values in the labels, and the power of ten in which the rest is told.
    offset: f64,
    exponent: i32,
    /// Naming of ticks and axis: shown or hidden.
    naming: Naming,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Naming {
    Shown,
    Hidden,
}

impl Axis {
    /// A linear axis with about `count` ticks. An empty range is widened to one that can be drawn.
    pub(crate) fn linear(label: &str, range: Range<f64>, count: usize) -> Self {
        let range = drawable(range);
        let step = round_step((range.end - range.start) / count.max(1) as f64);
        let ticks = multiples(step, &range);
        let decimals = if step >= 1.0 { 0 } else { (-step.log10().floor()).clamp(0.0, 300.0) as usize };
        let plain = Self {
            label: label.to_owned(),
            spacing: Spacing::Linear,
            range,
            ticks,
            decimals,
            offset: 0.0,
            exponent: 0,
            naming: Naming::Shown,
        };
        if decimals > MOST_DECIMALS { plain.in_powers_of_ten() } else { plain }
    }

    /// The same axis with short labels for a fine step: whole numbers in a power of ten, counted from the middle tick unless zero
    /// is in sight. The axis' name tells both.
    fn in_powers_of_ten(self) -> Self {
        let zero_in_sight = self.range.start <= 0.0 && self.range.end >= 0.0;
        let middle = self.ticks.get(self.ticks.len() / 2).copied().unwrap_or(0.0);
        let offset = if zero_in_sight { 0.0 } else { middle };
        let exponent = -(self.decimals as i32);
        let (name, unit) = match self.label.split_once(" (") {
            Some((name, unit)) => (name, format!(" {unit}")),
            None => (self.label.as_str(), ")".to_owned()),
        };
        let less = match offset {
            0.0 => String::new(),
            o if o < 0.0 => format!(" + {:.*}", self.decimals, -o),
            o => format!(" − {o:.*}", self.decimals),
        };
        let label = format!("{name}{less} (10{}{unit}", superscript(i64::from(exponent)));
        Self { label, decimals: 0, offset, exponent, ..self }
    }

    /// A logarithmic axis over whole decades, at most `decades` of them below the upper end.
    pub(crate) fn logarithmic(label: &str, range: Range<f64>, decades: u32) -> Self {
        let end = if range.end > 0.0 { range.end.log10().ceil() } else { 0.0 };
        let lowest = end - f64::from(decades);
        let start = if range.start > 0.0 { range.start.log10().floor().max(lowest) } else { lowest };
        let range = drawable(start.min(end - 1.0)..end);
        // Four labels fit; the ticks stay whole decades.
        let ticks = multiples(((range.end - range.start) / 4.0).ceil(), &range);
        Self {
            label: label.to_owned(),
            spacing: Spacing::Logarithmic,
            range,
            ticks,
            decimals: 0,
            offset: 0.0,
            exponent: 0,
            naming: Naming::Shown,
        }
    }

    /// The same axis without names, for panels above another one.
    pub(crate) fn unlabelled(&self) -> Self {
        Self { label: String::new(), naming: Naming::Hidden, ..self.clone() }
    }

    /// Position of a value along the axis: 0 at its start, 1 at its end.
    pub(crate) fn fraction(&self, value: f64) -> f64 {
        let value = match self.spacing {
            Spacing::Linear => value,
            // Zero has no place on this axis: negative infinity, which is cut at its lower end.
            Spacing::Logarithmic => value.log10(),
        };
        (value - self.range.start) / (self.range.end - self.range.start)
    }

    pub(crate) fn range(&self) -> Range<f64> {
        self.range.clone()
    }

    pub(crate) fn tick_label(&self, tick: f64) -> String {
        match self.spacing {
            _ if self.naming == Naming::Hidden => String::new(),
            Spacing::Linear => {
                let value = (tick - self.offset) / 10_f64.powi(self.exponent);
                // Adding zero turns -0 into 0; so does rounding first what is told in whole numbers.
                let value = if self.exponent == 0 { value } else { value.round() };
                format!("{:.*}", self.decimals, value + 0.0).replace('-', "−")
            }
            Spacing::Logarithmic => format!("10{}", superscript(tick.round() as i64)),
        }
    }
}

/// An axis as the drawing library sees it, its range and ticks being those of the spacing: decimal logarithms where it is
/// logarithmic.
impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let share = (value - self.range.start) / (self.range.end - self.range.start);
        (f64::from(limit.0) + share * f64::from(limit.1 - limit.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

impl ValueFormatter<f64> for Axis {
    fn format_ext(&self, tick: &f64) -> String {
        self.tick_label(*tick)
    }
}

/// A range with both ends finite and some room between them.
fn drawable(range: Range<f64>) -> Range<f64> {
    let finite = range.start.is_finite() && range.end.is_finite();
    if finite && range.end - range.start > 1e-12 * range.start.abs().max(range.end.abs()).max(1e-300) {
        range
    } else if finite {
        let room = 0.5 * range.start.abs().max(1.0);
        range.start - room..range.start + room
    } else {
        0.0..1.0
    }
}

/// The round number (1, 2 or 5 times a power of ten) nearest to `step` on a logarithmic scale, roughly.
fn round_step(step: f64) -> f64 {
    let power = 10f64.powf(step.log10().floor());
    let lead = step / power;
    let round = match lead {
        lead if lead < 1.5 => 1.0,
        lead if lead < 3.2 => 2.0,
        lead if lead < 7.2 => 5.0,
        _ => 10.0,
    };
    round * power
}

fn multiples(step: f64, range: &Range<f64>) -> Vec<f64> {
    let (first, last) = ((range.start / step - 1e-9).ceil(), (range.end / step + 1e-9).floor());
    (0..100).map(|i| first + f64::from(i)).take_while(|&k| k <= last).map(|k| k * step).collect()
}

fn superscript(exponent: i64) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digits = exponent.unsigned_abs().to_string();
    let sign = if exponent < 0 { "⁻" } else { "" };
    sign.chars().chain(digits.bytes().map(|b| DIGITS[usize::from(b - b'0') % 10])).collect()
}

/// A value to `digits` significant digits, in plain notation between 0.001 and 9999.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let power = value.abs().log10().floor();
    if (-3.0..4.0).contains(&power) {
        let decimals = (digits as f64 - 1.0 - power).max(0.0) as usize;
        return format!("{value:.decimals$}").replace('-', "−");
    }
    let lead = value / 10f64.powf(power);
    format!("{lead:.*}×10{}", digits.saturating_sub(1).min(1), superscript(power as i64)).replace('-', "−")
}

/// Smallest range that holds all finite values.
pub(crate) fn span(values: impl IntoIterator<Item = f64>) -> Range<f64> {
    let finite = values.into_iter().filter(|v| v.is_finite());
    finite.fold(f64::INFINITY..f64::NEG_INFINITY, |r, v| r.start.min(v)..r.end.max(v))
}

/// Largest finite value, at least 0.
pub(crate) fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    span(values).end.max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside_the_range() {
        let axis = Axis::linear("x", -0.13..0.47, 5);
        let labels: Vec<String> = axis.ticks.iter().map(|t| axis.tick_label(*t)).collect();
        assert_eq!(labels, ["−0.1", "0.0", "0.1", "0.2", "0.3", "0.4"]);
    }

    #[test]
    fn fine_steps_are_told_in_whole_numbers_of_a_power_of_ten() {
        let labels = |axis: &Axis| axis.ticks.iter().map(|t| axis.tick_label(*t)).collect::<Vec<_>>();
        let far = Axis::linear("x (m)", 0.743181..0.743203, 4);
        assert_eq!(far.label, "x − 0.743195 (10⁻⁶ m)");
        assert_eq!(labels(&far), ["−10", "−5", "0", "5"]);
        let near = Axis::linear("e (m)", -2.5e-5..2.5e-5, 4);
        assert_eq!(near.label, "e (10⁻⁵ m)");
        assert_eq!(labels(&near), ["−2", "−1", "0", "1", "2"]);
        let below = Axis::linear("y (m)", -0.76124..-0.76119, 4);
        assert_eq!(below.label, "y + 0.76121 (10⁻⁵ m)");
        assert_eq!(Axis::linear("margin", 0.0..3e-13, 4).label, "margin (10⁻¹³)");
    }

    #[test]
    fn a_range_without_extent_or_end_can_still_be_drawn() {
        for range in [1.0..1.0, 0.0..0.0, f64::NAN..1.0, f64::INFINITY..f64::NEG_INFINITY, 0.0..f64::INFINITY] {
            let axis = Axis::linear("x", range, 5);
            assert!(axis.range().end > axis.range().start);
            assert!(!axis.ticks.is_empty());
        }
    }

    #[test]
    fn logarithmic_axes_label_decades() {
        let axis = Axis::logarithmic("x", 0.002..0.7, 6);
        let labels: Vec<String> = axis.ticks.iter().map(|t| axis.tick_label(*t)).collect();
        assert_eq!(labels, ["10⁻³", "10⁻²", "10⁻¹", "10⁰"]);
        assert!(axis.fraction(0.0) < 0.0);
    }

    #[test]
    fn significant_digits_read_as_a_person_would_write_them() {
        assert_eq!(significant(4.2412, 4), "4.241");
        assert_eq!(significant(0.0123, 2), "0.012");
        assert_eq!(significant(123_456.0, 2), "1.2×10⁵");
    }
}
