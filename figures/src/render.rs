use crate::canvas::{Canvas, Drawn, Header};
use crate::error::FigureError;
use crate::style::{PAPER, WIDTH};
use plotters::element::BitMapElement;
use plotters::prelude::*;
use std::path::{Path, PathBuf};

/// A figure on disk.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rendered {
    /// Its name, and the stem of its files.
    pub name: &'static str,
    /// Description, for under the figure and for readers who cannot see it.
    pub caption: String,
    /// The text of the SVG file.
    pub svg: String,
    /// The SVG file.
    pub svg_path: PathBuf,
    /// The PNG file.
    pub png_path: PathBuf,
    /// Width of both, px: 8.5 cm at 300 dots per inch.
    pub width: u32,
    /// Height of both, px.
    pub height: u32,
}

/// Makes the directory of the figures if it is missing.
pub(crate) fn make_directory(dir: &Path) -> Result<(), FigureError> {
    std::fs::create_dir_all(dir).map_err(|source| FigureError::Write { path: dir.to_owned(), source })
}

/// A figure of a study, not yet drawn.
pub(crate) trait Figure {
    const NAME: &'static str;
    fn caption(&self) -> String;
    fn header(&self) -> Header;
    /// Height of what is below the header, design units.
    fn body_height(&self) -> f64;
    fn draw_body<DB: DrawingBackend>(&self, canvas: &Canvas<DB>) -> Drawn<DB>;
}

/// The bitmap is drawn so many times larger and averaged, because the backend draws thick lines with hard edges.
const OVERSAMPLING: u32 = 3;

/// Draws a figure into `dir`, as SVG and as PNG.
pub(crate) fn render<F: Figure>(figure: &F, dir: &Path) -> Result<Rendered, FigureError> {
    let header = figure.header();
    let height = (header.height()? + figure.body_height()).ceil() as u32;
    let width = WIDTH as u32;
    let svg = to_svg(figure, &header, (width, height))?;
    let svg_path = dir.join(F::NAME).with_extension("svg");
    std::fs::write(&svg_path, &svg).map_err(|source| FigureError::Write { path: svg_path.clone(), source })?;
    let png_path = dir.join(F::NAME).with_extension("png");
    to_png(figure, &header, (width, height), &png_path)?;
    Ok(Rendered { name: F::NAME, caption: figure.caption(), svg, svg_path, png_path, width, height })
}

fn to_svg<F: Figure>(figure: &F, header: &Header, size: (u32, u32)) -> Result<String, FigureError> {
    let mut svg = String::new();
    let root = SVGBackend::with_string(&mut svg, size).into_drawing_area();
    draw(figure, header, &root).map_err(failed::<F>)?;
    drop(root);
    Ok(svg)
}

fn to_png<F: Figure>(figure: &F, header: &Header, size: (u32, u32), path: &Path) -> Result<(), FigureError> {
    let large = (size.0 * OVERSAMPLING, size.1 * OVERSAMPLING);
    let mut pixels = vec![0; 3 * (large.0 * large.1) as usize];
    let root = BitMapBackend::with_buffer(&mut pixels, large).into_drawing_area();
    draw(figure, header, &root).map_err(failed::<F>)?;
    drop(root);
    let mut averaged = averaged(&pixels, size);
    let file = BitMapBackend::new(path, size).into_drawing_area();
    let image = BitMapElement::with_mut((0, 0), size, &mut averaged)
        .ok_or_else(|| FigureError::Draw { figure: F::NAME, message: "the bitmap has the wrong size".to_owned() })?;
    file.draw(&image).and_then(|()| file.present()).map_err(failed::<F>)
}

fn draw<F: Figure, DB: DrawingBackend>(
    figure: &F,
    header: &Header,
    root: &DrawingArea<DB, plotters::coord::Shift>,
) -> Drawn<DB> {
    root.fill(&PAPER)?;
    let canvas = Canvas::new(root.clone());
    header.draw(&canvas)?;
    let (_, body) = canvas.split_at_height(canvas.size().1 - figure.body_height());
    figure.draw_body(&body)?;
    root.present()
}

fn failed<F: Figure>(error: impl std::error::Error) -> FigureError {
    FigureError::Draw { figure: F::NAME, message: error.to_string() }
}

/// Averages squares of [`OVERSAMPLING`] pixels of an RGB image down to `size`.
fn averaged(pixels: &[u8], size: (u32, u32)) -> Vec<u8> {
    let n = OVERSAMPLING as usize;
    let (width, height) = (size.0 as usize, size.1 as usize);
    let stride = 3 * n * width;
    let mean = |x: usize, y: usize, channel: usize| {
        let square = (0..n * n).map(|k| usize::from(pixels[(n * y + k / n) * stride + 3 * (n * x + k % n) + channel]));
        // A mean of bytes is a byte.
        (square.sum::<usize>() / (n * n)) as u8
    };
    (0..height)
        .flat_map(|y| (0..width).map(move |x| (x, y)))
        .flat_map(|(x, y)| [mean(x, y, 0), mean(x, y, 1), mean(x, y, 2)])
        .collect()
}
