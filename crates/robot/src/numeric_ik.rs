use crate::{JointVector, LinkFrames, Pose, RobotError, SerialArm, Task, Twist, rotation_vector};
use nalgebra::{Matrix6, SMatrix};

/// When the numeric inverse kinematics stops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NumericIkSettings {
    /// Position error accepted, m.
    pub position_tolerance: f64,
    /// Orientation error accepted, rad.
    pub orientation_tolerance: f64,
    /// Iterations before giving up.
    pub max_iterations: usize,
}

impl Default for NumericIkSettings {
    fn default() -> Self {
        Self { position_tolerance: 1e-12, orientation_tolerance: 1e-12, max_iterations: 200 }
    }
}

/// Keeps the normal equations positive definite at an exact singularity: rounding of `J Jᵀ`, whose entries are of size 1.
const SMALLEST_DAMPING: f64 = 1e-15;

/// Errors below this share of the tolerance are not polished. Of tolerances from 1e-10 m on it is rounding of places of a metre and more;
/// of smaller ones it is out of reach, and the polishing step is always made.
const AT_ROUNDING: f64 = 1e-5;

/// A joint position on the way to the answer, and what is known there.
struct Iterate<const N: usize> {
    q: JointVector<N>,
    frames: LinkFrames<N>,
    error: Twist,
}

/// Numeric inverse kinematics by Levenberg-Marquardt steps from a seed: any arm, any task.
///
/// Converges to the solution nearest to the seed in the sense of the descent, so the seed chooses the branch.
#[derive(Clone, Copy, Debug)]
pub struct NumericIk<'a, const N: usize> {
    arm: &'a SerialArm<N>,
    task: Task,
    settings: NumericIkSettings,
}

impl<'a, const N: usize> NumericIk<'a, N> {
    /// A solver for one arm and task.
    #[must_use]
    pub fn new(arm: &'a SerialArm<N>, task: Task, settings: NumericIkSettings) -> Self {
        Self { arm, task, settings }
    }

    /// The arm it solves for.
    pub(crate) fn arm(&self) -> &SerialArm<N> {
        self.arm
    }

    /// The joint position that puts the tool at `pose`, from a seed.
    ///
    /// # Errors
    ///
    /// [`RobotError::NotConverged`] with the error that is left.
    pub fn solve(&self, pose: &Pose, seed: &JointVector<N>) -> Result<JointVector<N>, RobotError> {
        let mut at = self.iterate(pose, *seed);
        // Damping in proportion to the squared error (Sugihara 2011): far away it keeps the step small where the arm is
        // nearly singular, close by it vanishes and the steps become Newton's.
        let mut boost = 1.0;
        for _ in 0..self.settings.max_iterations {
            if self.small(&at.error) {
                let done = at.error.amax() <= AT_ROUNDING * self.settings.position_tolerance;
                return Ok(if done { at.q } else { self.polish(pose, &at) });
            }
            let damping = boost * 0.5 * at.error.norm_squared() + SMALLEST_DAMPING;
            let trial = self.iterate(pose, at.q + self.step(&at, damping));
            if trial.error.norm() < at.error.norm() {
                at = trial;
                boost = (boost * 0.1_f64).max(1e-3);
            } else if boost > 1e12 || !trial.error.iter().all(|e| e.is_finite()) {
                break;
            } else {
                boost *= 10.0;
            }
        }
        if self.small(&at.error) {
            return Ok(at.q);
        }
        Err(RobotError::NotConverged {
            position_error: at.error.fixed_rows::<3>(0).norm(),
            orientation_error: at.error.fixed_rows::<3>(3).norm(),
            iterations: self.settings.max_iterations,
        })
    }

    fn iterate(&self, pose: &Pose, q: JointVector<N>) -> Iterate<N> {
        let frames = self.arm.frames(&q);
        let error = self.error_of(pose, &frames.tool);
        Iterate { q, frames, error }
    }

    /// Task error as a twist: linear part in m, angular part as the rotation vector from tool to target in rad.
    pub fn error(&self, pose: &Pose, q: &JointVector<N>) -> Twist {
        self.error_of(pose, &self.arm.forward(q))
    }

    fn error_of(&self, pose: &Pose, tool: &Pose) -> Twist {
        let linear = pose.translation.vector - tool.translation.vector;
        let angular = rotation_vector(&(pose.rotation * tool.rotation.inverse()));
        self.task.select(&Twist::new(linear.x, linear.y, linear.z, angular.x, angular.y, angular.z))
    }

    fn small(&self, error: &Twist) -> bool {
        error.fixed_rows::<3>(0).norm() <= self.settings.position_tolerance
            && error.fixed_rows::<3>(3).norm() <= self.settings.orientation_tolerance
    }

    /// One more nearly undamped step, kept if it helps: takes the error from the tolerance to rounding.
    fn polish(&self, pose: &Pose, at: &Iterate<N>) -> JointVector<N> {
        let better = at.q + self.step(at, SMALLEST_DAMPING);
        if self.error(pose, &better).norm() < at.error.norm() { better } else { at.q }
    }

    /// `Δq = Jᵀ (J Jᵀ + μ I)⁻¹ e`, the damped least-squares step on the task's rows; of an arm with fewer than six joints from the smaller
    /// system of the same solution, `(Jᵀ J + μ I)⁻¹ Jᵀ e`.
    fn step(&self, at: &Iterate<N>, damping: f64) -> JointVector<N> {
        let rows = self.task.select_rows(&self.arm.jacobian_at(&at.frames));
        if N < 6 {
            let gram = rows.transpose() * rows + SMatrix::<f64, N, N>::from_diagonal_element(damping);
            return gram.cholesky().map_or_else(JointVector::zeros, |c| c.solve(&(rows.transpose() * at.error)));
        }
        let gram = rows * rows.transpose() + Matrix6::from_diagonal_element(damping);
        gram.cholesky().map_or_else(JointVector::zeros, |c| rows.transpose() * c.solve(&at.error))
    }
}
