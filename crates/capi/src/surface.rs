//! The built-in shapes as one type, so that a conditioner holds any mixture of them.

use slideway_conditioner::path::{Constraint as Evaluate, ConstraintSample, Motion};
use slideway_conditioner::shapes::{
    Ball, BoothOval, Cylinder, Ellipsoid, HalfSpace, Local, Moving, Oscillation, Polytope, Shape, SmoothBox,
    Trajectory, UniformMotion, Waypoint,
};

use crate::MAX_FACES;
use crate::callback::Callback;

/// A built-in shape.
pub(crate) enum Surface<const N: usize> {
    HalfSpace(HalfSpace<N>),
    Ball(Ball<N>),
    Cylinder(Cylinder<N>),
    Ellipsoid(Ellipsoid<N>),
    SmoothBox(SmoothBox<N>),
    BoothOval(BoothOval<N>),
    Polytope(Polytope<N, MAX_FACES>),
}

impl<const N: usize> Shape<N> for Surface<N> {
    fn local(&self, position: &[f64; N], direction: &[f64; N]) -> Local<N> {
        match self {
            Self::HalfSpace(shape) => shape.local(position, direction),
            Self::Ball(shape) => shape.local(position, direction),
            Self::Cylinder(shape) => shape.local(position, direction),
            Self::Ellipsoid(shape) => shape.local(position, direction),
            Self::SmoothBox(shape) => shape.local(position, direction),
            Self::BoothOval(shape) => shape.local(position, direction),
            Self::Polytope(shape) => shape.local(position, direction),
        }
    }
}

/// A displacement over time.
pub(crate) enum Carrier<const N: usize> {
    Uniform(UniformMotion<N>),
    Oscillation(Oscillation<N>),
}

impl<const N: usize> Trajectory<N> for Carrier<N> {
    fn at(&self, time: f64) -> Waypoint<N> {
        match self {
            Self::Uniform(motion) => motion.at(time),
            Self::Oscillation(motion) => motion.at(time),
        }
    }
}

/// Any constraint of a conditioner.
pub(crate) enum Wall<const N: usize> {
    Still(Surface<N>),
    Moving(Moving<Surface<N>, Carrier<N>>),
    Callback(Callback),
}

impl<const N: usize> Evaluate<N> for Wall<N> {
    #[inline(never)]
    fn sample(&self, motion: &Motion<N>) -> ConstraintSample<N> {
        match self {
            Self::Still(shape) => shape.sample(motion),
            Self::Moving(shape) => shape.sample(motion),
            Self::Callback(callback) => callback.sample(motion),
        }
    }
}
