//! Constraint shapes with analytic gradients and curvatures.
//!
//! Every shape is a function `s(p)` of the position, positive where it is forbidden to be. [`Side`] says whether the
//! inside or the outside of the body is allowed. A shape that stands still is a [`crate::path::Constraint`] as it is;
//! [`Moving`] carries one along a [`Trajectory`].
//!
//! Where a shape is not differentiable (the centre of a ball, the axis of a cylinder) its gradient is reported as zero,
//! and the conditioner holds with [`crate::path::HoldReason::EmptyGradient`] if it would have to push there.

mod ball;
mod booth_oval;
mod cylinder;
mod ellipsoid;
mod half_space;
mod moving;
mod parameter;
mod polytope;
mod smooth_box;

pub use ball::Ball;
pub use booth_oval::BoothOval;
pub use cylinder::Cylinder;
pub use ellipsoid::Ellipsoid;
pub use half_space::HalfSpace;
pub use moving::{Moving, Oscillation, Trajectory, UniformMotion, Waypoint};
pub use parameter::ShapeParameter;
pub use polytope::Polytope;
pub use smooth_box::SmoothBox;

use crate::path::{Constraint, ConstraintSample, Motion};

/// Which side of a closed surface is allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Stay inside: a work space.
    Inside,
    /// Stay outside: an obstacle.
    Outside,
}

impl Side {
    /// Sign of `(size of the body) - (where we are)`.
    fn sign(self) -> f64 {
        match self {
            Self::Inside => 1.0,
            Self::Outside => -1.0,
        }
    }

    /// `sign (inner)`, for a local form written for the inside.
    fn orient<const N: usize>(self, inner: Local<N>) -> Local<N> {
        let sign = self.sign();
        Local {
            value: sign * inner.value,
            gradient: inner.gradient.map(|g| sign * g),
            curvature: inner.curvature.map(|c| sign * c),
        }
    }
}

/// A shape near one point, looked at along one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Local<const N: usize> {
    /// `s(p)`.
    pub value: f64,
    /// `∇s(p)`.
    pub gradient: [f64; N],
    /// `∇²s(p) v`.
    pub curvature: [f64; N],
}

/// A twice differentiable function of the position.
pub trait Shape<const N: usize> {
    /// Value, gradient and Hessian times `direction`.
    fn local(&self, position: &[f64; N], direction: &[f64; N]) -> Local<N>;
}

impl<const N: usize, S: Shape<N>> Constraint<N> for S {
    #[inline]
    fn sample(&self, motion: &Motion<N>) -> ConstraintSample<N> {
        let local = self.local(&motion.position, &motion.velocity);
        ConstraintSample {
            value: local.value,
            gradient: local.gradient,
            time_rate: 0.0,
            gradient_rate: local.curvature,
            time_rate_rate: 0.0,
        }
    }
}
