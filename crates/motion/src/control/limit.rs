use crate::MotionError;
use crate::error::setting;
use slideway_robot::JointVector;

/// Torques of one sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorqueOutput<const N: usize> {
    /// Torques, inside the limits, N·m or N.
    pub torque: JointVector<N>,
    /// Joints whose torque was cut.
    pub cut: [bool; N],
}

/// Largest torques of the joints, positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TorqueLimits<const N: usize>(JointVector<N>);

impl<const N: usize> TorqueLimits<N> {
    pub(super) fn new(largest: JointVector<N>) -> Result<Self, MotionError> {
        largest.iter().try_for_each(|&value| setting("largest", value, value > 0.0))?;
        Ok(Self(largest))
    }

    /// Cuts each torque at its limit; NaN becomes 0.
    pub(super) fn cut(&self, torque: &JointVector<N>) -> TorqueOutput<N> {
        let largest = &self.0;
        let inside = |i: usize| torque[i].abs() <= largest[i];
        let limited = |i: usize| if torque[i].is_nan() { 0.0 } else { torque[i].clamp(-largest[i], largest[i]) };
        TorqueOutput { torque: JointVector::from_fn(|i, _| limited(i)), cut: std::array::from_fn(|i| !inside(i)) }
    }
}
