use super::expression::ExpressionConstraint;
use slideway_conditioner::ParameterError;
use slideway_conditioner::path::{Constraint, ConstraintSample, Motion};
use slideway_conditioner::shapes::{
    Ball, BoothOval, Cylinder, Ellipsoid, HalfSpace, Local, Moving, Oscillation, Polytope, Shape, Side, SmoothBox,
    Trajectory, UniformMotion, Waypoint,
};
use slideway_path::Fault;

/// A constraint with its name and its approach time.
#[derive(Clone, Debug)]
pub struct NamedConstraint {
    /// Name, for tables and files.
    pub name: String,
    /// Approach time `K`, s.
    pub approach: f64,
    /// Shape of the allowed set.
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
pub const POLYTOPE_FACES: usize = 12;

/// A motion that carries a constraint along.
#[derive(Clone, Copy, Debug)]
pub enum Carrier {
    /// Constant acceleration.
    Uniform(UniformMotion<3>),
    /// To and fro.
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

impl NamedConstraint {
    /// A constraint with its approach time `K`, s, and what carries it along, if anything does.
    ///
    /// # Errors
    ///
    /// An approach time that is not positive.
    pub fn new(name: String, approach: f64, shape: Shape3, motion: Option<Carrier>) -> Result<Self, Fault> {
        if !(approach > 0.0) {
            return Err(Fault::NotPositive(approach));
        }
        Ok(Self { name, approach, shape, motion })
    }

    /// True of a constraint that a carrier moves; a formula may also depend on `t`.
    #[must_use]
    pub fn is_carried(&self) -> bool {
        self.motion.is_some()
    }
}

impl Shape3 {
    /// One side of a plane: outward normal of any length and offset along it, m.
    ///
    /// # Errors
    ///
    /// A normal without length, or a number that is not finite.
    pub fn half_space(normal: &[f64; 3], offset: f64) -> Result<Self, ParameterError> {
        let shape = HalfSpace::new(normal, offset)?;
        Ok(Self::HalfSpace { normal: shape.normal(), offset: shape.offset(), shape })
    }

    /// A ball, m.
    ///
    /// # Errors
    ///
    /// A radius that is not positive and finite.
    pub fn ball(centre: [f64; 3], radius: f64, side: Side) -> Result<Self, ParameterError> {
        Ok(Self::Ball { centre, radius, side, shape: Ball::new(centre, radius, side)? })
    }

    /// An ellipsoid along the axes, m; `scale` as in [`Ellipsoid::new`].
    ///
    /// # Errors
    ///
    /// A semi-axis or a scale that is not positive and finite.
    pub fn ellipsoid(centre: [f64; 3], semi_axes: [f64; 3], scale: f64, side: Side) -> Result<Self, ParameterError> {
        Ok(Self::Ellipsoid { centre, semi_axes, side, shape: Ellipsoid::new(centre, &semi_axes, scale, side)? })
    }
}
