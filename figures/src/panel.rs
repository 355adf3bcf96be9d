use crate::canvas::{Anchor, Canvas, Drawn};
use crate::polyline::{Point, clip, dash, gather, simplify};
use crate::scale::Axis;
use crate::style::{FAMILY, GRID, INK, Stroke, TEXT_SIZE, line};
use plotters::prelude::*;

/// A curve is drawn within this distance of its points, px: half of what the eye resolves in print.
const TOLERANCE: f64 = 0.4;

/// Axes with a grid, into which curves are drawn.
pub(crate) struct Panel<DB: DrawingBackend> {
    plot: Canvas<DB>,
    x: Axis,
    y: Axis,
}

/// Room and names around the axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame<'a> {
    /// Above the plot, left.
    pub(crate) title: &'a str,
    /// Width for the labels of the vertical axis, design units.
    pub(crate) left: f64,
    /// Height for the labels of the horizontal axis, design units.
    pub(crate) bottom: f64,
}

impl Frame<'_> {
    /// Room for tick labels and an axis label on both sides.
    pub(crate) const LABELLED: Frame<'static> = Frame { title: "", left: 126.0, bottom: 84.0 };
    /// Room below the axes of a panel that stands above another one: its ticks.
    pub(crate) const TICKS: f64 = 10.0;
    /// Free room above the plot and below its title, design units: half a tick label.
    pub(crate) const ABOVE: f64 = 16.0;
    /// Free room left of the vertical axis' label, design units.
    pub(crate) const EDGE: f64 = 10.0;
    /// Free room right of the plot, design units: half a tick label.
    pub(crate) const RIGHT: f64 = 26.0;
}

/// Width of the columns into which long curves are gathered, design units: less than that of any line.
const COLUMN: f64 = 2.0;

/// Height of a title, design units.
const TITLE: f64 = 34.0;

impl<DB: DrawingBackend> Panel<DB> {
    /// Draws the axes.
    pub(crate) fn new(canvas: &Canvas<DB>, frame: &Frame, x: Axis, y: Axis) -> Drawn<DB, Self> {
        let title = if frame.title.is_empty() { 0.0 } else { TITLE };
        let mut chart = ChartBuilder::on(&canvas.area)
            .margin_top(canvas.px(Frame::ABOVE + title))
            .margin_left(canvas.px(Frame::EDGE))
            .margin_right(canvas.px(Frame::RIGHT))
            .set_label_area_size(LabelAreaPosition::Left, canvas.px(frame.left))
            .set_label_area_size(LabelAreaPosition::Bottom, canvas.px(frame.bottom))
            .build_cartesian_2d(x.clone(), y.clone())?;
        let font = (FAMILY, TEXT_SIZE * canvas.scale).into_font().color(&INK);
        chart
            .configure_mesh()
            .bold_line_style(line(GRID, 1.5 * canvas.scale))
            .max_light_lines(0)
            .axis_style(line(INK, 2.5 * canvas.scale))
            .set_all_tick_mark_size(canvas.px(7.0))
            .label_style(font.clone())
            .axis_desc_style(font)
            .x_desc(x.label.as_str())
            .y_desc(y.label.as_str())
            .draw()?;
        canvas.text(frame.title, TEXT_SIZE, (Frame::EDGE + frame.left, 10.0), Anchor::UpperLeft)?;
        let plot = Canvas { area: chart.plotting_area().strip_coord_spec(), scale: canvas.scale };
        Ok(Self { plot, x, y })
    }

    /// Draws a curve whose horizontal coordinate is in order, cut to the axes.
    pub(crate) fn curve(&self, points: &[Point], stroke: &Stroke) -> Drawn<DB> {
        self.draw(&gather(&self.pixels(points), COLUMN * self.plot.scale), stroke)
    }

    /// Draws a curve of any shape, cut to the axes.
    pub(crate) fn path(&self, points: &[Point], stroke: &Stroke) -> Drawn<DB> {
        self.draw(&self.pixels(points), stroke)
    }

    /// Marks a point with a disc, nothing if it lies outside the axes.
    pub(crate) fn marker(&self, point: Point, stroke: &Stroke) -> Drawn<DB> {
        self.dot(point, stroke, 9.0)
    }

    /// The same with a radius of its own, design units.
    pub(crate) fn dot(&self, point: Point, stroke: &Stroke, radius: f64) -> Drawn<DB> {
        let (x, y) = (self.x.fraction(point.0), self.y.fraction(point.1));
        if !((0.0..=1.0).contains(&x) && (0.0..=1.0).contains(&y)) {
            return Ok(());
        }
        let (width, height) = self.extent();
        let centre = ((width * x).round() as i32, (height * (1.0 - y)).round() as i32);
        self.plot.area.draw(&Circle::new(centre, self.plot.px(radius), stroke.color.filled()))
    }

    /// Draws a horizontal line.
    pub(crate) fn level(&self, height: f64, stroke: &Stroke) -> Drawn<DB> {
        let range = self.x.range();
        self.path(&[(range.start, height), (range.end, height)], stroke)
    }

    fn pixels(&self, points: &[Point]) -> Vec<Point> {
        let (width, height) = self.extent();
        // Far outside is far enough: infinities would break the geometry. NaN passes and makes a gap.
        let place = |p: &Point| {
            let (x, y) = (width * self.x.fraction(p.0), height * (1.0 - self.y.fraction(p.1)));
            (x.clamp(-1e6, 1e6), y.clamp(-1e6, 1e6))
        };
        points.iter().map(place).collect()
    }

    fn extent(&self) -> (f64, f64) {
        let (width, height) = self.plot.area.dim_in_pixel();
        (f64::from(width), f64::from(height))
    }

    fn draw(&self, pixels: &[Point], stroke: &Stroke) -> Drawn<DB> {
        let (width, height) = self.extent();
        let pattern: Vec<f64> = stroke.dashes.iter().map(|d| d * self.plot.scale).collect();
        for run in clip(pixels, width, height) {
            let run = simplify(&run, TOLERANCE * self.plot.scale);
            for dash in dash(&run, &pattern, 3.0 * (width + height)) {
                self.plot.polyline(&dash, stroke)?;
            }
        }
        Ok(())
    }
}
