//! Curves of position and orientation.

use crate::error::ScenarioError;
use crate::read::waypoints::{Place, rotation, vector};
use crate::tables::curves::{PointList, RotationTable};
use crate::tables::path::{OrientationTable, PositionTable};
use slideway_path::curve::{Arc, CurveError, RotationWaypoints, Slerp, Spacing, Squad};
use slideway_path::formula::Formula;
use slideway_path::{EulerKnot, Fault, OrientationCurve, PositionCurve};
use std::ops::Range;

pub(crate) fn position_curve(table: &PositionTable, place: &Place<'_>) -> Result<PositionCurve, ScenarioError> {
    let range = place.range.clone();
    Ok(match table {
        PositionTable::Helix { start, radius, climb } => PositionCurve::helix(vector(start), radius.0, climb.0)
            .map_err(|fault| place.error("helix.radius", fault))?,
        PositionTable::Line { from, to } => PositionCurve::line(vector(from), vector(to), &range),
        PositionTable::Arc { from, via, to } => {
            let arc = Arc::through([from, via, to].map(vector), range);
            PositionCurve::Arc(arc.map_err(|error| place.error("arc.via", error))?)
        }
        PositionTable::Spline(table) => PositionCurve::Spline(place.inside("spline").spline(table)?),
        PositionTable::Lines(table) => PositionCurve::Lines(place.inside("lines").lines(table)?),
        PositionTable::Formula { x, y, z } => PositionCurve::Formula(formulas([
            (place.key("formula.x"), x),
            (place.key("formula.y"), y),
            (place.key("formula.z"), z),
        ])?),
    })
}

pub(crate) fn orientation_curve(
    table: &OrientationTable,
    place: &Place<'_>,
) -> Result<OrientationCurve, ScenarioError> {
    Ok(match table {
        OrientationTable::Constant { euler } => OrientationCurve::Constant(vector(euler)),
        OrientationTable::PiecewiseLinear { knots } => {
            let knots: Vec<EulerKnot> =
                knots.iter().map(|k| EulerKnot { at: k.at.0, euler: vector(&k.euler) }).collect();
            check_knots(&knots, place)?;
            OrientationCurve::piecewise_linear(knots).map_err(|error| place.error("piecewise-linear.knots", error))?
        }
        OrientationTable::Formula { alpha, beta, gamma } => OrientationCurve::Formula(formulas([
            (place.key("formula.alpha"), alpha),
            (place.key("formula.beta"), beta),
            (place.key("formula.gamma"), gamma),
        ])?),
        OrientationTable::Slerp { from, to } => OrientationCurve::Slerp(slerp(from, to, &place.inside("slerp"))?),
        OrientationTable::Squad { rotations, spacing, at } => {
            let list = PointList { points: None, csv: None, spacing: *spacing, at: at.as_deref() };
            OrientationCurve::Squad(squad(rotations, &list, &place.inside("squad"))?)
        }
    })
}

/// Three formulas with their keys.
fn formulas(texts: [(String, &String); 3]) -> Result<Box<[Formula; 3]>, ScenarioError> {
    let parse = |(key, text): (String, &String)| Formula::new(text).map_err(|error| ScenarioError::value(key, error));
    let [a, b, c] = texts;
    Ok(Box::new([parse(a)?, parse(b)?, parse(c)?]))
}

/// At least two knots, in order, covering the path.
fn check_knots(knots: &[EulerKnot], place: &Place<'_>) -> Result<(), ScenarioError> {
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

fn slerp(from: &RotationTable, to: &RotationTable, place: &Place<'_>) -> Result<Slerp, ScenarioError> {
    let read = |name: &str, table: &RotationTable| rotation(table).map_err(|error| place.error(name, error));
    let ends = vec![read("from", from)?, read("to", to)?];
    let turn = RotationWaypoints::new(ends, &Spacing::Uniform, place.range.clone());
    Ok(Slerp::new(turn.map_err(|error| place.error("to", error))?))
}

fn squad(tables: &[RotationTable], list: &PointList<'_>, place: &Place<'_>) -> Result<Squad, ScenarioError> {
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
