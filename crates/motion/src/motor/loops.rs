use super::{Delay, DelayLine, Winding};
use crate::MotionError;
use crate::error::{not_negative, positive, setting};

/// Command to a motor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MotorCommand {
    /// A torque at the joint, N·m (N).
    Torque(f64),
    /// A speed at the joint, per s, for the motor's own speed loop.
    Speed(f64),
}

/// Settings of a [`Motor`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorSettings {
    /// Torque at the joint per current, torque constant times gear ratio, N·m/A (N/A); any sign, not zero.
    pub torque_per_current: f64,
    /// Largest current of the amplifier, A.
    pub largest_current: f64,
    /// Current that may flow for ever, A.
    pub continuous_current: f64,
    /// Thermal time constant of the winding, s.
    pub thermal_time: f64,
    /// Bandwidth of the current loop, rad/s.
    pub current_bandwidth: f64,
    /// Gain of the speed loop, torque at the joint per speed, N·m·s/rad (N·s/m).
    pub speed_gain: f64,
    /// Time in which the speed loop's integral grows as large as its proportional part, s.
    pub speed_integral_time: f64,
    /// Delay from command to current, samples.
    pub delay: usize,
    /// Sampling period of the loops, s.
    pub sampling_period: f64,
}

/// State of a [`Motor`] from one sample to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorState {
    current: f64,
    integral: f64,
    heat: f64,
    line: DelayLine<MotorCommand>,
}

impl MotorState {
    /// Cold, without current, told to give no torque.
    #[must_use]
    pub fn cold() -> Self {
        Self { current: 0.0, integral: 0.0, heat: 0.0, line: DelayLine::filled(MotorCommand::Torque(0.0)) }
    }

    /// Current, A.
    #[must_use]
    pub fn current(&self) -> f64 {
        self.current
    }

    /// Rise of the winding's temperature over the rise that is allowed, in [0, 1].
    #[must_use]
    pub fn heat(&self) -> f64 {
        self.heat
    }
}

/// One sample of a motor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorOutput {
    /// Torque at the joint, N·m (N).
    pub torque: f64,
    /// True if the current was cut, by the amplifier or by the heat.
    pub cut: bool,
}

/// A motor with its amplifier, from command to torque at the joint.
///
/// ```text
/// w = delayed command
/// t = w (torque),  or Ks (w - v) + I,  I' = I + Ks T / Ti (w - v) unless that winds up (speed)
/// i' = clamp(i + β (t / kt - i)),  β = 1 - exp(-ωi T)          |i| <= amplifier, and what the heat allows
/// ```
///
/// Guaranteed: the current stays inside the amplifier's and the winding never rises above its rated temperature, whatever
/// is commanded. A command or a speed that is not finite asks for no current.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motor {
    settings: MotorSettings,
    winding: Winding,
    delay: Delay,
    /// `β`.
    share: f64,
}

impl Motor {
    /// A motor with such settings.
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`] with the first setting out of its range.
    pub fn new(settings: MotorSettings) -> Result<Self, MotionError> {
        let s = &settings;
        setting(
            "torque_per_current",
            s.torque_per_current,
            s.torque_per_current != 0.0 && s.torque_per_current.is_finite(),
        )?;
        positive("largest_current", s.largest_current)?;
        positive("current_bandwidth", s.current_bandwidth)?;
        not_negative("speed_gain", s.speed_gain)?;
        positive("speed_integral_time", s.speed_integral_time)?;
        let winding = Winding::new(s.continuous_current, s.thermal_time, s.sampling_period)?;
        let share = -(-s.current_bandwidth * s.sampling_period).exp_m1();
        Ok(Self { settings, winding, delay: Delay::new(s.delay)?, share })
    }

    /// Torque at the joint that the amplifier allows while the winding is cold, N·m (N).
    #[must_use]
    pub fn largest_torque(&self) -> f64 {
        (self.settings.torque_per_current * self.settings.largest_current).abs()
    }

    /// One sample: the torque for a command at the joint's measured speed.
    pub fn step(&self, state: &mut MotorState, command: MotorCommand, speed: f64) -> MotorOutput {
        let s = &self.settings;
        let (torque, integral) = match self.delay.step(&mut state.line, command) {
            MotorCommand::Torque(torque) => (torque, 0.0),
            MotorCommand::Speed(wanted) => self.speed_loop(state.integral, wanted - speed),
        };
        let wanted = state.current + self.share * (torque / s.torque_per_current - state.current);
        let wanted = if wanted.is_finite() { wanted } else { 0.0 };
        let largest = s.largest_current.min(self.winding.largest_current(state.heat));
        let current = wanted.clamp(-largest, largest);
        state.heat = self.winding.after(state.heat, current);
        state.integral = integral;
        state.current = current;
        MotorOutput { torque: current * s.torque_per_current, cut: wanted != current }
    }

    /// Torque asked for by the speed loop, and its next integral.
    fn speed_loop(&self, integral: f64, error: f64) -> (f64, f64) {
        let s = &self.settings;
        let most = self.largest_torque();
        let next = integral + s.speed_gain * s.sampling_period / s.speed_integral_time * error;
        let torque = s.speed_gain * error + next;
        if !torque.is_finite() {
            return (0.0, integral);
        }
        let winds_up = torque.abs() > most && (next - integral) * torque > 0.0;
        let kept = if winds_up { integral } else { next.clamp(-most, most) };
        (s.speed_gain * error + kept, kept)
    }
}
