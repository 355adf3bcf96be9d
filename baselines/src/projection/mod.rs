//! Exact Euclidean projection of a reference onto the allowed set: the best any conditioner could do at one instant.
//!
//! - [`convex`]: intersections of half-spaces, balls, ellipsoids and cylinders, by Clarabel on second-order cones, with a
//!   lower bound computed from the repaired multipliers;
//! - [`beside_ball`] and [`outside_ellipsoid`]: non-convex sets with a closed form that is optimal globally;
//! - [`branch_and_bound`]: any constraints in three dimensions, with a certified gap;
//! - [`multi_start`]: any constraints, quickly, locally optimal.

pub mod beside_ball;
pub mod branch_and_bound;
pub mod convex;
pub mod multi_start;
pub mod outside_ellipsoid;

/// A projection and the bracket that certifies it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection<const N: usize> {
    /// The point.
    pub point: [f64; N],
    /// Its distance from what was projected.
    pub distance: f64,
    /// No point of the set is nearer than this.
    pub lower_bound: f64,
    /// Largest `σ_i` at the point, re-evaluated: at most 0 where the point lies in the set.
    pub violation: f64,
}

/// Reason why there is no projection.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ProjectionError {
    /// The set is empty, or the search space contains none of it.
    #[error("no allowed point was found")]
    Empty,
    /// The conic solver did not finish.
    #[error("the conic solver ended with {0:?}")]
    Solver(clarabel::solver::SolverStatus),
    /// The conic program could not be set up.
    #[error("the conic program was refused")]
    Setup,
    /// More boxes than allowed were needed.
    #[error("the bracket [{lower}, {upper}] is not closed after the allowed number of boxes")]
    Budget {
        /// Certified lower bound.
        lower: f64,
        /// Distance of the best point.
        upper: f64,
    },
    /// The input contains a NaN or an infinity.
    #[error("the point to project is not finite")]
    NotFinite,
}

pub(crate) fn distance<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt()
}
