use super::expression::ExpressionConstraint;
use super::schema::{ConstraintTable, MotionTable, ShapeTable, SideName};
use crate::error::{Fault, LabError, ListOf};
use crate::scenario::number::Number;
use slideway_conditioner::path::{Constraint, ConstraintSample, Motion};
use slideway_conditioner::shapes::{
    Ball, BoothOval, Cylinder, Ellipsoid, HalfSpace, Local, Moving, Oscillation, Polytope, Shape, Side, SmoothBox,
    Trajectory, UniformMotion, Waypoint,
};

/// A constraint with its name and its approach time.
#[derive(Clone, Debug)]
pub struct NamedConstraint {
    /// Name, for tables and files.
    pub name: String,
    /// Approach time `K`, s.
    pub approach: f64,
    /// What is allowed.
    pub shape: Shape3,
    /// Half-space or ball data and the like, for baselines with a closed form: the shape as the scenario gives it.
    motion: Option<Carrier>,
}

/// The shapes a scenario can name.
#[derive(Clone, Debug)]
pub enum Shape3 {
    /// One side of a plane: unit normal and distance, which are those of the file divided by the normal's length.
    HalfSpace {
        /// Outward unit normal.
        normal: [f64; 3],
        /// Distance of the plane from the origin along it, m.
        offset: f64,
        /// The constraint.
        shape: HalfSpace<3>,
    },
    /// Smoothed intersection of half-spaces.
    Polytope(Box<Polytope<3, POLYTOPE_FACES>>),
    /// A ball.
    Ball {
        /// Centre, m.
        centre: [f64; 3],
        /// Radius, m.
        radius: f64,
        /// Allowed side.
        side: Side,
        /// The constraint.
        shape: Ball<3>,
    },
    /// An ellipsoid along the axes.
    Ellipsoid {
        /// Centre, m.
        centre: [f64; 3],
        /// Semi-axes, m.
        semi_axes: [f64; 3],
        /// Allowed side.
        side: Side,
        /// The constraint.
        shape: Ellipsoid<3>,
    },
    /// A cylinder.
    Cylinder(Cylinder<3>),
    /// A box with smoothed edges.
    Box(SmoothBox<3>),
    /// The oval of Booth.
    BoothOval(BoothOval<3>),
    /// A formula.
    Formula(Box<ExpressionConstraint>),
}

/// Faces of a polytope at the most.
pub(crate) const POLYTOPE_FACES: usize = 12;

/// How a constraint is carried along.
#[derive(Clone, Copy, Debug)]
enum Carrier {
    Uniform(UniformMotion<3>),
    Oscillation(Oscillation<3>),
}

impl Trajectory<3> for Carrier {
    fn at(&self, time: f64) -> Waypoint<3> {
        match self {
            Self::Uniform(motion) => motion.at(time),
            Self::Oscillation(motion) => motion.at(time),
        }
    }
}

/// The analytic shapes behind one interface, so that a carrier can move any of them.
struct Analytic<'a>(&'a Shape3);

impl Shape<3> for Analytic<'_> {
    fn local(&self, position: &[f64; 3], direction: &[f64; 3]) -> Local<3> {
        match self.0 {
            Shape3::HalfSpace { shape, .. } => shape.local(position, direction),
            Shape3::Polytope(shape) => shape.local(position, direction),
            Shape3::Ball { shape, .. } => shape.local(position, direction),
            Shape3::Ellipsoid { shape, .. } => shape.local(position, direction),
            Shape3::Cylinder(shape) => shape.local(position, direction),
            Shape3::Box(shape) => shape.local(position, direction),
            Shape3::BoothOval(shape) => shape.local(position, direction),
            Shape3::Formula(formula) => {
                let s = formula.sample(&Motion { time: 0.0, position: *position, velocity: *direction });
                Local { value: s.value, gradient: s.gradient, curvature: s.gradient_rate }
            }
        }
    }
}

impl Constraint<3> for NamedConstraint {
    fn sample(&self, motion: &Motion<3>) -> ConstraintSample<3> {
        match (&self.motion, &self.shape) {
            (Some(trajectory), shape) => Moving { shape: Analytic(shape), trajectory: *trajectory }.sample(motion),
            // A formula may depend on time by itself.
            (None, Shape3::Formula(formula)) => formula.sample(motion),
            (None, shape) => Analytic(shape).sample(motion),
        }
    }
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

impl NamedConstraint {
    /// From constraint number `index` of a scenario.
    pub(crate) fn new(table: &ConstraintTable, index: usize) -> Result<Self, LabError> {
        let key = format!("constraint.{index}");
        if !(table.approach.0 > 0.0) {
            return Err(LabError::value(format!("{key}.approach"), Fault::NotPositive(table.approach.0)));
        }
        let motion = table.motion.as_ref().map(carrier);
        let shape = Shape3::new(&table.shape, &format!("{key}.shape"))?;
        Ok(Self { name: table.name.clone(), approach: table.approach.0, shape, motion })
    }

    /// Whether the constraint moves (by a carrier; a formula may also depend on `t`).
    #[must_use]
    pub fn is_carried(&self) -> bool {
        self.motion.is_some()
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

impl Shape3 {
    fn new(table: &ShapeTable, key: &str) -> Result<Self, LabError> {
        let refused = |error| LabError::value(key, Fault::Conditioner(error));
        Ok(match table {
            ShapeTable::HalfSpace { normal, offset } => {
                let shape = HalfSpace::new(&vector(normal), offset.0).map_err(refused)?;
                Self::HalfSpace { normal: shape.normal(), offset: shape.offset(), shape }
            }
            ShapeTable::Polytope { normals, offsets, sharpness, side: s } => {
                Self::Polytope(Box::new(polytope(normals, offsets, sharpness.0, side(*s), key)?))
            }
            ShapeTable::Sphere { centre, radius, side: s } => Self::Ball {
                centre: vector(centre),
                radius: radius.0,
                side: side(*s),
                shape: Ball::new(vector(centre), radius.0, side(*s)).map_err(refused)?,
            },
            ShapeTable::Ellipsoid { centre, semi_axes, scale, side: s } => Self::Ellipsoid {
                centre: vector(centre),
                semi_axes: vector(semi_axes),
                side: side(*s),
                shape: Ellipsoid::new(vector(centre), &vector(semi_axes), scale.0, side(*s)).map_err(refused)?,
            },
            ShapeTable::Cylinder { point, axis, radius, side: s } => {
                Self::Cylinder(Cylinder::new(vector(point), &vector(axis), radius.0, side(*s)).map_err(refused)?)
            }
            ShapeTable::Box { centre, half_edges, exponent, scale, side: s } => Self::Box(
                SmoothBox::new(vector(centre), vector(half_edges), exponent.0, scale.0, side(*s)).map_err(refused)?,
            ),
            ShapeTable::BoothOval { weights, radius, side: s } => {
                Self::BoothOval(BoothOval::new(vector(weights), radius.0, side(*s)).map_err(refused)?)
            }
            ShapeTable::Formula(text) => Self::Formula(Box::new(
                ExpressionConstraint::new(text).map_err(|e| LabError::value(format!("{key}.formula"), e))?,
            )),
        })
    }
}

fn polytope(
    normals: &[[Number; 3]],
    offsets: &[Number],
    sharpness: f64,
    side: Side,
    key: &str,
) -> Result<Polytope<3, POLYTOPE_FACES>, LabError> {
    if normals.len() != offsets.len() {
        let fault = Fault::WrongLength { found: offsets.len(), expected: normals.len(), list: ListOf::Faces };
        return Err(LabError::value(format!("{key}.polytope.offsets"), fault));
    }
    if normals.is_empty() || normals.len() > POLYTOPE_FACES {
        let fault = Fault::OutOfRange { value: normals.len() as f64, least: 1.0, most: POLYTOPE_FACES as f64 };
        return Err(LabError::value(format!("{key}.polytope.normals"), fault));
    }
    let normals: Vec<[f64; 3]> = normals.iter().map(vector).collect();
    let offsets: Vec<f64> = offsets.iter().map(|offset| offset.0).collect();
    Polytope::with_faces(&normals, &offsets, sharpness, side)
        .map_err(|error| LabError::value(format!("{key}.polytope"), Fault::Conditioner(error)))
}
