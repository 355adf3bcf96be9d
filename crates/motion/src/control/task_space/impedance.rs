use super::super::TorqueOutput;
use super::super::limit::TorqueLimits;
use super::{OperationalSpace, ToolGains, ToolReference, ToolState, pose_error};
use crate::MotionError;
use crate::error::positive;
use slideway_robot::{Dynamics, JointVector, Task, Twist};

/// The tool as a spring and a damper at the end of the arm's own inertia: impedance control without a force sensor.
///
/// ```text
/// τ = Jᵀ (K e + D ė) + g(q)            e = xd - x, ė = ẋd - ẋ
/// ```
///
/// Guaranteed (claim `impedance-passivity`) with an exact `g`, torques inside their limits, the task being the whole pose or
/// position, and a reference at rest: `½ q̇ᵀ M q̇ + ½ eᵀ K e` grows by no more than the work of what pushes the arm, and falls by
/// `ẋᵀ D ẋ` besides. At rest the tool pushes with `K e`. Nothing is inverted, so that singularities are harmless; without a `D` on
/// every coordinate, or with more joints than coordinates, motion is not all damped.
///
/// Signs: `[R16]` prints `f - K (x_D - x) - D ẋ_D`, a spring that pushes away and damps the reference.
#[derive(Clone, Debug)]
pub struct Impedance<const N: usize> {
    dynamics: Dynamics<N>,
    task: Task,
    stiffness: ToolGains,
    damping: ToolGains,
    largest: TorqueLimits<N>,
}

impl<const N: usize> Impedance<N> {
    /// A stiffness `K` (N/m, N·m/rad), a damping `D` (N·s/m, N·m·s/rad), the joints' largest torques.
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`] if a torque limit is not positive.
    pub fn new(
        dynamics: Dynamics<N>,
        task: Task,
        stiffness: ToolGains,
        damping: ToolGains,
        largest: JointVector<N>,
    ) -> Result<Self, MotionError> {
        Ok(Self { dynamics, task, stiffness, damping, largest: TorqueLimits::new(largest)? })
    }

    /// Zero-gravity mode: the arm's weight is carried and nothing else is done, so that it can be led by hand and feels as heavy
    /// as its inertia. [`VirtualMass`] makes it feel lighter or heavier.
    ///
    /// # Errors
    ///
    /// As [`Impedance::new`].
    pub fn zero_gravity(dynamics: Dynamics<N>, largest: JointVector<N>) -> Result<Self, MotionError> {
        Self::new(dynamics, Task::Pose, ToolGains::ZERO, ToolGains::ZERO, largest)
    }

    /// One sample: the torques for a reference at the measured state.
    #[must_use]
    pub fn step(&self, desired: &ToolReference, q: &JointVector<N>, qd: &JointVector<N>) -> TorqueOutput<N> {
        let frames = self.dynamics.arm().frames(q);
        let jacobian = self.dynamics.arm().jacobian_at(&frames);
        let error = pose_error(&desired.pose, &frames.tool);
        let wrench = self.stiffness.times(&error) + self.damping.times(&(desired.twist - jacobian * qd));
        self.largest.cut(&(jacobian.transpose() * self.task.select(&wrench) + self.dynamics.gravity_torque(q)))
    }

    /// The spring's energy, J.
    #[must_use]
    pub fn energy(&self, desired: &ToolReference, q: &JointVector<N>) -> f64 {
        let error = pose_error(&desired.pose, &self.dynamics.arm().forward(q));
        self.stiffness.energy(&self.task.select(&error))
    }
}

/// The tool as a mass of one's choice on a spring and a damper: impedance control with a force sensor.
///
/// ```text
/// ẍ = ẍd + Md⁻¹ (f_ext + K e + D ė)
/// ```
///
/// with the wrench `f_ext` on the tool, fed to an [`OperationalSpace`] that cancels it at the joints. With `K = D = 0` it is
/// the zero-gravity mode with an apparent mass. Stability in contact is not guaranteed: a mass well below the arm's own asks for
/// accelerations beyond the torques (see [`acceleration_reach`](crate::characterise::acceleration_reach)) and, with delay, for
/// more than the loop has phase for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VirtualMass {
    inverse_mass: Twist,
    stiffness: ToolGains,
    damping: ToolGains,
}

impl VirtualMass {
    /// A mass `Md` (kg, kg m²), all of it positive, with stiffness and damping.
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`] if a mass or the moment of inertia is zero.
    pub fn new(mass: ToolGains, stiffness: ToolGains, damping: ToolGains) -> Result<Self, MotionError> {
        mass.diagonal().iter().try_for_each(|&value| positive("mass", value))?;
        Ok(Self { inverse_mass: mass.diagonal().map(|m| 1.0 / m), stiffness, damping })
    }

    /// Acceleration of the tool under a wrench on it, m/s² and rad/s².
    #[must_use]
    pub fn acceleration(&self, desired: &ToolReference, actual: &ToolState, external: &Twist) -> Twist {
        let error = pose_error(&desired.pose, &actual.pose);
        let rate = desired.twist - actual.twist;
        // [R16] eq 4, with the signs of a spring that pulls back and a damper of the tool.
        let wrench = external + self.stiffness.times(&error) + self.damping.times(&rate);
        desired.acceleration + self.inverse_mass.component_mul(&wrench)
    }

    /// One sample of a controller with this law.
    #[must_use]
    pub fn step<const N: usize>(
        &self,
        space: &OperationalSpace<N>,
        desired: &ToolReference,
        [q, qd]: [&JointVector<N>; 2],
        external: &Twist,
    ) -> TorqueOutput<N> {
        let actual = ToolState::of(space.dynamics().arm(), q, qd);
        let output = space.step(q, qd, &self.acceleration(desired, &actual, external), external);
        TorqueOutput { torque: output.torque, cut: output.cut }
    }
}
