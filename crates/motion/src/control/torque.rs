use super::limit::TorqueLimits;
use super::{Pid, PidState, TorqueOutput};
use crate::{JointState, MotionError};
use slideway_robot::{Dynamics, JointVector};

/// Law that makes a torque of feedback and the arm's model. `u` is the joints' PID output for the error of position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TorqueLaw {
    /// `τ = u`; the gains are torques per error.
    Pid,
    /// `τ = u + g(q)` at the measured position: steady under its own weight without an integral.
    GravityCompensation,
    /// `τ = u + M(q) q̈d + c(q, q̇) + g(q)`, with the model at the measured state.
    FeedForward,
    /// `τ = M(q) (q̈d + u) + c(q, q̇) + g(q)`; the gains are accelerations per error. With an exact model and torques inside
    /// their limits the error obeys `ë + u(e) = 0`, the same for each joint and every position.
    ComputedTorque,
}

/// Joint torques from a set-point and the measured state. Source: `[R16]`, feed-forward torque control.
///
/// A torque that is NaN becomes 0.
#[derive(Clone, Debug)]
pub struct TorqueController<const N: usize> {
    dynamics: Dynamics<N>,
    law: TorqueLaw,
    feedback: [Pid; N],
    largest: TorqueLimits<N>,
    states: [PidState; N],
}

impl<const N: usize> TorqueController<N> {
    /// A controller at rest. `largest` holds the joints' largest torques.
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`] if a torque limit is not positive; infinity is no limit.
    pub fn new(
        dynamics: Dynamics<N>,
        law: TorqueLaw,
        feedback: [Pid; N],
        largest: JointVector<N>,
    ) -> Result<Self, MotionError> {
        let largest = TorqueLimits::new(largest)?;
        Ok(Self { dynamics, law, feedback, largest, states: [PidState::default(); N] })
    }

    /// One sample: the torques for a set-point and the measured positions and speeds.
    pub fn step(&mut self, desired: &JointState<N>, q: &JointVector<N>, qd: &JointVector<N>) -> TorqueOutput<N> {
        let (error, rate) = (desired.q - q, desired.qd - qd);
        let mut feedback = JointVector::<N>::zeros();
        for (i, (pid, state)) in self.feedback.iter().zip(&mut self.states).enumerate() {
            feedback[i] = pid.step(state, error[i], rate[i]);
        }
        let torque = match self.law {
            TorqueLaw::Pid => feedback,
            TorqueLaw::GravityCompensation => feedback + self.dynamics.gravity_torque(q),
            TorqueLaw::FeedForward => feedback + self.dynamics.inverse(q, qd, &desired.qdd),
            TorqueLaw::ComputedTorque => self.dynamics.inverse(q, qd, &(desired.qdd + feedback)),
        };
        self.largest.cut(&torque)
    }
}
