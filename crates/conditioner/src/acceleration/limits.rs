use crate::error::ParameterError;
use crate::limits::SpeedLimits;

/// Joint-acceleration limits, lower and upper, not necessarily symmetric. Unit: rad/s² (m/s² for a prismatic joint).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccelerationLimits<const N: usize> {
    lower: [f64; N],
    upper: [f64; N],
}

impl<const N: usize> AccelerationLimits<N> {
    /// Lower and upper limits, joint by joint.
    ///
    /// # Errors
    ///
    /// A lower limit that is not negative and finite, or an upper one that is not positive and finite.
    pub fn new(lower: [f64; N], upper: [f64; N]) -> Result<Self, ParameterError> {
        for (joint, (&lo, &up)) in lower.iter().zip(&upper).enumerate() {
            if !(lo < 0.0 && lo.is_finite()) {
                return Err(ParameterError::LowerAcceleration { joint, value: lo });
            }
            if !(up > 0.0 && up.is_finite()) {
                return Err(ParameterError::UpperAcceleration { joint, value: up });
            }
        }
        Ok(Self { lower, upper })
    }

    /// The same limit in both directions.
    ///
    /// # Errors
    ///
    /// A limit that is not positive and finite.
    pub fn symmetric(limit: [f64; N]) -> Result<Self, ParameterError> {
        for (joint, &value) in limit.iter().enumerate() {
            if !(value > 0.0 && value.is_finite()) {
                return Err(ParameterError::UpperAcceleration { joint, value });
            }
        }
        Self::new(limit.map(|l| -l), limit)
    }

    /// Lower limits, all negative.
    #[must_use]
    pub fn lower(&self) -> &[f64; N] {
        &self.lower
    }

    /// Upper limits, all positive.
    #[must_use]
    pub fn upper(&self) -> &[f64; N] {
        &self.upper
    }
}

/// The joint speeds that one sample can reach: a box.
///
/// ```text
/// max(lower speed limit, p + Ts a_lower) <= q̇ <= min(upper speed limit, p + Ts a_upper)
/// ```
///
/// `p` is the previous commanded speed. Inside the speed limits it lies in the box, so the box is never empty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Reachable<const N: usize> {
    pub(super) lower: [f64; N],
    pub(super) upper: [f64; N],
}

impl<const N: usize> Reachable<N> {
    /// The box around the previous speed. A previous speed beyond the limits yields the nearest limit and is never passed on.
    #[inline]
    pub(super) fn around(
        before: &[f64; N],
        speeds: &SpeedLimits<N>,
        accelerations: &AccelerationLimits<N>,
        period: f64,
    ) -> Self {
        let (mut lower, mut upper) = (*before, *before);
        let speeds = || speeds.lower().iter().zip(speeds.upper());
        for ((v, a), (&lo, &up)) in lower.iter_mut().zip(&accelerations.lower).zip(speeds()) {
            *v = (*v + period * a).max(lo).min(up);
        }
        for ((v, a), (&lo, &up)) in upper.iter_mut().zip(&accelerations.upper).zip(speeds()) {
            *v = (*v + period * a).max(lo).min(up);
        }
        Self { lower, upper }
    }

    /// Lower and upper ends, joint by joint.
    #[inline]
    pub(super) fn ends(&self) -> impl Iterator<Item = (f64, f64)> {
        self.lower.iter().copied().zip(self.upper.iter().copied())
    }

    /// The point of the box nearest to a joint speed, each joint on its own.
    #[inline]
    pub(super) fn nearest(&self, speed: &[f64; N]) -> [f64; N] {
        let mut nearest = *speed;
        for (v, (lo, up)) in nearest.iter_mut().zip(self.ends()) {
            *v = v.max(lo).min(up);
        }
        nearest
    }

    /// The point of the box nearest to standing still.
    #[inline]
    pub(super) fn slowest(&self) -> [f64; N] {
        self.nearest(&[0.0; N])
    }
}
