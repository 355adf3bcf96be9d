use serde::Serialize;

/// Findings of a study, as plain data.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// The study's name.
    pub study: &'static str,
    /// The heading of its figure.
    pub title: &'static str,
    /// True if everything that is claimed was found.
    pub holds: bool,
    /// Findings, in a sentence or two.
    pub sentence: String,
    /// The numbers behind it.
    pub numbers: Vec<NamedNumber>,
    /// Panels of its figure, from top to bottom.
    #[serde(skip)]
    pub panels: Vec<Panel>,
}

impl Report {
    /// The number of that name.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<f64> {
        self.numbers.iter().find(|n| n.name == name).map(|n| n.value)
    }
}

/// A number with its name and unit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NamedNumber {
    /// Name of the quantity, in kebab case.
    pub name: String,
    /// Its value.
    pub value: f64,
    /// Its unit; `1` for shares and ratios.
    pub unit: &'static str,
}

impl NamedNumber {
    /// A number.
    #[must_use]
    pub fn new(name: impl Into<String>, value: f64, unit: &'static str) -> Self {
        Self { name: name.into(), value, unit }
    }
}

/// Axes with curves in them.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Heading: the quantities that it shows.
    pub title: String,
    /// Quantity and unit of the horizontal axis.
    pub x: &'static str,
    /// Quantity and unit of the vertical axis.
    pub y: &'static str,
    /// Scaling of the two axes.
    pub scales: Scales,
    /// Curves; a name stands for the same line style in all panels of a figure.
    pub series: Vec<Series>,
    /// Horizontal lines: limits and targets.
    pub levels: Vec<Level>,
}

/// Scaling of a panel's axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scales {
    /// Each axis fills its side.
    Filling,
    /// The same length means the same amount on both: for paths in a plane.
    Equal,
}

/// One curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Its name in the legend.
    pub name: &'static str,
    /// Role: reference or result.
    pub role: Role,
    /// Its points, in the units of the axes.
    pub points: Vec<[f64; 2]>,
}

/// Role of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// A course to be followed, or compared with: drawn broad and pale.
    Reference,
    /// A course that came about.
    Result,
}

/// A horizontal line across a panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// Its name in the legend, shared by all lines of that name.
    pub name: &'static str,
    /// Its height.
    pub value: f64,
}
