use super::NullVector;
use crate::{JacobiSvd, Jacobian, JointVector, RobotError, Task, Twist};
use nalgebra::SMatrix;

/// Weights `w_i > 0` of the joints: the length of a joint motion is `sqrt(Σ w_i δq_i²)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointMetric<const N: usize> {
    /// `1 / sqrt(w_i)`.
    shrink: JointVector<N>,
}

impl<const N: usize> JointMetric<N> {
    /// A diagonal metric.
    ///
    /// # Errors
    ///
    /// A weight that is not positive and finite.
    pub fn new(weights: &JointVector<N>) -> Result<Self, RobotError> {
        match weights.iter().find(|w| !(**w > 0.0 && w.is_finite())) {
            Some(&value) => Err(RobotError::NotPositive { name: "joint weight", value }),
            None => Ok(Self { shrink: weights.map(|w| 1.0 / w.sqrt()) }),
        }
    }

    /// Every weight 1.
    #[must_use]
    pub fn euclidean() -> Self {
        Self { shrink: JointVector::from_element(1.0) }
    }
}

/// The extension to arms with at least as many joints as task coordinates, a choice of this project: `[N]` leaves it open.
///
/// ```text
/// n  = s W⁻¹ Jᵀ (J W⁻¹ Jᵀ)⁻¹ t*,   s = sqrt(det(J W⁻¹ Jᵀ))        J n = s t*
/// ```
///
/// Of all joint speeds that follow the path at `q̇* = b s`, `b n` is the shortest in the metric `W`. In the singular values
/// `σ` of `J W^(-1/2)`, `s` is their product and the coefficient along each of them the product of the others, which is
/// finite. For a square `J` it is `n̄` with the sign of `det J` taken off, whatever the metric up to the factor
/// `sqrt(det W⁻¹)`.
///
/// The price: `s` has no sign and a kink at a singularity, where the direction out of it is not unique (it may be any
/// self-motion). Exactly there that component is zero and the arm stands, so it does not pass through as a square one does.
/// NaN if the arm has fewer joints than the task has coordinates, or an entry is not finite.
#[must_use]
pub fn redundant_null_vector<const N: usize>(
    task: Task,
    jacobian: &Jacobian<N>,
    twist: &Twist,
    metric: &JointMetric<N>,
) -> NullVector<N> {
    let nowhere = NullVector { joints: JointVector::from_element(f64::NAN), path: f64::NAN };
    let rows = task.rows();
    let mut scaled = SMatrix::<f64, N, 6>::zeros();
    for &row in rows {
        for j in 0..N {
            scaled[(j, row)] = jacobian[(row, j)] * metric.shrink[j];
        }
    }
    // Of the transpose: `v` holds the left singular vectors, complete at every rank.
    let Some(svd) = JacobiSvd::new(&scaled).filter(|_| N >= rows.len() && twist.iter().all(|x| x.is_finite())) else {
        return nowhere;
    };
    // Rows outside the task are zero columns, which no rotation touches: the task's own singular values stay in its rows.
    let product_without = |left_out: Option<usize>| -> f64 {
        rows.iter().filter(|&&k| Some(k) != left_out).map(|&k| svd.singular_value(k)).product()
    };
    let mut joints = JointVector::<N>::zeros();
    for &k in rows {
        let sigma = svd.singular_value(k);
        if sigma > 0.0 {
            let along = svd.v.column(k).dot(twist);
            joints += svd.scaled.column(k) * (product_without(Some(k)) * along / sigma);
        }
    }
    NullVector { joints: joints.component_mul(&metric.shrink), path: product_without(None) }
}
