use crate::curve::{CurveError, RotationPoint, RotationWaypoints, Slerp, Spacing, Squad};
use crate::error::{Fault, LabError};
use crate::formula::Formula;
use crate::path::EulerPoint;
use crate::path::position::{Curve3, evaluate, formulas};
use crate::path::waypoint_reader::{Place, rotation, vector};
use crate::scenario::curves::{PointList, RotationTable};
use crate::scenario::schema::OrientationTable;
use nalgebra::{Rotation3, Vector3};
use slideway_robot::euler;
use std::ops::Range;

/// Orientation along the path: Euler triples, or rotations.
#[derive(Clone, Debug)]
pub(crate) enum OrientationCurve {
    Constant(Vector3<f64>),
    PiecewiseLinear(Vec<Knot>),
    Formula(Box<[Formula; 3]>),
    Slerp(Slerp),
    Squad(Squad),
}

/// An Euler triple at a path parameter.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Knot {
    at: f64,
    euler: Vector3<f64>,
}

/// The orientation at a path parameter.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OrientationPoint {
    pub(crate) rotation: Rotation3<f64>,
    /// `ω` and `ω'` by the path parameter, base frame.
    pub(crate) velocity: Vector3<f64>,
    pub(crate) acceleration: Vector3<f64>,
    /// The Euler triple, where the path is given in them.
    pub(crate) euler: Option<EulerPoint>,
}

impl OrientationCurve {
    pub(crate) fn new(table: &OrientationTable, place: &Place<'_>) -> Result<Self, LabError> {
        Ok(match table {
            OrientationTable::Constant { euler } => Self::Constant(vector(euler)),
            OrientationTable::PiecewiseLinear { knots } => {
                let knots: Vec<Knot> = knots.iter().map(|k| Knot { at: k.at.0, euler: vector(&k.euler) }).collect();
                check_knots(&knots, place)?;
                Self::PiecewiseLinear(knots)
            }
            OrientationTable::Formula { alpha, beta, gamma } => Self::Formula(formulas([
                (place.key("formula.alpha"), alpha),
                (place.key("formula.beta"), beta),
                (place.key("formula.gamma"), gamma),
            ])?),
            OrientationTable::Slerp { from, to } => Self::Slerp(slerp(from, to, &place.inside("slerp"))?),
            OrientationTable::Squad { rotations, spacing, at } => {
                let list = PointList { points: None, csv: None, spacing: *spacing, at: at.as_deref() };
                Self::Squad(squad(rotations, &list, &place.inside("squad"))?)
            }
        })
    }

    /// No turn at all, for tasks that leave the orientation free.
    pub(crate) fn standing() -> Self {
        Self::Constant(Vector3::zeros())
    }

    pub(crate) fn at(&self, lambda: f64) -> OrientationPoint {
        match self {
            Self::Constant(euler) => from_euler([*euler, Vector3::zeros(), Vector3::zeros()]),
            Self::PiecewiseLinear(knots) => {
                let after = knots.partition_point(|k| k.at <= lambda).clamp(1, knots.len() - 1);
                let (a, b) = (knots[after - 1], knots[after]);
                let rate = (b.euler - a.euler) / (b.at - a.at);
                from_euler([a.euler + rate * (lambda - a.at), rate, Vector3::zeros()])
            }
            Self::Formula(formulas) => from_euler(evaluate(formulas, lambda)),
            Self::Slerp(slerp) => slerp.at(lambda).into(),
            Self::Squad(squad) => squad.at(lambda).into(),
        }
    }

    /// Path parameters where the first derivative jumps.
    pub(crate) fn kinks(&self) -> Vec<f64> {
        match self {
            Self::PiecewiseLinear(knots) => knots.iter().map(|k| k.at).collect(),
            Self::Slerp(slerp) => slerp.kinks(),
            Self::Constant(_) | Self::Formula(_) | Self::Squad(_) => Vec::new(),
        }
    }
}

/// `ω = E rates`, `ω' = E rates' + Ė rates`.
fn from_euler([angles, rates, rates2]: Curve3) -> OrientationPoint {
    let map = euler::rate_map(&angles);
    OrientationPoint {
        rotation: euler::rotation(&angles),
        velocity: map * rates,
        acceleration: map * rates2 + euler::rate_map_bias(&angles, &rates),
        euler: Some(EulerPoint { angles, rates }),
    }
}

impl From<RotationPoint> for OrientationPoint {
    fn from(point: RotationPoint) -> Self {
        Self {
            rotation: point.rotation.to_rotation_matrix(),
            velocity: point.velocity,
            acceleration: point.acceleration,
            euler: None,
        }
    }
}

/// At least two knots, in order, covering the path.
fn check_knots(knots: &[Knot], place: &Place<'_>) -> Result<(), LabError> {
    const KEY: &str = "piecewise-linear.knots";
    let (Some(first), Some(last)) = (knots.first(), knots.last()) else {
        return Err(place.error(KEY, Fault::Missing("at least two knots are needed")));
    };
    for (i, pair) in knots.windows(2).enumerate() {
        if !(pair[0].at < pair[1].at) {
            let fault = Fault::NotIncreasing { before: pair[0].at, after: pair[1].at };
            return Err(place.error(&format!("{KEY}.{}.at", i + 1), fault));
        }
    }
    let Range { start, end } = place.range;
    if knots.len() < 2 || first.at > start || last.at < end {
        return Err(place.error(KEY, Fault::Missing("the knots must cover the path from its start to its end")));
    }
    Ok(())
}

fn slerp(from: &RotationTable, to: &RotationTable, place: &Place<'_>) -> Result<Slerp, LabError> {
    let read = |name: &str, table: &RotationTable| rotation(table).map_err(|error| place.error(name, error));
    let ends = vec![read("from", from)?, read("to", to)?];
    let turn = RotationWaypoints::new(ends, &Spacing::Uniform, place.range.clone());
    Ok(Slerp::new(turn.map_err(|error| place.error("to", error))?))
}

fn squad(tables: &[RotationTable], list: &PointList<'_>, place: &Place<'_>) -> Result<Squad, LabError> {
    let read = |(i, table): (usize, &RotationTable)| {
        rotation(table).map_err(|error| place.error(&format!("rotations.{i}"), error))
    };
    let rotations = tables.iter().enumerate().map(read).collect::<Result<Vec<_>, _>>()?;
    // Even steps unless told otherwise: an orientation often stands for a while, and has no length there.
    let spacing = place.spacing(list, Spacing::Uniform)?;
    let waypoints = RotationWaypoints::new(rotations, &spacing, place.range.clone()).map_err(|error| match error {
        CurveError::NotIncreasing { index, .. } => place.error(&format!("at.{index}"), error),
        CurveError::ParameterCount { .. } => place.error("at", error),
        _ => match error.index() {
            Some(index) => place.error(&format!("rotations.{index}"), error),
            None => place.error("rotations", error),
        },
    })?;
    Ok(Squad::new(waypoints))
}
