use crate::MotionError;
use crate::error::not_negative;
use nalgebra::Vector3;
use slideway_robot::Twist;

/// A diagonal matrix over twists: one gain for each axis of the base frame, one for all rotations.
///
/// One gain for rotations makes the moment `k log(R_d Rᵀ)` the gradient of the potential `½ k |angle|²`; three different ones would
/// not have a potential in this form, and impedance control would not be passive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolGains {
    linear: Vector3<f64>,
    angular: f64,
}

impl ToolGains {
    /// No gain at all.
    pub const ZERO: Self = Self { linear: Vector3::new(0.0, 0.0, 0.0), angular: 0.0 };

    /// Gains that are not negative.
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`] with the first that is negative or not finite.
    pub fn new(linear: Vector3<f64>, angular: f64) -> Result<Self, MotionError> {
        linear.iter().try_for_each(|&gain| not_negative("linear", gain))?;
        not_negative("angular", angular)?;
        Ok(Self { linear, angular })
    }

    /// The same gain for the three axes.
    ///
    /// # Errors
    ///
    /// As [`ToolGains::new`].
    pub fn uniform(linear: f64, angular: f64) -> Result<Self, MotionError> {
        Self::new(Vector3::from_element(linear), angular)
    }

    /// The product with a twist.
    #[must_use]
    pub fn times(&self, twist: &Twist) -> Twist {
        self.diagonal().component_mul(twist)
    }

    /// `½ eᵀ K e`.
    #[must_use]
    pub fn energy(&self, error: &Twist) -> f64 {
        0.5 * error.dot(&self.times(error))
    }

    /// The diagonal.
    #[must_use]
    pub fn diagonal(&self) -> Twist {
        let (l, a) = (self.linear, self.angular);
        Twist::new(l.x, l.y, l.z, a, a, a)
    }
}
