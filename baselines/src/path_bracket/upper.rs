//! The upper bound: a profile that keeps every limit on whole cells, and its time, both with outward rounding.

use crate::outward::Outward;

use super::cell_time::cell_time;
use super::cells::Cell;
use super::path::JointLimits;
use super::rows::excess;

/// The three numbers of `b` in cell `k`.
#[inline]
pub(crate) fn of_cell(b: &[f64], k: usize) -> [f64; 3] {
    [b[2 * k], b[2 * k + 1], b[2 * k + 2]]
}

/// Times that scaling is repeated. The first scaling reaches the limits up to rounding, which in short cells is far above an epsilon (a difference of
/// neighbours' `b` over their distance); the next ones go twice as far below as is still missing, and further each time.
const TRIES: usize = 8;

/// Scales a profile (node, middle, node, ...) down until no limit is exceeded in any cell, as [`excess`] proves. Every row is homogeneous in `b`.
/// `None` if the profile is no profile: not positive, not finite, or never within the limits.
pub(crate) fn within_limits<'c>(
    cells: impl Iterator<Item = &'c Cell> + Clone,
    limits: &JointLimits,
    mut b: Vec<f64>,
) -> Option<Vec<f64>> {
    for attempt in 0..TRIES {
        let worst = cells.clone().enumerate().map(|(k, cell)| excess(cell, limits, of_cell(&b, k)).0).fold(0.0, worse);
        if worst <= 1.0 && attempt > 0 {
            return Some(b);
        }
        if !(worst > 0.0 && worst.is_finite()) {
            return None;
        }
        // The first time up to the limits as well as down to them.
        let further = if attempt == 0 { 0.0 } else { (worst - 1.0).abs() * f64::from(1 << attempt) };
        let factor = (1.0 / worst) * (1.0 - 4.0 * f64::EPSILON - further);
        b.iter_mut().for_each(|b| *b *= factor);
    }
    None
}

/// The larger; NaN is the largest.
fn worse(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}

/// Times of all cells, enclosed.
pub(crate) fn times<'c>(cells: impl Iterator<Item = &'c Cell>, b: &[f64]) -> Vec<Outward> {
    cells.enumerate().map(|(k, cell)| cell_time(cell.length, of_cell(b, k))).collect()
}
