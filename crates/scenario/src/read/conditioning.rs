//! The problem of a conditioning scenario.

use crate::error::ScenarioError;
use crate::read::curves::position_curve;
use crate::read::waypoints::Place;
use crate::tables::conditioning::{
    ConditioningFile, ConstraintTable, LawTable, MarginTable, MotionTable, PathDisturbancesTable, ReferenceTable,
    ShapeTable, SideName, TrapTable, WalkTable,
};
use crate::tables::number::Number;
use slideway_conditioner::path::{Reserve, SwitchingLaw, TrapSettings, Walk};
use slideway_conditioner::shapes::{BoothOval, Cylinder, Oscillation, Polytope, Side, SmoothBox, UniformMotion};
use slideway_lab::conditioning::{
    Carrier, ConditioningProblem, ExpressionConstraint, MarginChoice, NamedConstraint, POLYTOPE_FACES,
    PathDisturbances, Reference, Shape3,
};
use slideway_path::{Fault, ListOf, ProblemError};
use std::path::Path;

/// The problem that a file describes; files that it names lie in `folder`.
pub(crate) fn read_conditioning(file: &ConditioningFile, folder: &Path) -> Result<ConditioningProblem, ScenarioError> {
    let constraints = file.constraint.iter().enumerate().map(|(i, table)| constraint(table, i));
    let conditioner = &file.conditioner;
    let field = &file.potential_field;
    let mut problem = ConditioningProblem::new(
        reference(&file.reference, folder)?,
        constraints.collect::<Result<_, _>>()?,
        conditioner.sampling_period.0,
        conditioner.push_cutoff.0,
        match conditioner.law {
            LawTable::Normalised { amplitude } => SwitchingLaw::Normalised { amplitude: amplitude.0 },
            LawTable::Sum { gain } => SwitchingLaw::Sum { gain: gain.0 },
        },
    );
    problem.margin = match &conditioner.margin {
        MarginTable::None => MarginChoice::None,
        MarginTable::Band => MarginChoice::Band,
        MarginTable::Fixed(margins) => MarginChoice::Fixed(margins.iter().map(|m| m.0).collect()),
    };
    problem.reserve = conditioner.reserve_rate.map_or(Reserve::Off, |r| Reserve::On { recovery_rate: r.0 });
    problem.recovery_rate = conditioner.recovery_rate.map_or(problem.recovery_rate, |r| r.0);
    problem.trap = file.trap.as_ref().map(trap);
    problem.attraction = field.attraction.map_or(problem.attraction, |v| v.0);
    problem.repulsion = field.repulsion.map_or(problem.repulsion, |v| v.0);
    problem.influence = field.influence.map_or(problem.influence, |v| v.0);
    problem.disturbances = disturbances(&file.disturbances);
    file.verify.read()?;
    problem.check()?;
    Ok(problem)
}

fn reference(table: &ReferenceTable, folder: &Path) -> Result<Reference, ScenarioError> {
    let range = table.start.0..table.end.0;
    // A curve needs a range to run over.
    if !(range.start < range.end) {
        let fault = Fault::NotIncreasing { before: range.start, after: range.end };
        return Err(ScenarioError::value("reference.end", fault));
    }
    let place = Place { key: "reference.position".to_owned(), folder, range: range.clone() };
    let curve = position_curve(&table.position, &place)?;
    Ok(Reference::new(curve, range, table.rate.0, table.max_duration.map(|d| d.0))?)
}

fn disturbances(table: &PathDisturbancesTable) -> PathDisturbances {
    PathDisturbances {
        seed: table.seed.unwrap_or(0),
        initial_error: table.initial_error.map_or([0.0; 3], |e| e.map(|e| e.0)),
        distance_noise: table.distance_noise.map_or(0.0, |n| n.0),
        delay: table.delay.unwrap_or(0),
        jitter: table.jitter.map_or(0.0, |j| j.0),
    }
}

/// Constraint number `index` of a scenario.
fn constraint(table: &ConstraintTable, index: usize) -> Result<NamedConstraint, ProblemError> {
    let key = format!("constraint.{index}");
    let shape = shape(&table.shape, &format!("{key}.shape"))?;
    NamedConstraint::new(table.name.clone(), table.approach.0, shape, table.motion.as_ref().map(carrier))
        .map_err(|fault| ProblemError::value(format!("{key}.approach"), fault))
}

fn vector(numbers: &[Number; 3]) -> [f64; 3] {
    [numbers[0].0, numbers[1].0, numbers[2].0]
}

fn side(name: SideName) -> Side {
    match name {
        SideName::Inside => Side::Inside,
        SideName::Outside => Side::Outside,
    }
}

fn carrier(table: &MotionTable) -> Carrier {
    match table {
        MotionTable::Uniform { velocity, acceleration } => {
            Carrier::Uniform(UniformMotion { velocity: vector(velocity), acceleration: vector(acceleration) })
        }
        MotionTable::Oscillation { amplitude, frequency, phase } => {
            Carrier::Oscillation(Oscillation { amplitude: vector(amplitude), frequency: frequency.0, phase: phase.0 })
        }
    }
}

fn shape(table: &ShapeTable, key: &str) -> Result<Shape3, ProblemError> {
    let refused = |error| ProblemError::value(key, Fault::Conditioner(error));
    Ok(match table {
        ShapeTable::HalfSpace { normal, offset } => Shape3::half_space(&vector(normal), offset.0).map_err(refused)?,
        ShapeTable::Polytope { normals, offsets, sharpness, side: s } => {
            Shape3::Polytope(Box::new(polytope(normals, offsets, sharpness.0, side(*s), key)?))
        }
        ShapeTable::Sphere { centre, radius, side: s } => {
            Shape3::ball(vector(centre), radius.0, side(*s)).map_err(refused)?
        }
        ShapeTable::Ellipsoid { centre, semi_axes, scale, side: s } => {
            Shape3::ellipsoid(vector(centre), vector(semi_axes), scale.0, side(*s)).map_err(refused)?
        }
        ShapeTable::Cylinder { point, axis, radius, side: s } => {
            Shape3::Cylinder(Cylinder::new(vector(point), &vector(axis), radius.0, side(*s)).map_err(refused)?)
        }
        ShapeTable::Box { centre, half_edges, exponent, scale, side: s } => Shape3::Box(
            SmoothBox::new(vector(centre), vector(half_edges), exponent.0, scale.0, side(*s)).map_err(refused)?,
        ),
        ShapeTable::BoothOval { weights, radius, side: s } => {
            Shape3::BoothOval(BoothOval::new(vector(weights), radius.0, side(*s)).map_err(refused)?)
        }
        ShapeTable::Formula(text) => Shape3::Formula(Box::new(
            ExpressionConstraint::new(text).map_err(|e| ProblemError::value(format!("{key}.formula"), e))?,
        )),
    })
}

fn polytope(
    normals: &[[Number; 3]],
    offsets: &[Number],
    sharpness: f64,
    side: Side,
    key: &str,
) -> Result<Polytope<3, POLYTOPE_FACES>, ProblemError> {
    if normals.len() != offsets.len() {
        let fault = Fault::WrongLength { found: offsets.len(), expected: normals.len(), list: ListOf::Faces };
        return Err(ProblemError::value(format!("{key}.polytope.offsets"), fault));
    }
    if normals.is_empty() || normals.len() > POLYTOPE_FACES {
        let fault = Fault::OutOfRange { value: normals.len() as f64, least: 1.0, most: POLYTOPE_FACES as f64 };
        return Err(ProblemError::value(format!("{key}.polytope.normals"), fault));
    }
    let normals: Vec<[f64; 3]> = normals.iter().map(vector).collect();
    let offsets: Vec<f64> = offsets.iter().map(|offset| offset.0).collect();
    Polytope::with_faces(&normals, &offsets, sharpness, side)
        .map_err(|error| ProblemError::value(format!("{key}.polytope"), Fault::Conditioner(error)))
}

fn trap(table: &TrapTable) -> TrapSettings {
    TrapSettings {
        walk_cutoff: table.walk_cutoff.0,
        pace_cutoff: table.pace_cutoff.0,
        walk: match table.walk {
            WalkTable::Paper => Walk::Paper,
            WalkTable::Safe { push_share } => Walk::Safe { push_share: push_share.0 },
        },
        walk_speed: table.walk_speed.0,
        walk_growth: table.walk_growth.map_or(table.walk_speed.0, |g| g.0),
        return_gain: table.return_gain.0,
        direction_period: table.direction_period.0,
        distance_threshold: table.distance_threshold.0,
        clearance_threshold: table.clearance_threshold.0,
        activity_threshold: table.activity_threshold.0,
        seed: table.seed,
    }
}
