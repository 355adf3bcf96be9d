use super::super::{Pid, PidState};
use crate::MotionError;
use crate::error::{not_negative, positive};
use nalgebra::{Unit, Vector3};
use slideway_robot::Twist;

/// State of a [`ForceControl`] from one sample to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ForceState {
    feedback: PidState,
}

/// Force along one direction, motion across it.
///
/// ```text
/// ẍ = (I - n nᵀ) ẍ_motion + n (u(F - f) - d n·ẋ)          f = -n·f_ext, the force of the tool on the environment
/// ```
///
/// `u` is a PID whose proportional gain has the unit 1/kg: `[R16]`'s rule of one over the stiffness fits a position as output, not an
/// acceleration. With contact of stiffness `k` the error obeys `f̈ + d ḟ + k Kp (f - F) = 0`; `d = 2 sqrt(k Kp)` is critical, so that the
/// damping has to be chosen for the stiffest environment. An integral takes away what is left of a model error.
///
/// The wrench is to be cancelled by the [`OperationalSpace`](super::OperationalSpace). Without contact the tool moves along `n` at
/// `Kp F / d`: choose the damping for a safe speed of approach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ForceControl {
    direction: Unit<Vector3<f64>>,
    feedback: Pid,
    damping: f64,
}

impl ForceControl {
    /// Force control along `direction`, the one in which the tool pushes (base frame), with a damping in 1/s.
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`]: a direction of no length, a negative damping.
    pub fn new(direction: Vector3<f64>, feedback: Pid, damping: f64) -> Result<Self, MotionError> {
        positive("direction", direction.norm())?;
        not_negative("damping", damping)?;
        Ok(Self { direction: Unit::new_normalize(direction), feedback, damping })
    }

    /// The force of the tool on the environment along the direction, N, from the wrench on the tool.
    #[must_use]
    pub fn force(&self, external: &Twist) -> f64 {
        -self.direction.dot(&external.fixed_rows::<3>(0))
    }

    /// One sample: the tool's acceleration that lets it push with `force` (N), and otherwise move as `motion` says. Only the PID's own
    /// rate of the error is used: with [`Derivative::Measured`](super::super::Derivative::Measured) there is none.
    pub fn acceleration(
        &self,
        state: &mut ForceState,
        force: f64,
        external: &Twist,
        twist: &Twist,
        motion: &Twist,
    ) -> Twist {
        let n = self.direction.into_inner();
        let push = self.feedback.step(&mut state.feedback, force - self.force(external), 0.0);
        let linear = motion.fixed_rows::<3>(0).into_owned();
        let along = push - self.damping * n.dot(&twist.fixed_rows::<3>(0)) - n.dot(&linear);
        let mut acceleration = *motion;
        acceleration.fixed_rows_mut::<3>(0).copy_from(&(linear + n * along));
        acceleration
    }
}
