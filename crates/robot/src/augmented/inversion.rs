use super::{NullVector, SpeedFactor, null_vector, null_vector_rate};
use crate::{Jacobian, JointVector, RobotError, SerialArm, Task, Twist};
use nalgebra::{SMatrix, SVector};

/// The tool's twist along a path at unit path speed, and how it changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathTangent {
    /// `t*(q*)`: m and rad per unit of the path parameter, base frame.
    pub twist: Twist,
    /// `dt*/dq*`.
    pub slope: Twist,
}

/// The null vector at one place and its derivative along itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flow<const N: usize> {
    /// `n̄`: speeds at `b = 1`.
    pub direction: NullVector<N>,
    /// `(∂n̄/∂q̄) n̄`: accelerations at `b = 1`.
    pub slope: NullVector<N>,
}

/// Speeds and accelerations of the joints and of the path parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathMotion<const N: usize> {
    /// `q̇ = b n`, rad/s.
    pub joint_speed: JointVector<N>,
    /// `q̈ = b² (∂n/∂q̄) n̄ + ḃ n`, rad/s².
    pub joint_acceleration: JointVector<N>,
    /// `q̇*`, 1/s.
    pub path_speed: f64,
    /// `q̈*`, 1/s².
    pub path_acceleration: f64,
}

impl<const N: usize> Flow<N> {
    /// The motion at given `b` and `ḃ`.
    ///
    /// `∂n/∂q̄` has `N + 1` columns and multiplies `n̄`; `[N] eq 10, 11` as printed multiply it with `n`, which has `N`
    /// entries.
    #[must_use]
    pub fn motion(&self, b: f64, b_rate: f64) -> PathMotion<N> {
        PathMotion {
            // [N] eq 4, in two parts: [N] eq 7 and [N] eq 8.
            joint_speed: self.direction.joints * b,
            joint_acceleration: self.slope.joints * (b * b) + self.direction.joints * b_rate,
            // [N] eq 2 is this times the twist.
            path_speed: self.direction.path * b,
            path_acceleration: self.slope.path * (b * b) + self.direction.path * b_rate,
        }
    }
}

/// Singularity-consistent inversion for an arm with as many joints as task coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SingularityConsistent {
    task: Task,
    factor: SpeedFactor,
}

impl SingularityConsistent {
    /// An inversion for arms with `joints` joints.
    ///
    /// # Errors
    ///
    /// [`RobotError::NotSquare`] unless there are as many joints as task coordinates (lock a joint, or see
    /// [`super::redundant_null_vector`]); a factor that does not fit.
    pub fn new(task: Task, factor: SpeedFactor, joints: usize) -> Result<Self, RobotError> {
        let rows = task.rows().len();
        if rows != joints {
            return Err(RobotError::NotSquare { rows, joints });
        }
        factor.validate(task, joints)?;
        Ok(Self { task, factor })
    }

    /// The task.
    #[must_use]
    pub fn task(&self) -> Task {
        self.task
    }

    /// `n̄` at a configuration; NaN where the task has not `N` rows, which [`SingularityConsistent::new`] rules out.
    #[must_use]
    pub fn direction<const N: usize>(&self, arm: &SerialArm<N>, q: &JointVector<N>, twist: &Twist) -> NullVector<N> {
        let jacobian = arm.jacobian(q);
        let divisor = self.factor.divisor(&jacobian, &Jacobian::zeros()).value;
        null_vector(&self.square(&jacobian), &self.right(twist)).scaled(1.0 / divisor)
    }

    /// `n̄` and its derivative along itself.
    ///
    /// With a divisor `d`, `m̄ = n̄ / d` and `m̄' = (n̄' - d' m̄) / d`, the dash being the derivative along `m̄`.
    #[must_use]
    pub fn flow<const N: usize>(&self, arm: &SerialArm<N>, q: &JointVector<N>, tangent: &PathTangent) -> Flow<N> {
        let direction = self.direction(arm, q, &tangent.twist);
        let jacobian = arm.jacobian(q);
        let rate = arm.jacobian_rate(q, &direction.joints);
        let slope = null_vector_rate(
            &self.square(&jacobian),
            &self.right(&tangent.twist),
            &self.square(&rate),
            &self.right(&(tangent.slope * direction.path)),
        );
        let divisor = self.factor.divisor(&jacobian, &rate);
        let part = |whole: f64, value: f64| (whole - divisor.rate * value) / divisor.value;
        let joints = slope.joints.zip_map(&direction.joints, part);
        let path = part(slope.path, direction.path);
        Flow { direction, slope: NullVector { joints, path } }
    }

    /// The task's rows of a Jacobian.
    fn square<const N: usize>(&self, jacobian: &Jacobian<N>) -> SMatrix<f64, N, N> {
        let rows = self.task.rows();
        SMatrix::from_fn(|i, j| rows.get(i).map_or(f64::NAN, |&row| jacobian[(row, j)]))
    }

    /// The task's rows of a twist.
    fn right<const N: usize>(&self, twist: &Twist) -> SVector<f64, N> {
        let rows = self.task.rows();
        SVector::from_fn(|i, _| rows.get(i).map_or(f64::NAN, |&row| twist[row]))
    }
}
