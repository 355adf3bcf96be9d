use nalgebra::{SMatrix, SVector};

/// Singular value decomposition of a Jacobian by one-sided Jacobi rotations.
///
/// Rotates the columns of `J V` until they are orthogonal; they are then `σ_k u_k`. High relative accuracy, no
/// allocation, any rank. (nalgebra's `svd` was tried first: on random 6×6 matrices about one in 50,000 came back with
/// factors whose product misses the matrix in the second digit.)
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JacobiSvd<const N: usize, const ROWS: usize = 6> {
    /// Columns `σ_k u_k`, mutually orthogonal, in no particular order.
    pub scaled: SMatrix<f64, ROWS, N>,
    /// Orthogonal matrix `V` with columns `v_k`.
    pub v: SMatrix<f64, N, N>,
}

/// Cosine between two columns below which they count as orthogonal: a few roundings of a product of six terms.
const ORTHOGONAL: f64 = 1e-15;

/// Convergence is quadratic; ten sweeps are ample for seven columns, the rest guards against rounding cycles.
const MAX_SWEEPS: usize = 40;

impl<const N: usize, const ROWS: usize> JacobiSvd<N, ROWS> {
    /// Decomposes a Jacobian (six rows) or any other small matrix. `None` if an entry is not finite.
    #[must_use]
    pub fn new(jacobian: &SMatrix<f64, ROWS, N>) -> Option<Self> {
        if !jacobian.iter().all(|x| x.is_finite()) {
            return None;
        }
        let mut svd = Self { scaled: *jacobian, v: SMatrix::identity() };
        for _ in 0..MAX_SWEEPS {
            let mut rotated = false;
            for p in 0..N {
                for q in p + 1..N {
                    rotated |= svd.orthogonalise(p, q);
                }
            }
            if !rotated {
                break;
            }
        }
        Some(svd)
    }

    /// Singular value `k`, in the order of the columns.
    #[must_use]
    pub fn singular_value(&self, k: usize) -> f64 {
        self.scaled.column(k).norm()
    }

    /// `J⁺ b` from the singular values above `cutoff`: `Σ v_k (u_k · b) / σ_k`, the least-norm least-squares solution.
    #[must_use]
    pub fn solve(&self, b: &SVector<f64, ROWS>, cutoff: f64) -> SVector<f64, N> {
        let mut x = SVector::<f64, N>::zeros();
        for k in 0..N {
            let sigma = self.singular_value(k);
            if sigma > cutoff {
                // v (u·b) / σ, with the column holding σ u.
                x += self.v.column(k) * (self.scaled.column(k).dot(b) / (sigma * sigma));
            }
        }
        x
    }

    /// Rotates columns `p` and `q` to be orthogonal; whether there was anything to do.
    fn orthogonalise(&mut self, p: usize, q: usize) -> bool {
        let (cp, cq) = (self.scaled.column(p), self.scaled.column(q));
        let (alpha, beta, gamma) = (cp.norm_squared(), cq.norm_squared(), cp.dot(&cq));
        if gamma == 0.0 || gamma.abs() <= ORTHOGONAL * (alpha * beta).sqrt() {
            return false;
        }
        // The smaller root of t² + 2ζt - 1 = 0 is the tangent of the rotation.
        let zeta = (beta - alpha) / (2.0 * gamma);
        let t = zeta.signum() / (zeta.abs() + zeta.hypot(1.0));
        let c = 1.0 / t.hypot(1.0);
        let s = c * t;
        for i in 0..ROWS {
            let (x, y) = (self.scaled[(i, p)], self.scaled[(i, q)]);
            (self.scaled[(i, p)], self.scaled[(i, q)]) = (c * x - s * y, s * x + c * y);
        }
        for i in 0..N {
            let (x, y) = (self.v[(i, p)], self.v[(i, q)]);
            (self.v[(i, p)], self.v[(i, q)]) = (c * x - s * y, s * x + c * y);
        }
        true
    }
}
