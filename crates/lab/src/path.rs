use crate::error::{Fault, LabError};
use crate::formula::Formula;
use crate::scenario::schema::{OrientationTable, PathTable, PositionTable, TaskName};
use nalgebra::{Vector3, Vector6};

/// A path of the tool: position and Euler triple as functions of the path parameter `λ`.
///
/// Coordinates are `[x y z α β γ]` in m and rad, orientation `Rz(α) Ry(β) Rx(γ)`, all in the base frame.
#[derive(Clone, Debug)]
pub struct CartesianPath {
    start: f64,
    end: f64,
    position: PositionCurve,
    orientation: OrientationCurve,
}

/// Position along the path.
#[derive(Clone, Debug)]
pub(crate) enum PositionCurve {
    Helix { start: Vector3<f64>, radius: f64, climb: f64 },
    Line { from: Vector3<f64>, rate: Vector3<f64>, begin: f64 },
    Formula(Box<[Formula; 3]>),
}

/// Euler triple along the path.
#[derive(Clone, Debug)]
enum OrientationCurve {
    Constant(Vector3<f64>),
    PiecewiseLinear(Vec<Knot>),
    Formula(Box<[Formula; 3]>),
}

#[derive(Clone, Copy, Debug)]
struct Knot {
    at: f64,
    euler: Vector3<f64>,
}

/// One point of a path with its derivatives by the path parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPoint {
    /// `f(λ)`.
    pub coordinates: Vector6<f64>,
    /// `f'(λ)`; at a kink, the one of the piece that begins there.
    pub first: Vector6<f64>,
    /// `f''(λ)`.
    pub second: Vector6<f64>,
}

/// Value and derivatives of three coordinates.
pub(crate) type Curve3 = [Vector3<f64>; 3];

impl CartesianPath {
    pub(crate) fn new(table: &PathTable, task: TaskName) -> Result<Self, LabError> {
        let (start, end) = (table.start.0, table.end.0);
        if !(start < end) {
            return Err(LabError::value("path.end", Fault::NotIncreasing { before: start, after: end }));
        }
        let orientation = match &table.orientation {
            Some(table) => OrientationCurve::new(table, start, end)?,
            None if matches!(task, TaskName::Pose | TaskName::PlanarPose) => {
                return Err(LabError::value(
                    "path.orientation",
                    Fault::Missing("a task that includes the orientation needs one along the path"),
                ));
            }
            None => OrientationCurve::Constant(Vector3::zeros()),
        };
        let path = Self {
            start,
            end,
            position: PositionCurve::new(&table.position, start, end, "path.position")?,
            orientation,
        };
        path.check_finite()?;
        Ok(path)
    }

    /// Path parameter at the start.
    #[must_use]
    pub fn start(&self) -> f64 {
        self.start
    }

    /// Path parameter at the end.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.end
    }

    /// The point at a path parameter, which is not clamped to the path's range.
    #[must_use]
    pub fn at(&self, lambda: f64) -> PathPoint {
        let [position, velocity, acceleration] = self.position.at(lambda);
        let [euler, rate, rate2] = self.orientation.at(lambda);
        PathPoint {
            coordinates: join(&position, &euler),
            first: join(&velocity, &rate),
            second: join(&acceleration, &rate2),
        }
    }

    /// Path parameters strictly inside the path where its derivative jumps.
    #[must_use]
    pub fn kinks(&self) -> Vec<f64> {
        match &self.orientation {
            OrientationCurve::PiecewiseLinear(knots) => {
                knots.iter().map(|k| k.at).filter(|&at| at > self.start && at < self.end).collect()
            }
            OrientationCurve::Constant(_) | OrientationCurve::Formula(_) => Vec::new(),
        }
    }

    /// Formulas can be undefined somewhere: probes them along the path.
    fn check_finite(&self) -> Result<(), LabError> {
        const PROBES: u32 = 1000;
        for i in 0..=PROBES {
            let lambda = self.start + (self.end - self.start) * f64::from(i) / f64::from(PROBES);
            let point = self.at(lambda);
            let finite = |v: &Vector6<f64>, from: usize| v.iter().skip(from).take(3).all(|x| x.is_finite());
            for (key, from) in [("path.position", 0), ("path.orientation", 3)] {
                if !(finite(&point.coordinates, from) && finite(&point.first, from) && finite(&point.second, from)) {
                    return Err(LabError::value(key, Fault::UndefinedAt(lambda)));
                }
            }
        }
        Ok(())
    }
}

fn join(upper: &Vector3<f64>, lower: &Vector3<f64>) -> Vector6<f64> {
    Vector6::new(upper.x, upper.y, upper.z, lower.x, lower.y, lower.z)
}

fn vector(numbers: &[crate::scenario::number::Number; 3]) -> Vector3<f64> {
    Vector3::new(numbers[0].0, numbers[1].0, numbers[2].0)
}

fn formulas(texts: [(&str, &str); 3]) -> Result<Box<[Formula; 3]>, LabError> {
    let parse = |(key, text): (&str, &str)| Formula::new(text).map_err(|error| LabError::value(key, error));
    let [a, b, c] = texts;
    Ok(Box::new([parse(a)?, parse(b)?, parse(c)?]))
}

fn evaluate(formulas: &[Formula; 3], lambda: f64) -> Curve3 {
    let [x, y, z] = [formulas[0].at(lambda), formulas[1].at(lambda), formulas[2].at(lambda)];
    [0, 1, 2].map(|order| Vector3::new(x[order], y[order], z[order]))
}

impl PositionCurve {
    pub(crate) fn new(table: &PositionTable, begin: f64, end: f64, key: &str) -> Result<Self, LabError> {
        Ok(match table {
            PositionTable::Helix { start, radius, climb } => {
                if !(radius.0 > 0.0) {
                    return Err(LabError::value(format!("{key}.helix.radius"), Fault::NotPositive(radius.0)));
                }
                Self::Helix { start: vector(start), radius: radius.0, climb: climb.0 }
            }
            PositionTable::Line { from, to } => {
                let (from, to) = (vector(from), vector(to));
                Self::Line { from, rate: (to - from) / (end - begin), begin }
            }
            PositionTable::Formula { x, y, z } => Self::Formula(formulas([
                (&format!("{key}.formula.x"), x),
                (&format!("{key}.formula.y"), y),
                (&format!("{key}.formula.z"), z),
            ])?),
        })
    }

    /// `[G11] eq 25` for the helix: radius `radius`, starting at `start` in the direction of +y, `climb` m per rad along z.
    pub(crate) fn at(&self, lambda: f64) -> Curve3 {
        match self {
            Self::Helix { start, radius, climb } => {
                let (s, c) = lambda.sin_cos();
                [
                    start + Vector3::new(radius * (c - 1.0), radius * s, climb * lambda),
                    Vector3::new(-radius * s, radius * c, *climb),
                    Vector3::new(-radius * c, -radius * s, 0.0),
                ]
            }
            Self::Line { from, rate, begin } => [from + rate * (lambda - begin), *rate, Vector3::zeros()],
            Self::Formula(formulas) => evaluate(formulas, lambda),
        }
    }
}

impl OrientationCurve {
    fn new(table: &OrientationTable, start: f64, end: f64) -> Result<Self, LabError> {
        Ok(match table {
            OrientationTable::Constant { euler } => Self::Constant(vector(euler)),
            OrientationTable::PiecewiseLinear { knots } => {
                let knots: Vec<Knot> = knots.iter().map(|k| Knot { at: k.at.0, euler: vector(&k.euler) }).collect();
                Self::check_knots(&knots, start, end)?;
                Self::PiecewiseLinear(knots)
            }
            OrientationTable::Formula { alpha, beta, gamma } => Self::Formula(formulas([
                ("path.orientation.formula.alpha", alpha),
                ("path.orientation.formula.beta", beta),
                ("path.orientation.formula.gamma", gamma),
            ])?),
        })
    }

    /// At least two knots, in order, covering the path.
    fn check_knots(knots: &[Knot], start: f64, end: f64) -> Result<(), LabError> {
        const KEY: &str = "path.orientation.piecewise-linear.knots";
        let (Some(first), Some(last)) = (knots.first(), knots.last()) else {
            return Err(LabError::value(KEY, Fault::Missing("at least two knots are needed")));
        };
        for (i, pair) in knots.windows(2).enumerate() {
            if !(pair[0].at < pair[1].at) {
                let fault = Fault::NotIncreasing { before: pair[0].at, after: pair[1].at };
                return Err(LabError::value(format!("{KEY}.{}.at", i + 1), fault));
            }
        }
        if knots.len() < 2 || first.at > start || last.at < end {
            return Err(LabError::value(
                KEY,
                Fault::Missing("the knots must cover the path from its start to its end"),
            ));
        }
        Ok(())
    }

    fn at(&self, lambda: f64) -> Curve3 {
        match self {
            Self::Constant(euler) => [*euler, Vector3::zeros(), Vector3::zeros()],
            Self::PiecewiseLinear(knots) => {
                let after = knots.partition_point(|k| k.at <= lambda).clamp(1, knots.len() - 1);
                let (a, b) = (knots[after - 1], knots[after]);
                let rate = (b.euler - a.euler) / (b.at - a.at);
                [a.euler + rate * (lambda - a.at), rate, Vector3::zeros()]
            }
            Self::Formula(formulas) => evaluate(formulas, lambda),
        }
    }
}
