use crate::{Jacobian, RobotError, Task};
use nalgebra::Matrix3;

/// Factor of the speed along the path, which is this factor times `b`.
///
/// The null vector may be divided by any function of the configuration that has no zero on the path: what is left of
/// `det J` is the factor of the speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpeedFactor {
    /// The whole determinant, `q̇* = b det J`.
    Determinant,
    /// The determinant without the part of a spherical wrist.
    ///
    /// With the last three axes through one point `det J = det J_arm · det [z₄ z₅ z₆]`; at constant orientation of the tool
    /// a path can pass close to a singularity of the arm while the wrist is far from its own. Then
    ///
    /// ```text
    /// q̇* = b det J / (scale · det [z₄ z₅ z₆])
    /// ```
    ///
    /// For the PA-10 with joint 3 locked and `scale = L1 L2` this is `q̇* = b ρ sin q4`, `ρ` the distance of the wrist from
    /// the base axis (on the side where it points forward). Infinite at a wrist singularity.
    Arm {
        /// Lengths of the links that are constant factors of the determinant, for the PA-10 0.45 m · 0.5 m; m².
        scale: f64,
    },
}

/// The divisor of the null vector and its rate of change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Divisor {
    pub(super) value: f64,
    pub(super) rate: f64,
}

impl SpeedFactor {
    /// Checks that the factor fits an arm with `joints` joints and a task.
    pub(super) fn validate(self, task: Task, joints: usize) -> Result<(), RobotError> {
        match self {
            Self::Determinant => Ok(()),
            Self::Arm { scale } if !(scale > 0.0 && scale.is_finite()) => {
                Err(RobotError::NotPositive { name: "scale of the speed factor", value: scale })
            }
            Self::Arm { .. } if task != Task::Pose => {
                Err(RobotError::NotSphericalWrist { reason: "the task does not prescribe an orientation" })
            }
            Self::Arm { .. } if joints != 6 => {
                Err(RobotError::NotSphericalWrist { reason: "the arm does not have six joints" })
            }
            Self::Arm { .. } => Ok(()),
        }
    }

    /// Divisor of the null vector and the divisor's rate, from a Jacobian and its rate.
    pub(super) fn divisor<const N: usize>(self, jacobian: &Jacobian<N>, rate: &Jacobian<N>) -> Divisor {
        let Self::Arm { scale } = self else {
            return Divisor { value: 1.0, rate: 0.0 };
        };
        let axes = wrist_axes(jacobian);
        let rates = wrist_axes(rate);
        // A determinant is linear in every column.
        let replaced = |column: usize| {
            let mut matrix = axes;
            matrix.set_column(column, &rates.column(column));
            matrix.determinant()
        };
        Divisor { value: scale * axes.determinant(), rate: scale * (0..3).map(replaced).sum::<f64>() }
    }
}

/// The axes of the last three joints (or their rates), from the angular rows. NaN for fewer joints.
fn wrist_axes<const N: usize>(jacobian: &Jacobian<N>) -> Matrix3<f64> {
    Matrix3::from_fn(|i, j| (N + j).checked_sub(3).map_or(f64::NAN, |column| jacobian[(3 + i, column)]))
}
