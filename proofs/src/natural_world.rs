//! Random Jacobians for the claims about natural motion.

use nalgebra::{SMatrix, SVector};
use slideway_robot::augmented::NullVector;

use crate::engine::Choices;

/// A Jacobian and a path's twist.
#[derive(Clone, Copy, Debug)]
pub struct System<const N: usize> {
    /// `J`.
    pub jacobian: SMatrix<f64, N, N>,
    /// `t*`.
    pub tangent: SVector<f64, N>,
}

impl<const N: usize> System<N> {
    /// Product of the lengths of the rows of `[J, -t]`: no minor is larger (Hadamard).
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.jacobian.row_iter().zip(self.tangent.iter()).map(|(row, t)| row.norm().hypot(*t)).product()
    }

    /// Norm of `J n - t q̇*` at `n̄`, zero but for rounding, and the size of the terms that cancel in it.
    #[must_use]
    pub fn residual(&self, null: &NullVector<N>) -> [f64; 2] {
        let left = self.jacobian * null.joints - self.tangent * null.path;
        [left.norm(), self.jacobian.norm().hypot(self.tangent.norm()) * null.norm()]
    }
}

impl<const N: usize> System<N> {
    /// Entries in [-1, 1], rows of length `10^scale` times that.
    pub fn draw(choices: &mut Choices) -> Self {
        let scales: [f64; N] = std::array::from_fn(|_| choices.decade(-3.0, 3.0));
        Self {
            jacobian: SMatrix::from_fn(|i, _| choices.between(-1.0, 1.0) * scales[i]),
            tangent: SVector::from_fn(|i, _| choices.between(-1.0, 1.0) * scales[i]),
        }
    }

    /// As [`System::draw`], the last column a combination of the others plus so much of its own.
    pub fn spoilt(choices: &mut Choices, own: f64) -> Self {
        let mut system = Self::draw(choices);
        let last = N - 1;
        let mut column = system.jacobian.column(last) * own;
        for j in 0..last {
            column += system.jacobian.column(j) * choices.between(-1.0, 1.0);
        }
        system.jacobian.set_column(last, &column);
        system
    }
}
