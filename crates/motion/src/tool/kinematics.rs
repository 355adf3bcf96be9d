use crate::{JointState, MotionError};
use slideway_robot::{
    InverseMethod, JacobiSvd, JointVector, NumericIk, NumericIkSettings, Pose, RobotError, SerialArm, Task, Twist,
};
use thiserror::Error;

/// Why the joints cannot follow the tool at some place.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ToolFault {
    /// No joint position puts the tool there.
    #[error("there is no joint position for it: {0}")]
    Unreachable(RobotError),
    /// The arm is too close to a singularity.
    #[error("the arm is singular: its smallest singular value is {smallest:.3e}, at least {allowed:.3e} is needed")]
    Singular {
        /// Smallest singular value of the Jacobian on the task's rows.
        smallest: f64,
        /// Smallest one allowed.
        allowed: f64,
    },
    /// A joint would come too close to its stop.
    #[error("joint {} would be at {position:.6}, beyond {limit:.6}", joint + 1)]
    JointStop {
        /// Joint, counted from 0.
        joint: usize,
        /// Its position, rad or m.
        position: f64,
        /// The position allowed, rad or m.
        limit: f64,
    },
    /// The joints would have to jump to another solution.
    #[error("joint {} would jump by {jump:.3e} to another solution", joint + 1)]
    BranchChange {
        /// Joint, counted from 0.
        joint: usize,
        /// By how much, rad or m.
        jump: f64,
    },
    /// No rate of the path keeps a joint's acceleration, which the plan did not foresee.
    #[error("joint {} would accelerate by {acceleration:.6}, its limit is {limit:.6}", joint + 1)]
    TooRough {
        /// Joint, counted from 0.
        joint: usize,
        /// Its acceleration, per s².
        acceleration: f64,
        /// Its limit, per s².
        limit: f64,
    },
    /// A joint would be faster than its limit, which the check before the motion did not foresee.
    #[error("joint {} would move at {speed:.6}, its limit is {limit:.6}", joint + 1)]
    TooFast {
        /// Joint, counted from 0.
        joint: usize,
        /// Its speed, per s.
        speed: f64,
        /// Its limit, per s.
        limit: f64,
    },
}

/// An arm, what its tool is asked to follow, and how close to a singularity it may come.
#[derive(Clone, Debug)]
pub struct ToolKinematics<const N: usize> {
    arm: SerialArm<N>,
    task: Task,
    smallest_singular_value: f64,
}

/// The polishing step of the inverse kinematics takes errors below this to rounding.
const IK: NumericIkSettings =
    NumericIkSettings { position_tolerance: 1e-10, orientation_tolerance: 1e-10, max_iterations: 40 };

impl<const N: usize> ToolKinematics<N> {
    /// `smallest_singular_value` is that of the Jacobian on the task's rows (m and rad mixed, as the task does); `0.02` keeps a
    /// PUMA-like arm a degree or so away from its wrist singularity.
    ///
    /// # Errors
    ///
    /// A threshold that is not positive and finite; an arm with fewer joints than its task has coordinates.
    pub fn new(arm: SerialArm<N>, task: Task, smallest_singular_value: f64) -> Result<Self, MotionError> {
        let rows = task.rows().len();
        if N < rows {
            return Err(RobotError::NotSquare { rows, joints: N }.into());
        }
        InverseMethod::TruncatedSvd { cutoff: smallest_singular_value }.validate(task, N)?;
        Ok(Self { arm, task, smallest_singular_value })
    }

    /// The arm.
    #[must_use]
    pub fn arm(&self) -> &SerialArm<N> {
        &self.arm
    }

    /// The task.
    #[must_use]
    pub fn task(&self) -> Task {
        self.task
    }

    /// The joint state that moves the tool along, from a joint position close by.
    ///
    /// ```text
    /// q̇ = J⁺ ẋ,   q̈ = J⁺ (ẍ - J̇ q̇)
    /// ```
    ///
    /// # Errors
    ///
    /// [`ToolFault::Unreachable`] and [`ToolFault::Singular`].
    pub fn follow(
        &self,
        pose: &Pose,
        twist: &Twist,
        acceleration: &Twist,
        seed: &JointVector<N>,
    ) -> Result<JointState<N>, ToolFault> {
        let q = NumericIk::new(&self.arm, self.task, IK).solve(pose, seed).map_err(ToolFault::Unreachable)?;
        let frames = self.arm.frames(&q);
        let svd = JacobiSvd::new(&self.task.select_rows(&self.arm.jacobian_at(&frames)));
        let smallest = svd.as_ref().map_or(f64::NAN, |svd| self.smallest(svd));
        let allowed = self.smallest_singular_value;
        let Some(svd) = svd.filter(|_| smallest >= allowed) else {
            return Err(ToolFault::Singular { smallest, allowed });
        };
        // All of the task's singular values are above the cutoff: this is the plain pseudo-inverse.
        let rates = |twist: &Twist| svd.solve(&self.task.select(twist), 0.5 * allowed);
        let qd = rates(twist);
        let qdd = rates(&(acceleration - self.arm.bias_acceleration_at(&frames, &qd)));
        Ok(JointState { q, qd, qdd })
    }

    /// The smallest singular value that belongs to the task's rows.
    fn smallest(&self, svd: &JacobiSvd<N>) -> f64 {
        let mut values: [f64; N] = std::array::from_fn(|k| svd.singular_value(k));
        values.sort_unstable_by(|a, b| b.total_cmp(a));
        // A redundant arm has more columns than rows; the values beyond the rows' number are zero by construction.
        values.get(self.task.rows().len().wrapping_sub(1)).copied().unwrap_or(f64::NAN)
    }
}
