//! Style that all figures share: sizes, colours, line styles, names.
//!
//! Colours are those of Okabe and Ito, which stay apart under the common colour-vision deficiencies; every curve differs
//! from the others in dashes and width too.

use crate::error::FigureError;
use plotters::style::{Color, FontStyle, RGBColor, ShapeStyle, register_font};
use slideway_lab::Method;
use slideway_lab::conditioning::PathMethod;

/// Background; the report replaces it in dark mode, as it does the next two.
pub(crate) const PAPER: RGBColor = RGBColor(0xFF, 0xFF, 0xFF);
/// Text, axes and limits.
pub(crate) const INK: RGBColor = RGBColor(0x1A, 0x1A, 0x1A);
/// Grid lines.
pub(crate) const GRID: RGBColor = RGBColor(0xD9, 0xD9, 0xD9);

/// Width of every figure in design units: 8.5 cm at 300 dots per inch.
pub(crate) const WIDTH: f64 = 1000.0;
/// Font size of headings: the letters' em is this over 1.2, so 7.5 points at column width.
pub(crate) const HEADING_SIZE: f64 = 38.0;
/// Font size of everything else: 6.5 points at column width.
pub(crate) const TEXT_SIZE: f64 = 33.0;
/// Font family; the bundled font under the name that SVG viewers know.
pub(crate) const FAMILY: &str = "sans-serif";

/// Line style, in design units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stroke {
    pub(crate) color: RGBColor,
    pub(crate) width: f64,
    /// Lengths drawn and left out in turn; empty for an unbroken line.
    pub(crate) dashes: &'static [f64],
}

const DOTTED: &[f64] = &[4.0, 8.0];
const DASHED: &[f64] = &[20.0, 11.0];
const DASH_DOT: &[f64] = &[22.0, 9.0, 5.0, 9.0];
const SHORT_DASHES: &[f64] = &[11.0, 9.0];
const LONG_DASHES: &[f64] = &[34.0, 16.0];

/// Line style of references: the optimum, the desired path.
pub(crate) const REFERENCE: Stroke = Stroke { color: RGBColor(0xB0, 0xB0, 0xB0), width: 15.0, dashes: &[] };
/// Limits and proven bounds.
pub(crate) const LIMIT: Stroke = Stroke { color: INK, width: 2.5, dashes: SHORT_DASHES };

/// Marks on an axis where bounds are farthest apart.
pub(crate) const GAP: Stroke = Stroke { color: RGBColor(0xC0, 0x00, 0x00), width: 14.0, dashes: &[] };

/// Hatching of the region that a constraint forbids.
pub(crate) const HATCH: Stroke = Stroke { color: RGBColor(0x9A, 0x9A, 0x9A), width: 1.5, dashes: &[] };

/// The line style of a method, as in the figures of `[G11]` where it is one of theirs.
pub(crate) fn stroke(method: Method) -> Stroke {
    let (color, width, dashes) = match method {
        Method::Ideal => (RGBColor(0xCC, 0x79, 0xA7), 4.0, DOTTED),
        Method::Saturated => (RGBColor(0xE6, 0x9F, 0x00), 4.0, DASH_DOT),
        Method::DirectionPreserving => (RGBColor(0x56, 0xB4, 0xE9), 4.0, DASHED),
        Method::ConstantSpeed => (RGBColor(0x80, 0x80, 0x00), 5.0, DASH_DOT),
        Method::NaturalMotion => (RGBColor(0x88, 0x2E, 0x9E), 5.0, DASHED),
        Method::SlidingMode => (RGBColor(0x00, 0x72, 0xB2), 6.0, &[][..]),
        Method::SlidingModeSynchronised => (RGBColor(0x00, 0x9E, 0x73), 4.5, LONG_DASHES),
        Method::SlidingModeImplicit => (RGBColor(0xD5, 0x5E, 0x00), 3.0, SHORT_DASHES),
        Method::AccelerationLimited => (RGBColor(0x99, 0x8F, 0x00), 4.0, DASH_DOT),
        Method::AccelerationLookAhead => (RGBColor(0x8A, 0x5C, 0xC4), 5.0, &[][..]),
    };
    Stroke { color, width, dashes }
}

/// The name of a method in legends and captions.
pub(crate) fn label(method: Method) -> &'static str {
    match method {
        Method::Ideal => "ideal",
        Method::Saturated => "saturated",
        Method::DirectionPreserving => "direction-preserving",
        Method::ConstantSpeed => "constant speed",
        Method::NaturalMotion => "natural motion",
        Method::SlidingMode => "sliding mode",
        Method::SlidingModeSynchronised => "synchronised",
        Method::SlidingModeImplicit => "implicit",
        Method::AccelerationLimited => "acceleration-limited",
        Method::AccelerationLookAhead => "look-ahead",
    }
}

/// The line style of a method of path conditioning; a conditioner's form looks like the speed law of the same name.
pub(crate) fn path_stroke(method: PathMethod) -> Stroke {
    let (color, width, dashes) = match method {
        PathMethod::SlidingMode => return stroke(Method::SlidingMode),
        PathMethod::SlidingModePaper => return stroke(Method::SlidingModeSynchronised),
        PathMethod::SlidingModeImplicit => return stroke(Method::SlidingModeImplicit),
        PathMethod::QpFilter => (RGBColor(0xCC, 0x79, 0xA7), 5.0, DASH_DOT),
        PathMethod::Projection => (RGBColor(0x56, 0xB4, 0xE9), 9.0, &[][..]),
        PathMethod::PotentialField => (RGBColor(0xE6, 0x9F, 0x00), 5.0, DASHED),
    };
    Stroke { color, width, dashes }
}

/// The name of a method of path conditioning in legends and captions.
pub(crate) fn path_label(method: PathMethod) -> &'static str {
    match method {
        PathMethod::SlidingMode => "sliding mode",
        PathMethod::SlidingModePaper => "paper's scheme",
        PathMethod::SlidingModeImplicit => "implicit",
        PathMethod::QpFilter => "QP filter",
        PathMethod::Projection => "projection",
        PathMethod::PotentialField => "potential field",
    }
}

/// Line styles for things that are only told apart, by number.
pub(crate) fn numbered_stroke(number: usize) -> Stroke {
    const COLORS: [RGBColor; 6] = [
        RGBColor(0x00, 0x72, 0xB2),
        RGBColor(0xD5, 0x5E, 0x00),
        RGBColor(0x00, 0x9E, 0x73),
        RGBColor(0xCC, 0x79, 0xA7),
        RGBColor(0xE6, 0x9F, 0x00),
        RGBColor(0x56, 0xB4, 0xE9),
    ];
    const DASHES: [&[f64]; 6] = [&[], SHORT_DASHES, LONG_DASHES, DASH_DOT, DASHED, DOTTED];
    let (turn, place) = (number / COLORS.len(), number % COLORS.len());
    // Each turn pairs the colours with other dashes: the first 36 differ.
    Stroke { color: COLORS[place], width: 5.0, dashes: DASHES[(place + turn) % DASHES.len()] }
}

/// A line `width` pixels wide, never thinner than one.
pub(crate) fn line(color: RGBColor, width: f64) -> ShapeStyle {
    color.stroke_width(width.round().max(1.0) as u32)
}

/// Makes the bundled font known to the drawing library.
pub(crate) fn register_fonts() -> Result<(), FigureError> {
    let font = include_bytes!("../fonts/DejaVuSans-subset.ttf");
    register_font(FAMILY, FontStyle::Normal, font).map_err(|_| FigureError::Font)
}
