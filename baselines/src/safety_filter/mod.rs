//! The QP safety filter: at every sample the smallest push that keeps every `φ_i <= 0`, found by a quadratic program.
//!
//! The same problem is solved three ways behind one trait, so that speeds can be compared fairly and answers checked:
//! Clarabel with data updates ([`conic`]), a small dense active-set method ([`dense`]), and the enumeration of all active
//! sets ([`enumeration`]), which is slow and cannot be wrong.

pub mod conic;
pub mod dense;
pub mod enumeration;
mod filter;

pub use filter::{FilterError, FilterSettings, QpFilter};

/// Minimises `‖u‖²` subject to `g_iᵀ u <= b_i`.
pub trait SmallestPush {
    /// The minimiser, or `None` where the half-spaces have no common point or the method gives up.
    fn smallest(&mut self, rows: &[Vec<f64>], bounds: &[f64]) -> Option<Vec<f64>>;
}
