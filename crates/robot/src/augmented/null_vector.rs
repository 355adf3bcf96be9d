use nalgebra::{SMatrix, SVector};

/// A vector of the augmented joint space: `N` joints and the path parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NullVector<const N: usize> {
    /// The joints' part, `n`.
    pub joints: SVector<f64, N>,
    /// The path parameter's part, `det J`.
    pub path: f64,
}

impl<const N: usize> NullVector<N> {
    /// The vector times a number.
    #[must_use]
    pub fn scaled(&self, by: f64) -> Self {
        Self { joints: self.joints * by, path: self.path * by }
    }

    /// Euclidean norm of all `N + 1` entries, `‖n̄‖`: speed of the arc length at unit `b`.
    #[must_use]
    pub fn norm(&self) -> f64 {
        self.joints.norm().hypot(self.path)
    }
}

/// Null vector `n̄ = [adj(J) t; det J]` of `[J, -t]`, the cofactors of its columns.
///
/// No determinant of a minor is formed. With `[J, -t]ᵀ = Q R` (Householder) the cofactors are
///
/// ```text
/// n̄ = det(Q) (Π R_kk) · last column of Q
/// ```
///
/// because `det [J̄; wᵀ] = n̄ᵀw` for every `w`. The last column of `Q` is a unit vector of the kernel up to some `N`
/// roundings whatever the rank, so `‖J̄ n̄‖` is that small beside `‖J̄‖ ‖n̄‖`, singular configurations included, and the
/// product is a determinant with the error of a backward stable one. The sign is that of the cofactors, hence continuous
/// along every path. NaN in, NaN out. Entries whose squares or whose products over the rows overflow are not provided for.
///
/// Claim `null-vector`.
#[must_use]
pub fn null_vector<const N: usize>(jacobian: &SMatrix<f64, N, N>, tangent: &SVector<f64, N>) -> NullVector<N> {
    // The transpose in two parts, as the language has no N + 1: Jᵀ above, -tᵀ below. Reflectors replace the columns.
    // [N] eq 3: the matrix whose kernel is looked for.
    let mut upper = jacobian.transpose();
    let mut lower = -*tangent;
    let mut weights = [0.0; N];
    let mut size = 1.0;
    for k in 0..N {
        let norm = upper.view((k, k), (N - k, 1)).norm().hypot(lower[k]);
        let first = upper[(k, k)];
        // H x = -sign(x₁) ‖x‖ e₁ and det H = -1: together a factor sign(x₁) ‖x‖.
        size *= norm.copysign(first);
        if norm == 0.0 {
            continue;
        }
        let length = norm * (norm + first.abs());
        upper[(k, k)] = first + norm.copysign(first);
        weights[k] = 1.0 / length;
        for j in k + 1..N {
            reflect(&mut upper, &mut lower, k, j, weights[k]);
        }
    }
    let mut joints = SVector::zeros();
    let mut path = 1.0;
    for k in (0..N).rev() {
        let along: f64 = (k..N).map(|i| upper[(i, k)] * joints[i]).sum::<f64>() + lower[k] * path;
        let share = weights[k] * along;
        for i in k..N {
            joints[i] -= share * upper[(i, k)];
        }
        path -= share * lower[k];
    }
    // [N] eq 5, with the sign of [N] eq 6.
    NullVector { joints, path }.scaled(size)
}

/// Applies the reflector in column `k` to column `j`.
fn reflect<const N: usize>(
    upper: &mut SMatrix<f64, N, N>,
    lower: &mut SVector<f64, N>,
    k: usize,
    j: usize,
    weight: f64,
) {
    let along: f64 = (k..N).map(|i| upper[(i, k)] * upper[(i, j)]).sum::<f64>() + lower[k] * lower[j];
    let share = weight * along;
    for i in k..N {
        upper[(i, j)] -= share * upper[(i, k)];
    }
    lower[j] -= share * lower[k];
}

/// Derivative of [`null_vector`] when `J` and `t` change at the given rates.
///
/// Cofactors are linear in every row of `J̄`: the derivative is the sum over the rows of the null vector with that row
/// replaced by its rate. It exists at every rank, where differentiating `det(J) J⁻¹` would divide by zero.
#[must_use]
pub fn null_vector_rate<const N: usize>(
    jacobian: &SMatrix<f64, N, N>,
    tangent: &SVector<f64, N>,
    jacobian_rate: &SMatrix<f64, N, N>,
    tangent_rate: &SVector<f64, N>,
) -> NullVector<N> {
    let mut sum = NullVector { joints: SVector::zeros(), path: 0.0 };
    for row in 0..N {
        let (mut matrix, mut right) = (*jacobian, *tangent);
        matrix.set_row(row, &jacobian_rate.row(row));
        right[row] = tangent_rate[row];
        let term = null_vector(&matrix, &right);
        sum.joints += term.joints;
        sum.path += term.path;
    }
    sum
}
