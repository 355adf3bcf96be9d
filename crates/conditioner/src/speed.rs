use crate::error::{ParameterError, positive};
use crate::filter::FirstOrderFilter;
use crate::limits::{Saturation, SpeedLimits};

/// Rule that advances the path parameter: the two explicit forms of the law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Advance {
    /// `λ̇ = f λ̇d`, as published. While a sample saturates, the reference runs ahead of the robot.
    Paper,
    /// `λ̇ = fdir f λ̇d`: the reference waits by as much as the robot is slowed, so it never runs ahead.
    Synchronised,
}

/// Parameters of a speed regulator, validated by [`SpeedRegulator::new`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedSettings<const N: usize> {
    /// Joint-speed limits, rad/s.
    pub limits: SpeedLimits<N>,
    /// Sampling period `Ts`, s.
    pub sampling_period: f64,
    /// Filter bandwidth `af`, rad/s. `bandwidth * sampling_period` is at most 1.
    pub bandwidth: f64,
    /// Target rate of the path parameter `λ̇d`, 1/s: choose it above what the limits allow, `[G11] eq 21`.
    pub target_rate: f64,
    /// Rule that brings a desired joint speed beyond the limits back inside them.
    pub saturation: Saturation,
    /// Rule that advances the path parameter.
    pub advance: Advance,
}

/// The whole state of a speed regulator: the factor `f` in [0, 1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedState {
    factor: f64,
}

impl SpeedState {
    /// The reference at rest, `f = 0`.
    #[must_use]
    pub fn at_rest() -> Self {
        Self { factor: 0.0 }
    }

    /// A reference already moving with `f` in [0, 1].
    ///
    /// # Errors
    ///
    /// A factor outside [0, 1], or NaN.
    pub fn moving(factor: f64) -> Result<Self, ParameterError> {
        if (0.0..=1.0).contains(&factor) { Ok(Self { factor }) } else { Err(ParameterError::Factor(factor)) }
    }

    /// The factor `f` that the coming sample uses.
    #[must_use]
    pub fn factor(&self) -> f64 {
        self.factor
    }

    #[allow(clippy::manual_clamp)]
    pub(crate) fn set(&mut self, factor: f64) {
        // `max` returns the number where the other side is NaN, so a NaN ends as 0 and brakes; `clamp` would keep it.
        self.factor = factor.max(0.0).min(1.0);
    }
}

/// The discontinuous signal `u` of `[G11] eq 17`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Switch {
    /// `u = 1`: every joint keeps its limits, the reference may gain speed.
    Release,
    /// `u = 0`: a limit is exceeded or the input is not finite, the reference loses speed.
    Brake,
}

impl Switch {
    /// `u` as a number, 0 or 1.
    #[must_use]
    pub fn value(self) -> f64 {
        match self {
            Self::Release => 1.0,
            Self::Brake => 0.0,
        }
    }
}

/// Output of one sample: the joint speed to command and the rate of the path parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedCommand<const N: usize> {
    /// Joint speed to command, `q̇ds`, inside the limits.
    pub joint_speed: [f64; N],
    /// Rate of the path parameter over this sample, `λ̇`: advance `λ` by `Ts * path_rate`.
    pub path_rate: f64,
    /// The factor `f` this sample used.
    pub factor: f64,
    /// Input of the filter, `u`: 0 or 1 in the explicit forms. In the implicit form the selection of the set-valued switch:
    /// at most 1, and negative where the limits fall faster than the filter could follow.
    pub switch: f64,
    /// Direction factor `fdir`, in [0, 1].
    pub direction_factor: f64,
    /// Largest use of a limit by the desired joint speed, `‖F_N q̇d‖∞`.
    pub limit_ratio: f64,
}

/// Sliding-mode regulation of the speed along a path, explicit forms.
///
/// One sample, with `a = af Ts` (`[G11] eq 7, 8, 17-19, 22`):
///
/// ```text
/// q̇ds  = fdir q̇d,  fdir = min(1, 1 / ‖F_N q̇d‖∞)
/// u    = 1 if q̇d is inside the limits, else 0
/// λ̇    = f λ̇d            (Advance::Paper)
/// λ̇    = fdir f λ̇d       (Advance::Synchronised)
/// f    <- (1 - a) f + a u
/// ```
///
/// Guaranteed: `f` stays in [0, 1] (claim `factor-range`); the command keeps its limits for every input; on a frozen
/// path `‖F_N q̇d‖∞ <= 1 + a (g - 1)` (claim `frozen-band`), on a drifting one the bound of
/// [`crate::bounds::drifting_band`] under its reaching condition (claim `drifting-band`). Not guaranteed: anything about
/// joint acceleration; and in the paper's form the reference may finish while the robot still trails.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedRegulator<const N: usize> {
    pub(crate) limits: SpeedLimits<N>,
    pub(crate) filter: FirstOrderFilter,
    pub(crate) target_rate: f64,
    pub(crate) saturation: Saturation,
    advance: Advance,
}

impl<const N: usize> SpeedRegulator<N> {
    /// Validates the settings once.
    ///
    /// # Errors
    ///
    /// See [`ParameterError`]; the limits were validated where they were made.
    pub fn new(settings: SpeedSettings<N>) -> Result<Self, ParameterError> {
        Ok(Self {
            limits: settings.limits,
            filter: FirstOrderFilter::new(settings.bandwidth, settings.sampling_period)?,
            target_rate: positive(settings.target_rate, ParameterError::TargetRate)?,
            saturation: settings.saturation,
            advance: settings.advance,
        })
    }

    /// The same regulator under other limits, for limits that vary along the path.
    #[must_use]
    pub fn with_limits(self, limits: SpeedLimits<N>) -> Self {
        Self { limits, ..self }
    }

    /// The path rate `f λ̇d` with which the controller is to compute this sample's desired joint speed. Unit: 1/s.
    #[inline]
    #[must_use]
    pub fn requested_rate(&self, state: &SpeedState) -> f64 {
        state.factor * self.target_rate
    }

    /// One sample: saturates the desired joint speed `q̇d`, decides the switch and advances the filter.
    #[inline]
    pub fn step(&self, state: &mut SpeedState, desired: &[f64; N]) -> SpeedCommand<N> {
        let saturated = self.limits.saturate(desired, self.saturation);
        // [G11] eq 17
        let switch = if self.limits.contain(desired) { Switch::Release } else { Switch::Brake };
        let factor = state.factor;
        let advance = match self.advance {
            // A standstill commanded for want of a finite input must not let the reference go on.
            Advance::Paper if saturated.direction_factor > 0.0 => 1.0,
            Advance::Paper => 0.0,
            Advance::Synchronised => saturated.direction_factor,
        };
        state.set(self.filter.next(factor, switch.value()));
        SpeedCommand {
            joint_speed: saturated.joint_speed,
            path_rate: advance * factor * self.target_rate,
            factor,
            switch: switch.value(),
            direction_factor: saturated.direction_factor,
            limit_ratio: self.limits.ratio(desired),
        }
    }
}
