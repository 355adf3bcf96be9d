//! A small dense active-set method on the dual.

use nalgebra::{DMatrix, DVector};

use super::SmallestPush;

/// Lawson and Hanson's non-negative least squares on the dual of the smallest push.
///
/// The point of `{u : G u <= b}` nearest to the origin follows from the non-negative least-squares problem
/// `min ‖E y - f‖`, `y >= 0`, with `E = [-Gᵀ; -bᵀ]` and `f = (0, 1)`: with the residual `r = E y - f`,
/// `u = -r_1..n / r_(n+1)`, and no common point exists if the residual vanishes (Lawson, Hanson 1974, chapter 23).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DualActiveSet;

impl SmallestPush for DualActiveSet {
    fn smallest(&mut self, rows: &[Vec<f64>], bounds: &[f64]) -> Option<Vec<f64>> {
        let n = rows.first().map_or(0, Vec::len);
        let m = rows.len();
        let scale: Vec<f64> = rows.iter().map(|r| r.iter().map(|x| x * x).sum::<f64>().sqrt()).collect();
        // Bounds are brought to the size of 1, so that f weighs as much as the rows do.
        let size = bounds.iter().zip(&scale).map(|(b, s)| (b / s).abs()).fold(f64::MIN_POSITIVE, f64::max);
        let e = DMatrix::from_fn(
            n + 1,
            m,
            |i, j| {
                if i < n { -rows[j][i] / scale[j] } else { -bounds[j] / (scale[j] * size) }
            },
        );
        let f = DVector::from_fn(n + 1, |i, _| f64::from(u8::from(i == n)));
        let y = non_negative_least_squares(&e, &f)?;
        let residual = &e * y - f;
        // A residual that vanishes to rounding of the unit right-hand side: no common point.
        if residual.norm() < 1e-10 {
            return None;
        }
        Some((0..n).map(|i| -size * residual[i] / residual[n]).collect())
    }
}

/// `min ‖E y - f‖` over `y >= 0`. Each outer round adds one variable; a set is never repeated, since the residual falls.
fn non_negative_least_squares(e: &DMatrix<f64>, f: &DVector<f64>) -> Option<DVector<f64>> {
    let m = e.ncols();
    let mut passive = vec![false; m];
    let mut y = DVector::zeros(m);
    // Columns that depend on the passive ones: their gain is rounding.
    let mut refused = vec![false; m];
    for _ in 0..6 * m + 10 {
        let gain = e.transpose() * (f - e * &y);
        let entering = (0..m)
            .filter(|&j| !passive[j] && !refused[j] && gain[j] > 1e-14)
            .max_by(|&i, &j| gain[i].total_cmp(&gain[j]));
        let Some(entering) = entering else { return Some(y) };
        passive[entering] = true;
        let Some(mut s) = least_squares(e, f, &passive).filter(|s| s[entering] > 0.0) else {
            (passive[entering], refused[entering]) = (false, true);
            continue;
        };
        refused.fill(false);
        loop {
            if (0..m).all(|j| !passive[j] || s[j] > 0.0) {
                y = s;
                break;
            }
            let stop = (0..m)
                .filter(|&j| passive[j] && s[j] <= 0.0)
                .map(|j| y[j] / (y[j] - s[j]))
                .fold(f64::INFINITY, f64::min);
            y += stop * (s - &y);
            for j in 0..m {
                if passive[j] && y[j] <= 1e-15 {
                    (passive[j], y[j]) = (false, 0.0);
                }
            }
            s = least_squares(e, f, &passive)?;
        }
    }
    None
}

fn least_squares(e: &DMatrix<f64>, f: &DVector<f64>, passive: &[bool]) -> Option<DVector<f64>> {
    let members: Vec<usize> = (0..passive.len()).filter(|&j| passive[j]).collect();
    let mut s = DVector::zeros(passive.len());
    if members.is_empty() {
        return Some(s);
    }
    let part = e.select_columns(&members);
    let solution = (part.transpose() * &part).cholesky()?.solve(&(part.transpose() * f));
    for (k, &j) in members.iter().enumerate() {
        s[j] = solution[k];
    }
    Some(s)
}
