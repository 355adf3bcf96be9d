use crate::error::FigureError;
use crate::polyline::without_reversals;
use crate::style::{FAMILY, HEADING_SIZE, INK, Stroke, TEXT_SIZE, WIDTH, line};
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Result of drawing with a backend.
pub(crate) type Drawn<DB, T = ()> = Result<T, DrawingAreaErrorKind<<DB as DrawingBackend>::ErrorType>>;

/// A part of a drawing with its scale: all lengths are given in design units, [`WIDTH`] of them across the figure.
pub(crate) struct Canvas<DB: DrawingBackend> {
    pub(crate) area: DrawingArea<DB, Shift>,
    pub(crate) scale: f64,
}

/// Where a text stands relative to its point.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Anchor {
    /// The point is the text's upper left corner.
    UpperLeft,
    /// The point is the middle of the text's left side.
    Left,
    /// The point is the text's centre.
    Centre,
}

impl<DB: DrawingBackend> Canvas<DB> {
    pub(crate) fn new(area: DrawingArea<DB, Shift>) -> Self {
        let scale = f64::from(area.dim_in_pixel().0) / WIDTH;
        Self { area, scale }
    }

    /// A length in pixels.
    pub(crate) fn px(&self, length: f64) -> i32 {
        (length * self.scale).round() as i32
    }

    /// Width and height in design units.
    pub(crate) fn size(&self) -> (f64, f64) {
        let (width, height) = self.area.dim_in_pixel();
        (f64::from(width) / self.scale, f64::from(height) / self.scale)
    }

    /// The parts above and below `height`.
    pub(crate) fn split_at_height(&self, height: f64) -> (Self, Self) {
        let (above, below) = self.area.split_vertically(self.px(height));
        (self.part(above), self.part(below))
    }

    /// The parts left and right of `width`.
    pub(crate) fn split_at_width(&self, width: f64) -> (Self, Self) {
        let (left, right) = self.area.split_horizontally(self.px(width));
        (self.part(left), self.part(right))
    }

    fn part(&self, area: DrawingArea<DB, Shift>) -> Self {
        Self { area, scale: self.scale }
    }

    pub(crate) fn text(&self, text: &str, size: f64, at: (f64, f64), anchor: Anchor) -> Drawn<DB> {
        let pos = match anchor {
            Anchor::UpperLeft => Pos::new(HPos::Left, VPos::Top),
            Anchor::Left => Pos::new(HPos::Left, VPos::Center),
            Anchor::Centre => Pos::new(HPos::Center, VPos::Center),
        };
        let style = TextStyle::from((FAMILY, size * self.scale).into_font()).color(&INK).pos(pos);
        self.area.draw_text(text, &style, (self.px(at.0), self.px(at.1)))
    }

    /// Draws a polyline given in pixels of this part.
    pub(crate) fn polyline(&self, points: &[(f64, f64)], stroke: &Stroke) -> Drawn<DB> {
        let mut rounded: Vec<_> = points.iter().map(|p| (p.0.round(), p.1.round())).collect();
        rounded.dedup();
        for piece in without_reversals(&rounded).into_iter().filter(|piece| piece.len() > 1) {
            let pixels: Vec<_> = piece.iter().map(|p| (p.0 as i32, p.1 as i32)).collect();
            self.area.draw(&PathElement::new(pixels, line(stroke.color, stroke.width * self.scale)))?;
        }
        Ok(())
    }
}

/// Heading, message and legend of a figure, laid out above its axes so that they never cover a curve.
#[derive(Clone, Debug, Default)]
pub(crate) struct Header {
    pub(crate) heading: String,
    /// Findings of the figure, in numbers.
    pub(crate) message: String,
    pub(crate) legend: Vec<Entry>,
}

/// One entry of a legend.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub(crate) label: String,
    pub(crate) stroke: Stroke,
}

const MARGIN: f64 = 12.0;
const SWATCH: f64 = 78.0;
const GAP: f64 = 30.0;
const LINE: f64 = 38.0;

impl Header {
    /// Height that it takes, in design units.
    pub(crate) fn height(&self) -> Result<f64, FigureError> {
        let lines = self.message_lines()?.len() + self.legend_rows()?.len();
        Ok(MARGIN + HEADING_SIZE + 8.0 + LINE * lines as f64 + 6.0)
    }

    pub(crate) fn draw<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB> {
        // The texts were measured for the height, so the font is there: measuring again cannot fail.
        let (messages, rows) = (self.message_lines().unwrap_or_default(), self.legend_rows().unwrap_or_default());
        let heading = shortened(&self.heading, HEADING_SIZE, WIDTH - 2.0 * MARGIN);
        canvas.text(&heading, HEADING_SIZE, (MARGIN, MARGIN), Anchor::UpperLeft)?;
        let mut y = MARGIN + HEADING_SIZE + 8.0;
        for message in messages {
            canvas.text(&message, TEXT_SIZE, (MARGIN, y), Anchor::UpperLeft)?;
            y += LINE;
        }
        for row in rows {
            for (x, entry) in row {
                let middle = y + LINE / 2.0;
                swatch(canvas, (x, middle), &entry.stroke)?;
                canvas.text(&entry.label, TEXT_SIZE, (x + SWATCH + 12.0, middle), Anchor::Left)?;
            }
            y += LINE;
        }
        Ok(())
    }

    /// The message broken into lines between words.
    fn message_lines(&self) -> Result<Vec<String>, FigureError> {
        let mut lines: Vec<String> = Vec::new();
        for word in self.message.split(' ').filter(|word| !word.is_empty()) {
            match lines.last_mut() {
                Some(line) if text_width(&format!("{line} {word}"), TEXT_SIZE)? <= WIDTH - 2.0 * MARGIN => {
                    line.push(' ');
                    line.push_str(word);
                }
                _ => lines.push(word.to_owned()),
            }
        }
        Ok(lines)
    }

    /// The legend's entries in rows, each with its left end.
    fn legend_rows(&self) -> Result<Vec<Vec<(f64, &Entry)>>, FigureError> {
        let mut rows: Vec<Vec<(f64, &Entry)>> = Vec::new();
        let mut x = f64::INFINITY;
        for entry in &self.legend {
            let width = SWATCH + 12.0 + text_width(&entry.label, TEXT_SIZE)?;
            if x + width > WIDTH - MARGIN {
                rows.push(Vec::new());
                x = MARGIN;
            }
            if let Some(row) = rows.last_mut() {
                row.push((x, entry));
            }
            x += width + GAP;
        }
        Ok(rows)
    }
}

fn swatch<DB: DrawingBackend>(canvas: &Canvas<DB>, at: (f64, f64), stroke: &Stroke) -> Drawn<DB> {
    let ends = [(at.0, at.1), (at.0 + SWATCH, at.1)];
    for dash in crate::polyline::dash(&ends, stroke.dashes, f64::INFINITY) {
        let pixels: Vec<_> = dash.iter().map(|p| (p.0 * canvas.scale, p.1 * canvas.scale)).collect();
        canvas.polyline(&pixels, stroke)?;
    }
    Ok(())
}

/// Width of a text in design units.
pub(crate) fn text_width(text: &str, size: f64) -> Result<f64, FigureError> {
    let (width, _) = (FAMILY, size).into_font().box_size(text).map_err(|_| FigureError::Font)?;
    Ok(f64::from(width))
}

/// The text, its end replaced by an ellipsis where it is too wide.
fn shortened(text: &str, size: f64, room: f64) -> String {
    let fits = |text: &str| text_width(text, size).is_ok_and(|width| width <= room);
    if fits(text) {
        return text.to_owned();
    }
    let starts = text.char_indices().rev().map(|(end, _)| format!("{}…", text[..end].trim_end()));
    starts.into_iter().find(|short| fits(short)).unwrap_or_default()
}
