//! The time optimum along a joint path, bracketed for every point of the path.
//!
//! With `b = ds/dt²`, `u = b'/2` the second derivative of `s` by time, and joint limits along `q(s)`
//!
//! ```text
//! q̇ = q' √b,   q̈ = q' u + q'' b,   T = ∫ b^(-1/2) ds
//! ```
//!
//! [`PathBracket::solve`] encloses the least `T`: no motion along the path that keeps the limits is faster than `lower_s`, and the profile that comes with the
//! answer keeps them on whole cells and takes `upper_s`. [`crate::time_optimal`] is about the rows at the nodes of a grid, and its bracket
//! lies off this one by an amount of the first order in the grid.
//!
//! - Above: `b` is a quadratic in every cell, limits hold for all Bernstein coefficients (`rows`), the time is in closed form (`cell_time`).
//! - Below: weak duality in function space with multipliers that are sums of hat functions (`hats`, `polish`, `enclosure`).
//! - Between: the difference is a sum over cells, and the cells that hold most of it are halved (`refine`).
//!
//! Neither bound rests on a solver: multipliers and profiles are checked with outward rounding, whatever their origin. What is bracketed is the path
//! whose derivative has the numbers stored in the first cells, the input rounded (`cells`).
//!
//! Limits are those of joints, constant along the path; a row of another kind `a u + c b + d <= U` would join `rows` (above) and `enclosure` (below), each
//! with the remainder of its polynomials against it.
//!
//! Sources: Verscheure et al. 2009 for `b`; the bracket is this project's.
#![allow(clippy::needless_range_loop, reason = "one index runs over several lists: rows, slacks, multipliers")]

mod banded;
mod bernstein;
mod bracket;
mod caps;
mod cell_time;
mod cells;
mod chain;
#[cfg(test)]
mod check;
mod conic;
mod enclosure;
mod error;
mod givens;
mod hats;
mod interior_point;
mod minimise;
mod path;
mod polish;
mod profile;
mod refine;
mod rows;
mod speed_only;
mod upper;

pub use bracket::{BracketOptions, CellGap, PathBracket, Solver, StopReason};
pub use error::BracketError;
pub use path::{End, JointLimits, JointPath, JointPathProblem, Sense};
pub use profile::{PathState, Profile};
pub use rows::LimitName;
