use crate::curve::{Arc, BlendedLines, CubicSpline};
use crate::error::{Fault, LabError};
use crate::formula::Formula;
use crate::path::waypoint_reader::{Place, vector};
use crate::scenario::schema::PositionTable;
use nalgebra::Vector3;

/// Position along the path, m.
#[derive(Clone, Debug)]
pub(crate) enum PositionCurve {
    Helix { start: Vector3<f64>, radius: f64, climb: f64 },
    Line { from: Vector3<f64>, rate: Vector3<f64>, begin: f64 },
    Arc(Arc),
    Spline(CubicSpline<3>),
    Lines(BlendedLines<3>),
    Formula(Box<[Formula; 3]>),
}

/// Value and derivatives of three coordinates.
pub(crate) type Curve3 = [Vector3<f64>; 3];

impl PositionCurve {
    pub(crate) fn new(table: &PositionTable, place: &Place<'_>) -> Result<Self, LabError> {
        let range = place.range.clone();
        Ok(match table {
            PositionTable::Helix { start, radius, climb } => {
                if !(radius.0 > 0.0) {
                    return Err(place.error("helix.radius", Fault::NotPositive(radius.0)));
                }
                Self::Helix { start: vector(start), radius: radius.0, climb: climb.0 }
            }
            PositionTable::Line { from, to } => {
                let (from, to) = (vector(from), vector(to));
                Self::Line { from, rate: (to - from) / (range.end - range.start), begin: range.start }
            }
            PositionTable::Arc { from, via, to } => {
                let arc = Arc::through([from, via, to].map(vector), range);
                Self::Arc(arc.map_err(|error| place.error("arc.via", error))?)
            }
            PositionTable::Spline(table) => Self::Spline(place.inside("spline").spline(table)?),
            PositionTable::Lines(table) => Self::Lines(place.inside("lines").lines(table)?),
            PositionTable::Formula { x, y, z } => Self::Formula(formulas([
                (place.key("formula.x"), x),
                (place.key("formula.y"), y),
                (place.key("formula.z"), z),
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
            Self::Arc(arc) => arc.at(lambda),
            Self::Spline(spline) => spline.at(lambda),
            Self::Lines(lines) => lines.at(lambda),
            Self::Formula(formulas) => evaluate(formulas, lambda),
        }
    }

    /// Path parameters where the first derivative jumps.
    pub(crate) fn kinks(&self) -> Vec<f64> {
        match self {
            Self::Lines(lines) => lines.kinks(),
            Self::Helix { .. } | Self::Line { .. } | Self::Arc(_) | Self::Spline(_) | Self::Formula(_) => Vec::new(),
        }
    }
}

/// Three formulas with their keys.
pub(crate) fn formulas(texts: [(String, &String); 3]) -> Result<Box<[Formula; 3]>, LabError> {
    let parse = |(key, text): (String, &String)| Formula::new(text).map_err(|error| LabError::value(key, error));
    let [a, b, c] = texts;
    Ok(Box::new([parse(a)?, parse(b)?, parse(c)?]))
}

/// Three formulas and their derivatives at a path parameter.
pub(crate) fn evaluate(formulas: &[Formula; 3], lambda: f64) -> Curve3 {
    let [x, y, z] = [formulas[0].at(lambda), formulas[1].at(lambda), formulas[2].at(lambda)];
    [0, 1, 2].map(|order| Vector3::new(x[order], y[order], z[order]))
}
