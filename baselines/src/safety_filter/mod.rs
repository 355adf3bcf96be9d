//! The QP safety filter: at every sample the smallest push that keeps every `φ_i <= 0`, found by a quadratic program.
//!
//! A small dense active-set method ([`dense`]) solves it; the enumeration of all active sets ([`enumeration`]), which is slow and cannot
//! be wrong, and Clarabel are what the tests hold it against, behind the same trait.

pub mod dense;
pub mod enumeration;
mod filter;

pub use filter::{FilterError, FilterSettings, QpFilter};

/// Minimises `‖u‖²` subject to `g_iᵀ u <= b_i`.
pub trait SmallestPush {
    /// The minimiser, or `None` where the half-spaces have no common point or the method gives up.
    fn smallest(&mut self, rows: &[Vec<f64>], bounds: &[f64]) -> Option<Vec<f64>>;
}
