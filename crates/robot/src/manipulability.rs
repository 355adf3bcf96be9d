use crate::{JacobiSvd, Jacobian, Task};

/// Manipulability `sqrt(det(J Jᵀ))` on the task's rows (Yoshikawa 1985), with fewer joints than rows `sqrt(det(Jᵀ J))`: the
/// product of the singular values, zero at a singularity. NaN if the Jacobian is not finite.
///
/// Its unit follows from the task's; for a square Jacobian it is `|det J|`. A product of singular values keeps the digits
/// that squaring the Jacobian would lose.
#[must_use]
pub fn manipulability<const N: usize>(task: Task, jacobian: &Jacobian<N>) -> f64 {
    let Some(svd) = JacobiSvd::new(&task.select_rows(jacobian)) else { return f64::NAN };
    let mut values: Vec<f64> = (0..N).map(|k| svd.singular_value(k)).collect();
    values.sort_by(|a, b| b.total_cmp(a));
    values[..task.rows().len().min(N)].iter().product()
}
