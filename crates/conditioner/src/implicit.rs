use crate::error::ParameterError;
use crate::limits::SpeedLimits;
use crate::speed::{SpeedCommand, SpeedRegulator, SpeedSettings, SpeedState};

/// The desired joint speed as an affine function of the factor: `q̇d = feedback + f * feedforward`, rad/s.
///
/// Any 2-DOF controller gives it by two evaluations, so the regulator stays independent of robot and path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AffineSpeed<const N: usize> {
    /// `A`: what the controller asks for with the reference standing still, `λ̇ = 0`.
    pub feedback: [f64; N],
    /// `B`: what the reference at full rate adds to it.
    pub feedforward: [f64; N],
}

impl<const N: usize> AffineSpeed<N> {
    /// From two evaluations of the controller: with `λ̇ = 0` and with `λ̇ = λ̇d`.
    #[must_use]
    pub fn from_evaluations(standing: [f64; N], moving: [f64; N]) -> Self {
        let mut feedforward = moving;
        for (b, a) in feedforward.iter_mut().zip(&standing) {
            *b -= a;
        }
        Self { feedback: standing, feedforward }
    }

    /// `A + f B`.
    #[inline]
    #[must_use]
    pub fn at(&self, factor: f64) -> [f64; N] {
        let mut speed = self.feedback;
        for (v, b) in speed.iter_mut().zip(&self.feedforward) {
            *v += factor * b;
        }
        speed
    }
}

/// Sliding-mode regulation of the speed along a path, implicit (backward-Euler) form.
///
/// The switch of this sample is chosen together with the factor it produces, as the set-valued solution:
///
/// ```text
/// q̇d(f) = A + f B
/// f*     = max { f in [0, 1] : q̇d(f) inside the limits }      (0 if A alone lies outside)
/// f      = min((1 - a) f_prev + a, f*)
/// λ̇      = f λ̇d
/// ```
///
/// Guaranteed (claim `implicit-band`): whenever `A` lies inside the limits, so does `q̇d(f)`, to rounding; the factor
/// rises no faster than the filter. No chattering: between samples `f` changes only as fast as the filter rises or `f*`
/// falls. Not guaranteed: a bound on how fast `f` falls, which is as fast as the limits demand.
///
/// Where `A` alone exceeds the limits (a large initial error) the reference stands still and the command is saturated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImplicitSpeedRegulator<const N: usize> {
    inner: SpeedRegulator<N>,
}

impl<const N: usize> ImplicitSpeedRegulator<N> {
    /// Validates the settings once. `settings.advance` plays no part: both explicit advances coincide here.
    ///
    /// # Errors
    ///
    /// As [`SpeedRegulator::new`].
    pub fn new(settings: SpeedSettings<N>) -> Result<Self, ParameterError> {
        Ok(Self { inner: SpeedRegulator::new(settings)? })
    }

    /// The same regulator under other limits, for limits that vary along the path.
    #[must_use]
    pub fn with_limits(self, limits: SpeedLimits<N>) -> Self {
        Self { inner: self.inner.with_limits(limits) }
    }

    /// The target rate `λ̇d` at which `AffineSpeed::feedforward` is to be evaluated. Unit: 1/s.
    #[must_use]
    pub fn target_rate(&self) -> f64 {
        self.inner.target_rate
    }

    /// One sample: finds the factor, then the command.
    #[inline]
    pub fn step(&self, state: &mut SpeedState, desired: &AffineSpeed<N>) -> SpeedCommand<N> {
        let regulator = &self.inner;
        let step = regulator.filter.step();
        let before = state.factor();
        let allowed = regulator.limits.largest_factor(&desired.feedback, &desired.feedforward).unwrap_or(0.0);
        state.set(regulator.filter.next(before, 1.0).min(allowed));
        let factor = state.factor();
        // A feedforward that is not finite gives f* = 0, and 0 * infinity is NaN: the joints then stand still like the reference. With
        // f > 0 the speed is finite, for f is at most room / B at every joint.
        let speed = desired.at(factor);
        let saturated = regulator.limits.saturate(&speed, regulator.saturation);
        SpeedCommand {
            joint_speed: saturated.joint_speed,
            path_rate: factor * regulator.target_rate,
            factor,
            switch: 1.0 - (regulator.filter.next(before, 1.0) - factor) / step,
            direction_factor: saturated.direction_factor,
            limit_ratio: regulator.limits.ratio(&speed),
        }
    }
}
