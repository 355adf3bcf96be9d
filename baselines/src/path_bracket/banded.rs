//! Cholesky's factor of a symmetric banded matrix.

/// Symmetric matrix with `BAND` diagonals, the main one included: `rows[i][d]` is the entry `(i, i - d)`.
#[derive(Clone, Debug)]
pub(crate) struct Banded<const BAND: usize> {
    pub(crate) rows: Vec<[f64; BAND]>,
}

impl<const BAND: usize> Banded<BAND> {
    /// Zero of a size.
    pub(crate) fn new(size: usize) -> Self {
        Self { rows: vec![[0.0; BAND]; size] }
    }

    /// The factor in place of the matrix, with the inverse of its diagonal stored; false if a pivot is not positive.
    pub(crate) fn factorise(&mut self) -> bool {
        for i in 0..self.rows.len() {
            let (before, rest) = self.rows.split_at_mut(i);
            let row = &mut rest[0];
            for d in (1..BAND.min(i + 1)).rev() {
                let other = &before[i - d];
                // Columns left of i - d that both rows hold: of this row the diagonals d + e, of the other e.
                let mut sum = row[d];
                for e in 1..BAND - d {
                    sum -= row[d + e] * other[e];
                }
                row[d] = sum * other[0];
            }
            let mut pivot = row[0];
            for entry in &row[1..] {
                pivot -= entry * entry;
            }
            if !(pivot > 0.0) {
                return false;
            }
            row[0] = 1.0 / pivot.sqrt();
        }
        true
    }

    /// Solves in place with the factor.
    pub(crate) fn solve(&self, r: &mut [f64]) {
        let size = self.rows.len();
        for i in 0..size {
            let mut sum = r[i];
            for d in 1..BAND.min(i + 1) {
                sum -= self.rows[i][d] * r[i - d];
            }
            r[i] = sum * self.rows[i][0];
        }
        for i in (0..size).rev() {
            let value = r[i] * self.rows[i][0];
            r[i] = value;
            for d in 1..BAND.min(i + 1) {
                r[i - d] -= self.rows[i][d] * value;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};

    #[test]
    fn the_banded_factor_solves_as_a_dense_one_does() {
        let size = 37;
        let mut banded = Banded::<6>::new(size);
        let mut dense = DMatrix::zeros(size, size);
        for i in 0..size {
            for d in 0..6.min(i + 1) {
                let entry = if d == 0 { 8.0 } else { ((7 * i + 3 * d) as f64).sin() };
                banded.rows[i][d] = entry;
                dense[(i, i - d)] = entry;
                dense[(i - d, i)] = entry;
            }
        }
        let right = DVector::from_fn(size, |i, _| (i as f64).cos());
        let reference = dense.cholesky().expect("positive definite").solve(&right);
        let mut x: Vec<f64> = right.iter().copied().collect();
        assert!(banded.factorise());
        banded.solve(&mut x);
        for (x, y) in x.iter().zip(reference.iter()) {
            assert!((x - y).abs() < 1e-13);
        }
    }

    #[test]
    fn a_matrix_that_is_not_positive_definite_is_refused() {
        let mut banded = Banded::<2> { rows: vec![[1.0, 0.0], [1.0, 2.0]] };
        assert!(!banded.factorise());
    }
}
