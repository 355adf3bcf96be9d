use super::{ToolGains, ToolReference, pose_error};
use crate::MotionError;
use crate::error::setting;
use slideway_robot::{InverseMethod, JointVector, SerialArm, Task, solve_rates};

/// Law that turns a twist of the tool into joint speeds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RateLaw {
    /// `q̇ = J⁺ (ẋd + K e)`: the error dies out as `ė = -K e` where the inverse is exact.
    PseudoInverse(InverseMethod),
    /// `q̇ = Jᵀ K e`, without a feed-forward. With a reference at rest `V = ½ eᵀ K e` obeys `V̇ = -|Jᵀ K e|²`: it never grows, and
    /// falls to zero while `J` has full row rank (claim `transpose-descent`). Nothing is inverted, so a singularity is harmless,
    /// though the error may stay there. The unit of `K` is 1/(m² s) for positions.
    Transpose,
}

/// Joint speeds of one sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RateOutput<const N: usize> {
    /// Speeds, inside the limits, per s.
    pub rates: JointVector<N>,
    /// The share of the speeds asked for that the limits leave, in [0, 1]; 0 also if a number was not finite.
    pub share: f64,
}

/// First-order control of the tool over a speed interface, `[R16]`.
///
/// All joint speeds are reduced together, so that the tool keeps its direction and, under [`RateLaw::Transpose`], `V` its descent.
/// A sampled loop descends for periods below `2 / λ` with the largest eigenvalue `λ` of `J Jᵀ K`, to first order.
#[derive(Clone, Debug)]
pub struct RateController<const N: usize> {
    arm: SerialArm<N>,
    task: Task,
    law: RateLaw,
    gains: ToolGains,
    largest: JointVector<N>,
}

impl<const N: usize> RateController<N> {
    /// A controller with gains `K` (1/s) and the joints' largest speeds.
    ///
    /// # Errors
    ///
    /// [`MotionError::Kinematics`] if the inverse does not fit, [`MotionError::Setting`] for a speed limit that is not positive.
    pub fn new(
        arm: SerialArm<N>,
        task: Task,
        law: RateLaw,
        gains: ToolGains,
        largest: JointVector<N>,
    ) -> Result<Self, MotionError> {
        if let RateLaw::PseudoInverse(method) = law {
            method.validate(task, N)?;
        }
        largest.iter().try_for_each(|&value| setting("largest", value, value > 0.0))?;
        Ok(Self { arm, task, law, gains, largest })
    }

    /// One sample: joint speeds for a reference at a measured position. The reference's acceleration is not used.
    #[must_use]
    pub fn step(&self, desired: &ToolReference, q: &JointVector<N>) -> RateOutput<N> {
        let frames = self.arm.frames(q);
        let jacobian = self.arm.jacobian_at(&frames);
        let push = self.gains.times(&pose_error(&desired.pose, &frames.tool));
        let wanted = match self.law {
            RateLaw::PseudoInverse(method) => solve_rates(method, self.task, &jacobian, &(desired.twist + push)),
            RateLaw::Transpose => jacobian.transpose() * self.task.select(&push),
        };
        let use_of_limits = wanted.component_div(&self.largest).amax();
        if !(use_of_limits.is_finite() && wanted.iter().all(|x| x.is_finite())) {
            return RateOutput { rates: JointVector::zeros(), share: 0.0 };
        }
        let share = 1.0 / use_of_limits.max(1.0);
        RateOutput { rates: wanted * share, share }
    }
}
