//! Factor of the interior point's matrix: a chain of 3×3 blocks, neighbours overlapping in one entry.
//!
//! `M = sum over cells of sum_i q_i a_i a_iᵀ` with `q_i > 0` and every `a_i` in the three unknowns of its cell. Elimination goes along the chain: the two
//! first unknowns of a cell are eliminated and one number is carried to the next cell.
//!
//! Plain elimination subtracts: where one row dominates, two numbers of its size cancel down to what the cells before left, and a pivot may come
//! out as 0 or negative. The fallback of [`super::givens`] adds positive numbers only.

use super::givens;

/// Positive multiples of `a aᵀ` that make up a cell's block.
pub(crate) type Terms<'t> = (&'t [f64], &'t [[f64; 3]]);

/// `M = Bᵀ D B` with unit upper triangular `B`: per cell its entries `(0,1), (0,2), (1,2)` and two pivots; and the last pivot.
#[derive(Clone, Debug, Default)]
pub(crate) struct ChainFactor {
    pub(crate) upper: Vec<[f64; 3]>,
    pub(crate) pivots: Vec<[f64; 2]>,
    pub(crate) last: f64,
}

impl ChainFactor {
    /// Factor from the terms of each cell; `terms(k)` gives two lists. `None` only where numbers overflow or all terms vanish.
    pub(crate) fn new<'t>(cells: usize, terms: impl Fn(usize) -> [Terms<'t>; 2]) -> Option<Self> {
        let mut factor = Self { upper: vec![[0.0; 3]; cells], pivots: vec![[0.0; 2]; cells], last: 0.0 };
        if !factor.eliminate(&terms) {
            givens::rotate(&mut factor, &terms);
        }
        let positive = |p: &f64| *p > 0.0 && p.is_finite();
        (factor.pivots.iter().flatten().all(positive) && positive(&factor.last)).then_some(factor)
    }

    /// Plain elimination; false if a pivot is not positive.
    fn eliminate<'t>(&mut self, terms: &impl Fn(usize) -> [Terms<'t>; 2]) -> bool {
        let mut carried = 0.0;
        for k in 0..self.upper.len() {
            let mut m = [carried, 0.0, 0.0, 0.0, 0.0, 0.0];
            for (weights, forms) in terms(k) {
                for (q, a) in weights.iter().zip(forms) {
                    let (q0, q1) = (q * a[0], q * a[1]);
                    m[0] += q0 * a[0];
                    m[1] += q0 * a[1];
                    m[2] += q0 * a[2];
                    m[3] += q1 * a[1];
                    m[4] += q1 * a[2];
                    m[5] += q * a[2] * a[2];
                }
            }
            let (l01, l02) = (m[1] / m[0], m[2] / m[0]);
            let (m11, m12) = (m[3] - l01 * m[1], m[4] - l01 * m[2]);
            let l12 = m12 / m11;
            carried = m[5] - l02 * m[2] - l12 * m12;
            if !(m[0] > 0.0 && m11 > 0.0 && carried > 0.0) {
                return false;
            }
            (self.upper[k], self.pivots[k]) = ([l01, l02, l12], [m[0], m11]);
        }
        self.last = carried;
        true
    }

    /// Solves `M x = r` in place.
    pub(crate) fn solve(&self, r: &mut [f64]) {
        for (k, b) in self.upper.iter().enumerate() {
            let r = &mut r[2 * k..2 * k + 3];
            r[1] -= b[0] * r[0];
            r[2] -= b[1] * r[0] + b[2] * r[1];
        }
        r[2 * self.upper.len()] /= self.last;
        for (k, (b, d)) in self.upper.iter().zip(&self.pivots).enumerate().rev() {
            let r = &mut r[2 * k..2 * k + 3];
            r[1] = r[1] / d[1] - b[2] * r[2];
            r[0] = r[0] / d[0] - b[0] * r[1] - b[1] * r[2];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};

    /// Weights and forms of random cells.
    fn random(cells: usize, seed: u64, spread: f64) -> (Vec<Vec<f64>>, Vec<Vec<[f64; 3]>>) {
        let mut state = seed;
        let mut number = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        let weights = (0..cells).map(|_| (0..5).map(|_| (spread * number()).exp()).collect()).collect();
        let forms = (0..cells).map(|_| (0..5).map(|_| [number(), number(), number()]).collect()).collect();
        (weights, forms)
    }

    fn residual(by_givens: bool, spread: f64) -> f64 {
        let cells = 40;
        let (weights, forms) = random(cells, 3, spread);
        let terms = |k: usize| [(&weights[k][..2], &forms[k][..2]), (&weights[k][2..], &forms[k][2..])];
        let mut dense = DMatrix::zeros(2 * cells + 1, 2 * cells + 1);
        for k in 0..cells {
            for (q, a) in weights[k].iter().zip(&forms[k]) {
                for i in 0..3 {
                    for j in 0..3 {
                        dense[(2 * k + i, 2 * k + j)] += q * a[i] * a[j];
                    }
                }
            }
        }
        let right = DVector::from_fn(2 * cells + 1, |i, _| (i as f64).sin());
        let reference = dense.clone().cholesky().expect("positive definite").solve(&right);
        let factor = if by_givens {
            let mut factor = ChainFactor { upper: vec![[0.0; 3]; cells], pivots: vec![[0.0; 2]; cells], last: 0.0 };
            givens::rotate(&mut factor, &terms);
            factor
        } else {
            ChainFactor::new(cells, terms).expect("positive")
        };
        let mut x: Vec<f64> = right.iter().copied().collect();
        factor.solve(&mut x);
        let solution = DVector::from_vec(x);
        (solution - &reference).amax() / reference.amax()
    }

    #[test]
    fn elimination_and_rotations_solve_as_a_dense_factor_does() {
        assert!(residual(false, 2.0) < 1e-9, "{}", residual(false, 2.0));
        assert!(residual(true, 2.0) < 1e-9, "{}", residual(true, 2.0));
    }

    #[test]
    fn where_elimination_loses_a_pivot_rotations_keep_it() {
        // One huge term a cell over tiny ones: what is left of the cell before is far below the rounding of the huge one.
        let weights = vec![[1e-9, 1e-9, 1e-9, 1e14]; 30];
        let forms = vec![[[1.0, 0.0, 0.0], [0.25, 0.5, 0.25], [0.0, 0.0, 1.0], [0.7, -1.1, 0.3]]; 30];
        let terms = |k: usize| [(&weights[k][..], &forms[k][..]), (&[][..], &[][..])];
        let mut plain = ChainFactor { upper: vec![[0.0; 3]; 30], pivots: vec![[0.0; 2]; 30], last: 0.0 };
        assert!(!plain.eliminate(&terms), "the case is not hard enough");
        assert!(ChainFactor::new(30, terms).is_some());
    }
}
