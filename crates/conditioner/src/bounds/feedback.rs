use libm::sqrt;

/// A controller in joint space, `q̇d = q_d'(λ) f λ̇d + Kp (q_d(λ) - q)`, on a path whose shape is known by four numbers.
///
/// Limits are counted joint by joint: `w_i` is the smaller of joint `i`'s two speed limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FeedbackLoop {
    /// Filter step `a = af Ts`, in (0, 1].
    pub filter_step: f64,
    /// Gain `Kp` of the position error, 1/s; `Kp Ts <= 1`.
    pub gain: f64,
    /// Sampling period `Ts`, s.
    pub sampling_period: f64,
    /// Target rate `λ̇d`, 1/s.
    pub target_rate: f64,
    /// Largest path rate the limits allow anywhere on the path, `λ̇*max`, 1/s.
    pub path_rate_max: f64,
    /// Largest overspeed `g_max`: the largest use of a limit by `q_d'(λ) λ̇d`.
    pub overspeed_max: f64,
    /// Curvature of the joint path in limits, `C = max_i sup |q_d,i''| / w_i`, s per square unit of λ.
    pub curvature: f64,
    /// Largest initial lag in limits, `max_i Kp |q_d,i - q_i| / w_i`; 0 on the path.
    pub initial_lag: f64,
}

/// Bounds that a [`FeedbackLoop`] keeps for ever, in the synchronised form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FeedbackBand {
    /// `E`: at every sample `Kp |q_d,i(λ) - q_i| <= E w_i`, so joint `i` lags by at most `E w_i / Kp`.
    pub lag: f64,
    /// `P`: the requested rate `f λ̇d` never exceeds it, 1/s.
    pub requested_rate: f64,
    /// `ρ`: the path rate `fdir f λ̇d` never exceeds it, 1/s.
    pub path_rate: f64,
    /// `M`: the largest use of a limit, `‖F_N q̇d‖∞ <= M`.
    pub limit_ratio: f64,
}

/// Lag and largest `m` on a curved path with feedback, synchronised form (claim `drift-with-feedback`).
///
/// ```text
/// x = C Ts / 2
/// ρ = min(λ̇d, (1 + E) λ̇*max),   P = min(λ̇d, (1 - a) ρ + a λ̇d),   E >= x ρ P   (the smallest such E that is not below the initial lag)
/// R = Kp Ts x ρ²
/// M = max((1 - a)(1 + 2 x ρ²) + a g_max + |a - Kp Ts| E + R,   ((1 - a) 2 x ρ P + max(a, Kp Ts) E + R) / a)
/// ```
///
/// Hypotheses: [`super::super::Advance::Synchronised`], direction-preserving saturation, `m[0] <= M`, `f[0] λ̇d <= P` (both hold for a
/// start at rest, whatever the lag). There is no reaching condition: a path that drifts faster than the filter falls
/// widens the band instead. `None` if a number is out of its range or NaN.
///
/// Not covered: the paper's advance, in which every saturated sample adds to the lag; controllers that invert the Jacobian at
/// the robot's own position, which agree with this one to first order in the lag only.
#[must_use]
pub fn drifting_band_with_feedback(system: &FeedbackLoop) -> Option<FeedbackBand> {
    let FeedbackLoop { filter_step: a, gain, sampling_period, target_rate, .. } = *system;
    let gain_step = gain * sampling_period;
    let in_range = 0.0 < a && a <= 1.0 && 0.0 <= gain && 0.0 < sampling_period && gain_step <= 1.0 && 0.0 < target_rate;
    let path_in_range = system.path_rate_max > 0.0 && system.overspeed_max >= 0.0 && system.curvature >= 0.0;
    if !(in_range && path_in_range && system.initial_lag >= 0.0) {
        return None;
    }
    // Some thirty roundings; one part in 1e13 is added to whatever bounds from above.
    let half = 0.5 * system.curvature * sampling_period * (1.0 + 1e-13);
    let lag = system.lag(half);
    let (rate, requested) = system.rates(lag);
    let rest = gain_step * half * rate * rate;
    let released = (1.0 - a) * (1.0 + 2.0 * half * rate * rate) + a * system.overspeed_max;
    let released = released + (a - gain_step).abs() * lag + rest;
    let braked = ((1.0 - a) * 2.0 * half * rate * requested + a.max(gain_step) * lag + rest) / a;
    let ratio = released.max(braked) * (1.0 + 1e-13);
    ratio.is_finite().then_some(FeedbackBand { lag, requested_rate: requested, path_rate: rate, limit_ratio: ratio })
}

impl FeedbackLoop {
    /// `ρ` and `P` for a lag of at most `lag`.
    fn rates(&self, lag: f64) -> (f64, f64) {
        let rate = self.target_rate.min((1.0 + lag) * self.path_rate_max);
        (rate, self.target_rate.min((1.0 - self.filter_step) * rate + self.filter_step * self.target_rate))
    }

    /// The smallest `E` that is not below the initial lag and has `half ρ(E) P(E) <= E`.
    ///
    /// With `y = 1 + E` and neither minimum at work that is a quadratic, `A y² - (1 - B) y + 1 <= 0`; with both at work,
    /// `E = half λ̇d²`. They are at work together, for `ρ = λ̇d` exactly where `P = λ̇d`.
    fn lag(&self, half: f64) -> f64 {
        let (a, slow) = (self.filter_step, self.path_rate_max);
        let keeps = |lag: f64| {
            let (rate, requested) = self.rates(lag);
            half * rate * requested <= lag
        };
        if keeps(self.initial_lag) {
            return self.initial_lag;
        }
        let square = half * slow * slow * (1.0 - a);
        let linear = 1.0 - half * slow * a * self.target_rate;
        let root = 2.0 / (linear + sqrt(linear * linear - 4.0 * square)) - 1.0;
        // The root itself is rounded. No root (NaN), the root below -1 of a negative linear term, and a start beyond the larger root leave
        // the bound that always holds.
        let root = root + 1e-13 * (1.0 + root);
        let always = half * self.target_rate * self.target_rate;
        if root >= self.initial_lag && keeps(root) { root.min(always) } else { always }
    }
}
