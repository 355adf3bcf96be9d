//! Matrices and one-joint arms for the claims about natural motion.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use proptest::prelude::{BoxedStrategy, Just, Strategy, prop_oneof};
use slideway_robot::augmented::{Flow, NullVector};
use slideway_robot::{DhRow, Dynamics, LinkInertia, SerialArm};

use crate::support::joints;

/// A Jacobian and a path's twist.
#[derive(Clone, Copy, Debug)]
pub(crate) struct System<const N: usize> {
    pub(crate) jacobian: SMatrix<f64, N, N>,
    pub(crate) tangent: SVector<f64, N>,
}

impl<const N: usize> System<N> {
    /// Product of the lengths of the rows of `[J, -t]`: no minor is larger (Hadamard).
    pub(crate) fn volume(&self) -> f64 {
        self.jacobian.row_iter().zip(self.tangent.iter()).map(|(row, t)| row.norm().hypot(*t)).product()
    }

    /// What `n̄` leaves of `J n - t q̇*`, and the size of what cancels.
    pub(crate) fn residual(&self, null: &NullVector<N>) -> [f64; 2] {
        let left = self.jacobian * null.joints - self.tangent * null.path;
        [left.norm(), self.jacobian.norm().hypot(self.tangent.norm()) * null.norm()]
    }
}

/// Entries in [-1, 1], rows of length `10^scale` times that.
pub(crate) fn regular<const N: usize>() -> BoxedStrategy<System<N>> {
    let rows = proptest::collection::vec(joints::<N>(-1.0..1.0), N);
    (rows, joints::<N>(-1.0..1.0), joints::<N>(-3.0..3.0))
        .prop_map(|(rows, tangent, scales)| {
            let scale = |i: usize| 10f64.powf(scales[i]);
            System {
                jacobian: SMatrix::from_fn(|i, j| rows[i][j] * scale(i)),
                tangent: SVector::from_fn(|i, _| tangent[i] * scale(i)),
            }
        })
        .boxed()
}

/// As [`regular`], the last column a combination of the others plus so much of its own.
pub(crate) fn spoilt<const N: usize>(own: impl Strategy<Value = f64> + 'static) -> BoxedStrategy<System<N>> {
    (regular::<N>(), joints::<N>(-1.0..1.0), own)
        .prop_map(|(mut system, shares, own)| {
            let last = N - 1;
            let mut column = system.jacobian.column(last) * own;
            for (j, share) in shares.iter().enumerate().take(last) {
                column += system.jacobian.column(j) * *share;
            }
            system.jacobian.set_column(last, &column);
            system
        })
        .boxed()
}

/// Regular, nearly singular and singular to rounding.
pub(crate) fn any_rank<const N: usize>() -> BoxedStrategy<System<N>> {
    let own = prop_oneof![Just(0.0), (-17.0..0.0).prop_map(|exponent: f64| 10f64.powf(exponent))];
    prop_oneof![regular(), spoilt(own)].boxed()
}

/// A point mass of 1 kg on a rod of 1 m, level at `q = 0`, under `gravity` m/s²: mass matrix 1, weight `gravity`.
pub(crate) fn pendulum(gravity: f64) -> Result<Dynamics<1>, Box<dyn std::error::Error>> {
    let arm = SerialArm::from_dh([DhRow { a: 1.0, alpha: 0.0, d: 0.0, offset: 0.0 }])?;
    let link = LinkInertia { mass: 1.0, com: Vector3::x(), inertia: Matrix3::zeros() };
    Ok(Dynamics::new(arm, [link])?.with_gravity(Vector3::new(0.0, -gravity, 0.0)))
}

/// A flow of one joint with null vector `n` and derivative `a`.
pub(crate) fn one_joint(n: f64, a: f64) -> Flow<1> {
    let entry = |x: f64| NullVector { joints: SVector::<f64, 1>::new(x), path: 0.0 };
    Flow { direction: entry(n), slope: entry(a) }
}
