use super::super::limit::TorqueLimits;
use crate::MotionError;
use crate::error::{not_negative, positive};
use nalgebra::SMatrix;
use slideway_robot::{Dynamics, JacobiSvd, Jacobian, JointVector, RobotError, Task, Twist};

/// Settings of an [`OperationalSpace`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OperationalSettings {
    /// Length by which angular accelerations are multiplied to be compared with linear ones, m.
    pub length: f64,
    /// Largest effective inertia of the tool that is used, kg.
    pub largest_inertia: f64,
    /// Damping of motion that the tool does not feel, 1/s.
    pub posture_damping: f64,
}

/// Torques of one sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OperationalOutput<const N: usize> {
    /// Torques, inside the limits, N·m or N.
    pub torque: JointVector<N>,
    /// Joints whose torque was cut.
    pub cut: [bool; N],
    /// Acceleration of the tool asked for less the one it will have, by the model and before torques are cut, m/s² and rad/s².
    pub shortfall: Twist,
}

/// Torques that give the tool an acceleration: second-order control in operational space, `[R16]`.
///
/// ```text
/// τ = M q̈ + c + g - Jᵀ f_ext,   q̈ = M⁻¹ Jᵀ Λ (ẍ - J̇ q̇) - (I - M⁻¹ Jᵀ Λ J) k q̇
/// Λ = (J M⁻¹ Jᵀ)⁻¹ with its eigenvalues cut at `largest_inertia`
/// ```
///
/// so that `ẍ = J q̈ + J̇ q̇` (`[R16]`'s parenthesis closed). `f_ext`, the measured wrench on the tool, is cancelled if it is given.
///
/// Near a singularity `Λ` grows without bound. With the eigenvalues `σ_k²` (1/kg) of `J M⁻¹ Jᵀ`, angular rows times `length`, and
/// `m` the largest inertia, the acceleration along the eigenvector of `σ_k` is
///
/// ```text
/// min(1, m σ_k²) times the one asked for
/// ```
///
/// Guaranteed by the model: exact wherever all effective inertias are below `m`; elsewhere the shortfall is confined to the
/// directions of higher inertia and never larger there than what is asked for (and the posture damping's part in them); the
/// kinetic-energy norm of `q̈` stays below `sqrt(m) |ẍ - J̇ q̇|` (without posture damping); all is continuous in the position, `1 / max(s, 1/m)`
/// being continuous on the spectrum. A guard of the joints ([`super::JointGuard`]) may come after it.
#[derive(Clone, Debug)]
pub struct OperationalSpace<const N: usize> {
    dynamics: Dynamics<N>,
    task: Task,
    settings: OperationalSettings,
    largest: TorqueLimits<N>,
}

impl<const N: usize> OperationalSpace<N> {
    /// A controller for a task. `largest` holds the joints' largest torques.
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`] with the first setting out of its range, [`MotionError::Kinematics`] for an arm with fewer joints
    /// than the task has coordinates.
    pub fn new(
        dynamics: Dynamics<N>,
        task: Task,
        settings: OperationalSettings,
        largest: JointVector<N>,
    ) -> Result<Self, MotionError> {
        positive("length", settings.length)?;
        positive("largest_inertia", settings.largest_inertia)?;
        not_negative("posture_damping", settings.posture_damping)?;
        let rows = task.rows().len();
        if N < rows {
            return Err(RobotError::NotSquare { rows, joints: N }.into());
        }
        Ok(Self { dynamics, task, settings, largest: TorqueLimits::new(largest)? })
    }

    /// The model.
    #[must_use]
    pub fn dynamics(&self) -> &Dynamics<N> {
        &self.dynamics
    }

    /// The task.
    #[must_use]
    pub fn task(&self) -> Task {
        self.task
    }

    /// One sample: the torques for an acceleration of the tool at the measured state. `external` is the measured wrench on the tool,
    /// zero if it is not to be cancelled. Where a number is not finite the torques are zero and all joints count as cut.
    #[must_use]
    pub fn step(
        &self,
        q: &JointVector<N>,
        qd: &JointVector<N>,
        acceleration: &Twist,
        external: &Twist,
    ) -> OperationalOutput<N> {
        let arm = self.dynamics.arm();
        let jacobian = arm.jacobian(q);
        let bias = arm.bias_acceleration(q, qd);
        let qdd = self.joint_acceleration(&jacobian, q, qd, &(acceleration - bias));
        let torque = self.dynamics.inverse(q, qd, &qdd) - jacobian.transpose() * self.task.select(external);
        let shortfall = self.task.select(&(acceleration - jacobian * qdd - bias));
        let output = self.largest.cut(&torque);
        OperationalOutput { torque: output.torque, cut: output.cut, shortfall }
    }

    /// Joint accelerations for the part of the tool's acceleration that they make; NaN if there is no mass matrix.
    ///
    /// With `M = L Lᵀ` and `A = J L⁻ᵀ = Σ σ_k u_k v_kᵀ`: `Lᵀ q̈ = Σ v_k σ_k (u_k·a) / max(σ_k², 1/m) + posture`.
    fn joint_acceleration(
        &self,
        jacobian: &Jacobian<N>,
        q: &JointVector<N>,
        qd: &JointVector<N>,
        wanted: &Twist,
    ) -> JointVector<N> {
        let nowhere = JointVector::from_element(f64::NAN);
        let Some(factor) = self.dynamics.mass_matrix(q).cholesky() else { return nowhere };
        let lower = factor.l();
        let rows = self.weighted(jacobian);
        let Some(scaled) = lower.solve_lower_triangular(&rows.transpose()) else { return nowhere };
        let Some(svd) = JacobiSvd::<N>::new(&scaled.transpose()) else { return nowhere };
        let wanted = self.weights().component_mul(wanted);
        let mut posture = lower.transpose() * qd * -self.settings.posture_damping;
        let mut sum = JointVector::<N>::zeros();
        for k in 0..N {
            let (direction, inertia) = (svd.v.column(k), self.inverse_inertia(svd.singular_value(k)));
            sum += direction * (svd.scaled.column(k).dot(&wanted) / inertia);
            let share = svd.scaled.column(k).norm_squared() / inertia;
            posture -= direction * (share * direction.dot(&posture));
        }
        lower.tr_solve_lower_triangular(&(sum + posture)).unwrap_or(nowhere)
    }

    /// `max(σ², 1/m)`, 1/kg.
    fn inverse_inertia(&self, singular_value: f64) -> f64 {
        (singular_value * singular_value).max(1.0 / self.settings.largest_inertia)
    }

    /// 1 for linear rows, the length for angular ones, 0 outside the task.
    fn weights(&self) -> Twist {
        let length = self.settings.length;
        self.task.select(&Twist::new(1.0, 1.0, 1.0, length, length, length))
    }

    fn weighted(&self, jacobian: &Jacobian<N>) -> Jacobian<N> {
        let weights = self.weights();
        SMatrix::from_fn(|i, j| jacobian[(i, j)] * weights[i])
    }
}
