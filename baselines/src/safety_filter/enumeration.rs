//! Every active set in turn: exact, and exponential in the number of constraints.

use nalgebra::{DMatrix, DVector};

/// The smallest vector with `g_iᵀ u <= b_i`: the shortest feasible one among the minimum-norm solutions of all subsets of
/// equations. `None` if no subset gives a feasible one.
#[must_use]
pub fn smallest(rows: &[Vec<f64>], bounds: &[f64]) -> Option<Vec<f64>> {
    let dimension = rows.first().map_or(0, Vec::len);
    let mut best: Option<DVector<f64>> = None;
    for set in 0..1_usize << rows.len() {
        let members: Vec<usize> = (0..rows.len()).filter(|i| set >> i & 1 == 1).collect();
        if members.len() > dimension {
            continue;
        }
        let Some(u) = on_equations(rows, bounds, &members, dimension) else { continue };
        let feasible = rows.iter().zip(bounds).all(|(row, b)| {
            let length = row.iter().map(|r| r * r).sum::<f64>().sqrt();
            // Rounding of a solve whose equations are normalised.
            DVector::from_column_slice(row).dot(&u) - b <= 1e-12 * (b.abs() + length * (1e-3 + u.norm()))
        });
        if feasible && best.as_ref().is_none_or(|shortest| u.norm() < shortest.norm()) {
            best = Some(u);
        }
    }
    best.map(|u| u.as_slice().to_vec())
}

/// Minimum-norm solution of `g_iᵀ u = b_i` over the members: `u = Gᵀ (G Gᵀ)⁻¹ b`.
fn on_equations(rows: &[Vec<f64>], bounds: &[f64], members: &[usize], dimension: usize) -> Option<DVector<f64>> {
    if members.is_empty() {
        return Some(DVector::zeros(dimension));
    }
    let lengths: Vec<f64> = members.iter().map(|&i| rows[i].iter().map(|r| r * r).sum::<f64>().sqrt()).collect();
    if lengths.iter().any(|l| l.is_nan() || *l <= 0.0) {
        return None;
    }
    let g = DMatrix::from_fn(members.len(), dimension, |i, j| rows[members[i]][j] / lengths[i]);
    let b = DVector::from_fn(members.len(), |i, _| bounds[members[i]] / lengths[i]);
    let multipliers = (&g * g.transpose()).cholesky()?.solve(&b);
    Some(g.transpose() * multipliers)
}
