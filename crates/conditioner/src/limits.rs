use crate::error::ParameterError;

/// Joint-speed limits, lower and upper, not necessarily symmetric. Unit: rad/s (m/s for a prismatic joint).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedLimits<const N: usize> {
    lower: [f64; N],
    upper: [f64; N],
}

/// Rule that brings a joint-speed vector beyond the limits back inside them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Saturation {
    /// Each joint on its own, `[G11] eq 6`. The tool leaves its direction of motion.
    Direct,
    /// All joints by one factor, `[G11] eq 7-8`. The direction of motion is kept.
    DirectionPreserving,
}

/// A joint-speed vector after saturation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Saturated<const N: usize> {
    /// Joint speed to command: inside the limits, to the last bit.
    pub joint_speed: [f64; N],
    /// The factor `fdir` of `[G11] eq 8`, in [0, 1]; 0 where the input was not finite. It is
    /// reported for both kinds of saturation and applied by the direction-preserving one.
    pub direction_factor: f64,
}

impl<const N: usize> SpeedLimits<N> {
    /// Lower and upper limits, joint by joint.
    ///
    /// # Errors
    ///
    /// A lower limit that is not negative and finite, or an upper one that is not positive and finite.
    pub fn new(lower: [f64; N], upper: [f64; N]) -> Result<Self, ParameterError> {
        for (joint, (&lo, &up)) in lower.iter().zip(&upper).enumerate() {
            if !(lo < 0.0 && lo.is_finite()) {
                return Err(ParameterError::LowerLimit { joint, value: lo });
            }
            if !(up > 0.0 && up.is_finite()) {
                return Err(ParameterError::UpperLimit { joint, value: up });
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
                return Err(ParameterError::UpperLimit { joint, value });
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

    /// True if every joint speed lies inside its limits, ends included. NaN lies outside.
    #[inline]
    #[must_use]
    pub fn contain(&self, joint_speed: &[f64; N]) -> bool {
        // [G11] eq 18: `q̇ds - q̇d` is zero just here. [G11] eq 20: on the surfaces an inequality turns into an equation.
        joint_speed.iter().zip(self.lower.iter().zip(&self.upper)).all(|(&v, (&lo, &up))| lo <= v && v <= up)
    }

    /// The use of one joint's limit: `v / upper` forwards, `v / lower` backwards. NaN stays NaN.
    #[inline]
    fn joint_ratio(v: f64, lower: f64, upper: f64) -> f64 {
        if v < 0.0 { v / lower } else { v / upper }
    }

    /// The largest use of a limit, `‖F_N q̇‖∞` of `[G11] eq 8`, extended to asymmetric limits. Unit: 1.
    ///
    /// Infinite if any joint speed is NaN, so that a comparison with 1 fails safe.
    #[inline]
    #[must_use]
    pub fn ratio(&self, joint_speed: &[f64; N]) -> f64 {
        let mut largest = 0.0_f64;
        for (&v, (&lo, &up)) in joint_speed.iter().zip(self.lower.iter().zip(&self.upper)) {
            let ratio = Self::joint_ratio(v, lo, up);
            if ratio.is_nan() {
                return f64::INFINITY;
            }
            largest = largest.max(ratio);
        }
        largest
    }

    /// The joint that uses most of its limit, counted from 0; `None` if a joint speed is NaN or all stand still.
    #[must_use]
    pub fn limiting_joint(&self, joint_speed: &[f64; N]) -> Option<usize> {
        let mut best = None;
        let mut largest = 0.0;
        for (joint, (&v, (&lo, &up))) in joint_speed.iter().zip(self.lower.iter().zip(&self.upper)).enumerate() {
            let ratio = Self::joint_ratio(v, lo, up);
            if ratio.is_nan() {
                return None;
            }
            if ratio > largest {
                largest = ratio;
                best = Some(joint);
            }
        }
        best
    }

    /// Brings a joint-speed vector inside the limits; one that is not finite becomes a standstill.
    #[inline]
    #[must_use]
    pub fn saturate(&self, joint_speed: &[f64; N], saturation: Saturation) -> Saturated<N> {
        if !joint_speed.iter().all(|v| v.is_finite()) {
            return Saturated { joint_speed: [0.0; N], direction_factor: 0.0 };
        }
        let ratio = self.ratio(joint_speed);
        // [G11] eq 8
        let direction_factor = if ratio > 1.0 { 1.0 / ratio } else { 1.0 };
        let factor = match saturation {
            Saturation::Direct => 1.0,
            Saturation::DirectionPreserving => direction_factor,
        };
        let mut command = *joint_speed;
        // Scaling can end one rounding beyond the limit, hence the clamp for both kinds. Not f64::clamp: it can panic.
        for (v, (&lo, &up)) in command.iter_mut().zip(self.lower.iter().zip(&self.upper)) {
            // [G11] eq 6: the clamp; [G11] eq 7: the factor.
            *v = (*v * factor).max(lo).min(up);
        }
        Saturated { joint_speed: command, direction_factor }
    }

    /// The largest `f` in [0, 1] with `constant + f * slope` inside the limits; `None` if `constant` itself lies
    /// outside or any number is not finite.
    ///
    /// Each joint allows `f <= (bound - constant) / slope` with the bound it moves towards. The limits are convex, so
    /// every smaller `f` is inside as well.
    #[inline]
    #[must_use]
    pub fn largest_factor(&self, constant: &[f64; N], slope: &[f64; N]) -> Option<f64> {
        if !self.contain(constant) {
            return None;
        }
        let mut largest = 1.0_f64;
        for ((&c, &s), (&lo, &up)) in constant.iter().zip(slope).zip(self.lower.iter().zip(&self.upper)) {
            if !s.is_finite() {
                return None;
            }
            let room = if s > 0.0 { up - c } else { lo - c };
            if s != 0.0 {
                largest = largest.min(room / s);
            }
        }
        Some(largest)
    }
}
