use crate::{JacobiSvd, Jacobian, JointVector, RobotError, Twist};
use nalgebra::{Matrix6, Vector6};

/// Which coordinates of the tool the task prescribes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// Position and orientation, six coordinates.
    Pose,
    /// Position only, three coordinates.
    Position,
    /// Position in the base frame's x-y plane, two coordinates: planar arms.
    PlanarPosition,
    /// Position in the x-y plane and the turn about z, three coordinates.
    PlanarPose,
}

impl Task {
    /// The twist coordinates that the task prescribes, as rows of the geometric Jacobian.
    #[must_use]
    pub fn rows(self) -> &'static [usize] {
        match self {
            Self::Pose => &[0, 1, 2, 3, 4, 5],
            Self::Position => &[0, 1, 2],
            Self::PlanarPosition => &[0, 1],
            Self::PlanarPose => &[0, 1, 5],
        }
    }

    /// A twist with the coordinates outside the task set to zero.
    #[must_use]
    pub fn select(self, twist: &Twist) -> Twist {
        let mut selected = Twist::zeros();
        for &row in self.rows() {
            selected[row] = twist[row];
        }
        selected
    }

    /// A Jacobian with the rows outside the task set to zero.
    #[must_use]
    pub fn select_rows<const N: usize>(self, jacobian: &Jacobian<N>) -> Jacobian<N> {
        let mut selected = Jacobian::<N>::zeros();
        for &row in self.rows() {
            selected.set_row(row, &jacobian.row(row));
        }
        selected
    }
}

/// Method that turns a tool twist into joint speeds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum InverseMethod {
    /// `adj(J) sign(det J) / max(|det J|, epsilon)`, `[G11] eq 24`: keeps the direction of motion at a singularity.
    Adjugate {
        /// Smallest determinant divided by. Its unit is that of the determinant (m³ for a six-axis pose task).
        epsilon: f64,
    },
    /// `Jᵀ (J Jᵀ + λ² I)⁻¹`.
    DampedLeastSquares {
        /// Damping `λ`, in the unit of the singular values.
        damping: f64,
    },
    /// Pseudo-inverse from the singular values above a cutoff.
    TruncatedSvd {
        /// Singular values at most this large are left out.
        cutoff: f64,
    },
}

impl InverseMethod {
    /// Checks the parameter, and that the method fits an arm with `joints` joints and a `task`.
    ///
    /// # Errors
    ///
    /// A parameter that is not positive and finite; the adjugate for a Jacobian that is not square.
    pub fn validate(&self, task: Task, joints: usize) -> Result<(), RobotError> {
        let (name, value) = match *self {
            Self::Adjugate { epsilon } => ("epsilon", epsilon),
            Self::DampedLeastSquares { damping } => ("damping", damping),
            Self::TruncatedSvd { cutoff } => ("cutoff", cutoff),
        };
        if !(value > 0.0 && value.is_finite()) {
            return Err(RobotError::NotPositive { name, value });
        }
        let rows = task.rows().len();
        if matches!(self, Self::Adjugate { .. }) && rows != joints {
            return Err(RobotError::NotSquare { rows, joints });
        }
        Ok(())
    }
}

/// Joint speeds for a tool twist: `q̇ = Inv(J) twist`, restricted to the task's rows.
///
/// For a redundant arm the damped and truncated inverses give the speeds of least norm: the null-space motion is zero.
/// [`InverseMethod::Adjugate`] is only meaningful where [`InverseMethod::validate`] accepts it.
#[must_use]
pub fn solve_rates<const N: usize>(
    method: InverseMethod,
    task: Task,
    jacobian: &Jacobian<N>,
    twist: &Twist,
) -> JointVector<N> {
    // [G11] eq 5, with an inverse that exists everywhere.
    let rows = task.select_rows(jacobian);
    let twist = task.select(twist);
    match method {
        InverseMethod::Adjugate { epsilon } => adjugate_solve(&rows, task, &twist, epsilon),
        InverseMethod::DampedLeastSquares { damping } => {
            let gram = rows * rows.transpose() + Matrix6::from_diagonal_element(damping * damping);
            // J Jᵀ + λ² I is positive definite for every finite J; if it is not finite, neither is the answer.
            gram.cholesky().map_or_else(|| JointVector::from_element(f64::NAN), |c| rows.transpose() * c.solve(&twist))
        }
        InverseMethod::TruncatedSvd { cutoff } => truncated_solve(&rows, &twist, cutoff),
    }
}

/// The task's square block, bordered with an identity to a full 6×6 matrix. Bordering changes neither the determinant
/// nor the block of the adjugate that matters.
fn bordered<const N: usize>(rows: &Jacobian<N>, task: Task) -> Matrix6<f64> {
    let mut square = Matrix6::identity();
    for (i, &row) in task.rows().iter().enumerate() {
        for j in 0..N.min(6) {
            square[(i, j)] = rows[(row, j)];
        }
    }
    square
}

fn adjugate_solve<const N: usize>(rows: &Jacobian<N>, task: Task, twist: &Twist, epsilon: f64) -> JointVector<N> {
    let square = bordered(rows, task);
    let mut packed = Vector6::zeros();
    for (i, &row) in task.rows().iter().enumerate() {
        packed[i] = twist[row];
    }
    let lu = square.lu();
    let determinant = lu.determinant();
    let solution = if determinant.abs() > epsilon {
        lu.solve(&packed)
    } else {
        let sign = if determinant < 0.0 { -1.0 } else { 1.0 };
        // [G11] eq 24
        Some(adjugate(&square) * packed * (sign / epsilon))
    };
    // No solution means a NaN in the Jacobian: passed on, so that whoever commands joints brakes.
    solution.map_or_else(
        || JointVector::from_element(f64::NAN),
        |s| JointVector::from_fn(|i, _| if i < 6 { s[i] } else { 0.0 }),
    )
}

/// Adjugate (transposed cofactor matrix), `adj(J) J = det(J) I`: well defined for every rank, where `det(J) J⁻¹` is not.
#[must_use]
pub fn adjugate(matrix: &Matrix6<f64>) -> Matrix6<f64> {
    Matrix6::from_fn(|i, j| {
        let minor = matrix.remove_fixed_rows::<1>(j).remove_fixed_columns::<1>(i);
        let sign = if (i + j) % 2 == 0 { 1.0 } else { -1.0 };
        sign * minor.lu().determinant()
    })
}

fn truncated_solve<const N: usize>(rows: &Jacobian<N>, twist: &Twist, cutoff: f64) -> JointVector<N> {
    JacobiSvd::new(rows).map_or_else(|| JointVector::from_element(f64::NAN), |svd| svd.solve(twist, cutoff))
}
