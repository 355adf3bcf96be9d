use crate::MotionError;

/// Where the derivative of the error comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Derivative {
    /// From the error itself, through a first-order filter of this bandwidth, rad/s.
    Filtered {
        /// Bandwidth, rad/s.
        bandwidth: f64,
    },
    /// Given with the error: a difference of measured speeds.
    Measured,
}

/// Settings of a [`Pid`]. The unit of the output is that of `proportional` times that of the error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PidSettings {
    /// Gain of the error.
    pub proportional: f64,
    /// Gain of its integral, per s.
    pub integral: f64,
    /// Gain of its derivative, s.
    pub derivative: f64,
    /// Where the derivative comes from.
    pub derivative_from: Derivative,
    /// Largest output, in both directions.
    pub largest: f64,
    /// Sampling period, s.
    pub sampling_period: f64,
}

/// State of a [`Pid`] from one sample to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PidState {
    integral: f64,
    filtered: f64,
    last_error: Option<f64>,
}

impl PidState {
    /// The integral part of the output.
    #[must_use]
    pub fn integral(&self) -> f64 {
        self.integral
    }
}

/// Proportional, integral and derivative feedback of one axis, with a filtered derivative and anti-windup.
///
/// ```text
/// u = clamp(Kp e + I + D),   I' = I + Ki T e unless that pushes further into the limit,   |I| <= largest
/// D' = (D + Kd ω (e - e_before)) / (1 + ω T)          (implicit Euler of the filtered derivative)
/// ```
///
/// Guaranteed: output and integral never exceed `largest`, whatever the errors. A NaN or an infinity puts out 0 and leaves the
/// state as it was: no push is the safest guess of a controller that does not know.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pid {
    settings: PidSettings,
}

impl Pid {
    /// Accepts gains that are not negative, and a positive limit, period and bandwidth; all finite.
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`] with the first refused.
    pub fn new(settings: PidSettings) -> Result<Self, MotionError> {
        let bandwidth = match settings.derivative_from {
            Derivative::Filtered { bandwidth } => bandwidth,
            Derivative::Measured => 1.0,
        };
        for (name, value) in [
            ("proportional", settings.proportional),
            ("integral", settings.integral),
            ("derivative", settings.derivative),
        ] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(MotionError::Setting { name, value });
            }
        }
        for (name, value) in
            [("largest", settings.largest), ("sampling_period", settings.sampling_period), ("bandwidth", bandwidth)]
        {
            if !(value > 0.0 && value.is_finite()) {
                return Err(MotionError::Setting { name, value });
            }
        }
        Ok(Self { settings })
    }

    /// The settings.
    #[must_use]
    pub fn settings(&self) -> &PidSettings {
        &self.settings
    }

    /// One sample: the output for an error (reference minus measurement) and its rate. The rate only counts under
    /// [`Derivative::Measured`].
    pub fn step(&self, state: &mut PidState, error: f64, rate: f64) -> f64 {
        let s = &self.settings;
        let (derivative, filtered) = self.derivative(state, error, rate);
        let integral = (state.integral + s.integral * s.sampling_period * error).clamp(-s.largest, s.largest);
        let output = s.proportional * error + integral + derivative;
        if !output.is_finite() {
            return 0.0;
        }
        let winds_up = output.abs() > s.largest && (integral - state.integral) * output > 0.0;
        let integral = if winds_up { state.integral } else { integral };
        *state = PidState { integral, filtered, last_error: Some(error) };
        (s.proportional * error + integral + derivative).clamp(-s.largest, s.largest)
    }

    /// The derivative part of the output, and the filter's next state.
    fn derivative(&self, state: &PidState, error: f64, rate: f64) -> (f64, f64) {
        let s = &self.settings;
        match s.derivative_from {
            Derivative::Measured => (s.derivative * rate, 0.0),
            Derivative::Filtered { bandwidth } => {
                // The first sample has no one before it: no kick.
                let change = error - state.last_error.unwrap_or(error);
                let next = (state.filtered + s.derivative * bandwidth * change) / (1.0 + bandwidth * s.sampling_period);
                (next, next)
            }
        }
    }
}
