use crate::error::{Fault, LabError};
use crate::formula::Formula;
use crate::scenario::schema::{OrientationTable, PathTable, PositionTable, TaskName};
use nalgebra::{Translation3, Vector3, Vector6};
use slideway_robot::{EulerAngles, Pose, Twist, euler};
use std::ops::Range;

/// A path of the tool: position and orientation as functions of the path parameter `λ`.
///
/// In m and rad, Euler triples meaning `Rz(α) Ry(β) Rx(γ)`, all in the base frame.
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

/// One point of a tool path with its derivatives by the path parameter, in the base frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPoint {
    /// Position and orientation.
    pub pose: Pose,
    /// `[p'(λ); ω(λ)]`, linear and angular speed per unit of path rate; at a kink, those of the piece that begins there.
    pub twist: Twist,
    /// `[p''(λ); ω'(λ)]`.
    pub acceleration: Twist,
    /// The orientation as an Euler triple, where the path gives it so: the controller then compares Euler triples, as
    /// `[G11]` does; else it takes the rotation vector between tool and reference.
    pub euler: Option<EulerPoint>,
}

/// The orientation of a path point in the convention `Rz(α) Ry(β) Rx(γ)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EulerPoint {
    /// `α, β, γ`, rad.
    pub angles: EulerAngles,
    /// Their derivatives by the path parameter.
    pub rates: EulerAngles,
}

/// Value and derivatives of three coordinates.
pub(crate) type Curve3 = [Vector3<f64>; 3];

impl CartesianPath {
    pub(crate) fn new(table: &PathTable, task: TaskName) -> Result<Self, LabError> {
        let Range { start, end } = range(table)?;
        let missing = Fault::Missing("say where the path leads: `path.position` for the tool or `path.joints`");
        let position = table.position.as_ref().ok_or_else(|| LabError::value("path", missing))?;
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
        let path =
            Self { start, end, position: PositionCurve::new(position, start, end, "path.position")?, orientation };
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
        let [angles, rates, rates2] = self.orientation.at(lambda);
        let map = euler::rate_map(&angles);
        PathPoint {
            pose: Pose::from_parts(Translation3::from(position), euler::rotation(&angles)),
            twist: join(&velocity, &(map * rates)),
            acceleration: join(&acceleration, &(map * rates2 + euler::rate_map_bias(&angles, &rates))),
            euler: Some(EulerPoint { angles, rates }),
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
            let finite = |curve: Curve3| curve.iter().all(|v| v.iter().all(|x| x.is_finite()));
            for (key, curve) in
                [("path.position", self.position.at(lambda)), ("path.orientation", self.orientation.at(lambda))]
            {
                if !finite(curve) {
                    return Err(LabError::value(key, Fault::UndefinedAt(lambda)));
                }
            }
        }
        Ok(())
    }
}

/// First and last path parameter.
pub(crate) fn range(table: &PathTable) -> Result<Range<f64>, LabError> {
    let (start, end) = (table.start.0, table.end.0);
    if start < end {
        Ok(start..end)
    } else {
        Err(LabError::value("path.end", Fault::NotIncreasing { before: start, after: end }))
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
