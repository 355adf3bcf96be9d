use super::factor::{Admissible, least_violation};
use super::limits::{AccelerationLimits, Reachable};
use crate::error::{ParameterError, positive};
use crate::filter::FirstOrderFilter;
use crate::implicit::AffineSpeed;
use crate::limits::SpeedLimits;

/// Treatment of the feedback part of the demand, which pulls the robot back to the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Recovery {
    /// Left as it is. A position loop `q̇ = Kp e` under bounded acceleration overshoots unless `Kp · speed <= deceleration`.
    AsDemanded,
    /// It is scaled so that the joints can brake from it, for a position loop of gain `Kp`.
    ///
    /// With `w = (1 - Kp Ts) a / Kp`, `a` the deceleration limit of the joint and `x = |A_i|`:
    ///
    /// ```text
    /// φ_i(x) = 1 for x <= w,  sqrt(w (2x - w)) / x beyond,   A <- A · min_i φ_i
    /// ```
    ///
    /// the speed from which the error `x / Kp` can be closed at the deceleration `(1 - Kp Ts) a`, joined smoothly to the linear law.
    /// One factor for all joints keeps the direction of return.
    Braking {
        /// `Kp`, 1/s; `Kp Ts` at most one half.
        gain: f64,
    },
}

/// Parameters of an acceleration-limited regulator, validated by [`AccelerationRegulator::new`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccelerationSettings<const N: usize> {
    /// Joint-speed limits, rad/s.
    pub speed_limits: SpeedLimits<N>,
    /// Joint-acceleration limits, rad/s².
    pub acceleration_limits: AccelerationLimits<N>,
    /// Sampling period `Ts`, s.
    pub sampling_period: f64,
    /// Filter bandwidth `af`, rad/s. `bandwidth * sampling_period` is at most 1.
    pub bandwidth: f64,
    /// Target rate of the path parameter `λ̇d`, 1/s.
    pub target_rate: f64,
    /// Treatment of the feedback, by which the robot returns to the path.
    pub recovery: Recovery,
}

/// The whole state of an acceleration-limited regulator: the factor and the joint speed commanded last.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccelerationState<const N: usize> {
    factor: f64,
    joint_speed: [f64; N],
}

impl<const N: usize> AccelerationState<N> {
    /// Reference and joints at rest.
    #[must_use]
    pub fn at_rest() -> Self {
        Self { factor: 0.0, joint_speed: [0.0; N] }
    }

    /// A reference already moving with `f` in [0, 1] and joints with a speed inside the limits.
    ///
    /// # Errors
    ///
    /// A factor outside [0, 1], a joint speed outside its limits, or NaN.
    pub fn moving(factor: f64, joint_speed: [f64; N], limits: &SpeedLimits<N>) -> Result<Self, ParameterError> {
        if !(0.0..=1.0).contains(&factor) {
            return Err(ParameterError::Factor(factor));
        }
        let ends = limits.lower().iter().zip(limits.upper());
        for (joint, (&value, (&lo, &up))) in joint_speed.iter().zip(ends).enumerate() {
            if !(lo <= value && value <= up) {
                return Err(ParameterError::Speed { joint, value });
            }
        }
        Ok(Self { factor, joint_speed })
    }

    /// The factor of the last sample.
    #[must_use]
    pub fn factor(&self) -> f64 {
        self.factor
    }

    /// The joint speed commanded last, rad/s.
    #[must_use]
    pub fn joint_speed(&self) -> &[f64; N] {
        &self.joint_speed
    }
}

/// Outcome of one sample: the demand is met, or not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PathKeeping {
    /// The demand is commanded as it is.
    OnPath,
    /// No factor in [0, 1] makes the demand reachable: the joints do what is nearest to it.
    LeavesPath {
        /// Largest difference of a joint's demand and its command, rad/s; times `Ts` the error this sample adds.
        excess: f64,
    },
    /// The demand is not finite: the joints brake as fast as they may, the reference stands.
    Brakes,
}

/// Output of one sample: the joint speed to command and the rate of the path parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccelerationCommand<const N: usize> {
    /// Joint speed to command, inside the speed limits and reachable from the last one.
    pub joint_speed: [f64; N],
    /// Demand at this factor, `A + f B`, rad/s.
    pub desired: [f64; N],
    /// Rate of the path parameter over this sample, `λ̇`: advance `λ` by `Ts * path_rate`.
    pub path_rate: f64,
    /// The factor `f` of this sample.
    pub factor: f64,
    /// Selection of the set-valued switch: the filter's input that leads to this factor. 1 where nothing limits, above 1 where
    /// the joints cannot slow down as fast as the path asks and the reference is pulled along.
    pub switch: f64,
    /// Outcome: the demand is met, or not.
    pub keeping: PathKeeping,
}

/// Sliding-mode regulation of the speed along a path under limits on joint speed *and* joint acceleration, implicit form.
///
/// With the previous command `p`, the demand `q̇d(f) = A + f B` and the filter step `a = af Ts`:
///
/// ```text
/// box:   max(lower, p + Ts a_lower) <= q̇ <= min(upper, p + Ts a_upper)
/// F    = { f in [0, 1] : q̇d(f) in the box } = [f_least, f_greatest]
/// f    = max(f_least, min((1 - a) f_prev + a, f_greatest))                    F not empty: on the path
/// f    = the factor in [0, f_prev] whose demand exceeds the box least         F empty: leaves the path
/// q̇    = the point of the box nearest to q̇d(f),   λ̇ = f λ̇d
/// ```
///
/// The acceleration limits bound `f` from below as well: a joint that must not slow down too fast pulls the reference along.
/// Where that end lies above what the filter allows, the limits win.
///
/// Guaranteed for any demand whatever (claim `acceleration-box`): every command lies inside the speed limits, to the last bit,
/// and differs from the last one by at most the acceleration limits times `Ts`, to one rounding. The direction of the demand is kept
/// whenever some factor allows it (claim `acceleration-factor`). After a disturbance the position loop does not overshoot under the
/// condition of claim `acceleration-recovery`.
///
/// Not guaranteed: staying on the path. No regulator that does not look ahead can: whatever speed `p ≠ 0` it has, with `|p_1|` above
/// `Ts a_1`, the path may go on without joint 1, and every point of the ray `f B` with `B_1 = 0` is out of reach.
/// [`super::LookAhead`] is the remedy; its rate goes into [`AccelerationRegulator::step_below`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccelerationRegulator<const N: usize> {
    settings: AccelerationSettings<N>,
    filter: FirstOrderFilter,
    /// Half of what a joint's speed can change in one sample: the unit of violations.
    scale: [f64; N],
}

impl<const N: usize> AccelerationRegulator<N> {
    /// Validates the settings once.
    ///
    /// # Errors
    ///
    /// See [`ParameterError`]; the limits were validated where they were made.
    pub fn new(settings: AccelerationSettings<N>) -> Result<Self, ParameterError> {
        let filter = FirstOrderFilter::new(settings.bandwidth, settings.sampling_period)?;
        positive(settings.target_rate, ParameterError::TargetRate)?;
        if let Recovery::Braking { gain } = settings.recovery {
            let step = positive(gain, ParameterError::Gain)? * settings.sampling_period;
            if !(step <= 0.5) {
                return Err(ParameterError::GainStep { step });
            }
        }
        let limits = &settings.acceleration_limits;
        let mut scale = *limits.upper();
        for (unit, lower) in scale.iter_mut().zip(limits.lower()) {
            *unit = 0.5 * settings.sampling_period * (*unit - lower);
        }
        Ok(Self { settings, filter, scale })
    }

    /// The target rate `λ̇d` at which `AffineSpeed::feedforward` is to be evaluated. Unit: 1/s.
    #[must_use]
    pub fn target_rate(&self) -> f64 {
        self.settings.target_rate
    }

    /// One sample without look-ahead.
    #[inline]
    pub fn step(&self, state: &mut AccelerationState<N>, desired: &AffineSpeed<N>) -> AccelerationCommand<N> {
        self.step_below(state, desired, self.settings.target_rate)
    }

    /// One sample with the path rate at most `ceiling`, 1/s, unless the acceleration limits demand a faster one. A ceiling that
    /// is not a number counts as 0.
    #[inline]
    pub fn step_below(
        &self,
        state: &mut AccelerationState<N>,
        desired: &AffineSpeed<N>,
        ceiling: f64,
    ) -> AccelerationCommand<N> {
        let settings = &self.settings;
        let reachable = Reachable::around(
            &state.joint_speed,
            &settings.speed_limits,
            &settings.acceleration_limits,
            settings.sampling_period,
        );
        let before = state.factor;
        let risen = self.filter.next(before, 1.0);
        if !desired.feedback.iter().chain(&desired.feedforward).all(|v| v.is_finite()) {
            *state = AccelerationState { factor: 0.0, joint_speed: reachable.slowest() };
            return self.command(state, before, *state.joint_speed(), PathKeeping::Brakes);
        }
        let desired = self.recovering(desired);
        let most = (ceiling / settings.target_rate).max(0.0);
        let factor = match Admissible::new(&desired, &reachable) {
            Some(admissible) => admissible.least.max(risen.min(most).min(admissible.greatest)),
            None => least_violation(&desired, &reachable, &self.scale, before.min(most)),
        };
        let speed = desired.at(factor);
        *state = AccelerationState { factor, joint_speed: reachable.nearest(&speed) };
        self.command(state, before, speed, keeping(&desired, factor, &speed, state.joint_speed()))
    }

    fn command(
        &self,
        state: &AccelerationState<N>,
        before: f64,
        desired: [f64; N],
        keeping: PathKeeping,
    ) -> AccelerationCommand<N> {
        AccelerationCommand {
            joint_speed: state.joint_speed,
            desired,
            path_rate: state.factor * self.settings.target_rate,
            factor: state.factor,
            switch: 1.0 - (self.filter.next(before, 1.0) - state.factor) / self.filter.step(),
            keeping,
        }
    }

    /// The demand with its feedback slowed to what the joints can brake from.
    fn recovering(&self, desired: &AffineSpeed<N>) -> AffineSpeed<N> {
        let Recovery::Braking { gain } = self.settings.recovery else { return *desired };
        let share = 1.0 - gain * self.settings.sampling_period;
        let limits = &self.settings.acceleration_limits;
        let mut scale = 1.0_f64;
        for (&a, (&lo, &up)) in desired.feedback.iter().zip(limits.lower().iter().zip(limits.upper())) {
            let (size, deceleration) = if a > 0.0 { (a, -lo) } else { (-a, up) };
            let linear = share * deceleration / gain;
            if size > linear {
                // Divided before the root: `2 size` may overflow, the ratio does not.
                let ratio = linear / size;
                scale = scale.min(libm::sqrt(ratio * (2.0 - ratio)));
            }
        }
        AffineSpeed { feedback: desired.feedback.map(|a| a * scale), feedforward: desired.feedforward }
    }
}

/// Compares a command with its demand, up to the rounding of `A + f B` and of the closed form for `f`.
///
/// The difference `limit - A` and the quotient by `B` each round once, the product and the sum again: four roundings relative to
/// the largest of `|A|`, `|f B|` and the limit, which is at most their sum. Eight halves of `EPSILON` on three terms cover
/// it twice over.
fn keeping<const N: usize>(desired: &AffineSpeed<N>, factor: f64, speed: &[f64; N], command: &[f64; N]) -> PathKeeping {
    let (mut excess, mut is_kept) = (0.0_f64, true);
    let parts = desired.feedback.iter().zip(&desired.feedforward);
    for ((&v, &c), (&a, &b)) in speed.iter().zip(command).zip(parts) {
        let difference = libm::fabs(v - c);
        let size = libm::fabs(a) + libm::fabs(factor * b) + libm::fabs(c);
        is_kept &= difference <= 4.0 * f64::EPSILON * size;
        excess = excess.max(difference);
    }
    if is_kept { PathKeeping::OnPath } else { PathKeeping::LeavesPath { excess } }
}
