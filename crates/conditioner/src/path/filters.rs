use libm::{cos, exp, sin, tan};

use super::vector::add_scaled;

/// How the continuous filters of `[G12] eq 5, 6` become difference equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Discretisation {
    /// Exact for an input held over the sample.
    ZeroOrderHold,
    /// The appendix's `butter`: Tustin's rule, prewarped at the cutoff frequency. The input feeds through at once.
    PrewarpedTustin,
}

/// Second-order Butterworth low-pass filter of `[G12] eq 5` in state-space form, one input per coordinate.
///
/// ```text
/// x[k+1] = A x[k] + b u[k]       y[k] = x1[k] + d u[k]
/// ```
///
/// Under zero-order hold `x = (f, ḟ)` and `d = 0`; under Tustin's rule `x` is the transposed direct form's memory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PushFilter {
    a: [[f64; 2]; 2],
    b: [f64; 2],
    feedthrough: f64,
}

/// Memory of a [`PushFilter`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PushState<const N: usize> {
    pub(crate) first: [f64; N],
    pub(crate) second: [f64; N],
}

impl PushFilter {
    pub(crate) fn new(cutoff: f64, period: f64, discretisation: Discretisation) -> Self {
        match discretisation {
            Discretisation::ZeroOrderHold => Self::zero_order_hold(cutoff, period),
            Discretisation::PrewarpedTustin => Self::prewarped_tustin(cutoff, period),
        }
    }

    /// With `s = α/√2` the poles are `-s ± j s`, so `exp(A T)` is a decaying rotation.
    fn zero_order_hold(cutoff: f64, period: f64) -> Self {
        let s = cutoff / core::f64::consts::SQRT_2;
        let (decay, c, n) = (exp(-s * period), cos(s * period), sin(s * period));
        let a = [[decay * (c + n), decay * n / s], [-2.0 * s * decay * n, decay * (c - n)]];
        Self { b: [1.0 - a[0][0], -a[1][0]], a, feedthrough: 0.0 }
    }

    fn prewarped_tustin(cutoff: f64, period: f64) -> Self {
        let c = tan(0.5 * cutoff * period);
        let damping = core::f64::consts::SQRT_2 * c;
        let scale = 1.0 / (1.0 + damping + c * c);
        let (b0, a1, a2) = (c * c * scale, 2.0 * (c * c - 1.0) * scale, (1.0 - damping + c * c) * scale);
        Self { a: [[-a1, 1.0], [-a2, 0.0]], b: [2.0 * b0 - a1 * b0, b0 - a2 * b0], feedthrough: b0 }
    }

    /// What an input held over one sample adds to position and velocity: `(γ1, γ2)`, zero-order hold only.
    pub(crate) fn reach(&self) -> [f64; 2] {
        self.b
    }

    #[inline(always)]
    pub(crate) fn output<const N: usize>(&self, state: &PushState<N>, input: &[f64; N]) -> [f64; N] {
        add_scaled(&state.first, self.feedthrough, input)
    }

    #[inline(always)]
    pub(crate) fn advance<const N: usize>(&self, state: &mut PushState<N>, input: &[f64; N]) {
        let [[a11, a12], [a21, a22]] = self.a;
        let [b1, b2] = self.b;
        for ((x, y), u) in state.first.iter_mut().zip(&mut state.second).zip(input) {
            (*x, *y) = (a11 * *x + a12 * *y + b1 * u, a21 * *x + a22 * *y + b2 * u);
        }
    }

    /// The memory of a filter that has rested at `output`.
    pub(crate) fn resting<const N: usize>(&self, output: &[f64; N]) -> PushState<N> {
        // At rest with unit gain the input equals the output, and x = A x + b u.
        let first = 1.0 - self.feedthrough;
        let second = self.a[1][0] * first + self.b[1];
        // Zero-order hold: the second state is the velocity, and 0 only up to rounding when computed so.
        let second = if self.feedthrough == 0.0 { 0.0 } else { second };
        PushState { first: output.map(|y| first * y), second: output.map(|y| second * y) }
    }
}

/// First-order low-pass filter with an integrator behind it: the walk of `[G12] eq 6` and the pace of the reference.
///
/// The state is `(integral, x)`, the filtered rate `y = x + d u`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RateFilter {
    pole: f64,
    gain: f64,
    feedthrough: f64,
    from_rate: f64,
    from_input: f64,
}

impl RateFilter {
    pub(crate) fn new(cutoff: f64, period: f64, discretisation: Discretisation) -> Self {
        match discretisation {
            Discretisation::ZeroOrderHold => {
                let gain = -libm::expm1(-cutoff * period);
                let memory = gain / cutoff;
                Self { pole: 1.0 - gain, gain, feedthrough: 0.0, from_rate: memory, from_input: period - memory }
            }
            Discretisation::PrewarpedTustin => {
                let c = tan(0.5 * cutoff * period);
                let (b, a) = (c / (1.0 + c), (c - 1.0) / (c + 1.0));
                Self { pole: -a, gain: b - a * b, feedthrough: b, from_rate: period, from_input: period * b }
            }
        }
    }

    /// The filtered rate with this input.
    #[inline(always)]
    pub(crate) fn rate(&self, memory: f64, input: f64) -> f64 {
        memory + self.feedthrough * input
    }

    /// What the integral gains over one sample.
    #[inline(always)]
    pub(crate) fn gained(&self, memory: f64, input: f64) -> f64 {
        self.from_rate * memory + self.from_input * input
    }

    #[inline(always)]
    pub(crate) fn next(&self, memory: f64, input: f64) -> f64 {
        self.pole * memory + self.gain * input
    }

    /// The memory of a filter that has rested at `rate`.
    pub(crate) fn resting(&self, rate: f64) -> f64 {
        rate * (1.0 - self.feedthrough)
    }
}

/// A cutoff that Tustin's rule can be prewarped at lies below the Nyquist frequency.
pub(crate) fn below_nyquist(cutoff: f64, period: f64) -> bool {
    cutoff * period < core::f64::consts::PI
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settle(filter: &PushFilter, samples: u32) -> f64 {
        let mut state = filter.resting(&[0.0]);
        for _ in 0..samples {
            filter.advance(&mut state, &[1.0]);
        }
        filter.output(&state, &[1.0])[0]
    }

    #[test]
    fn both_discretisations_have_unit_gain() {
        for scheme in [Discretisation::ZeroOrderHold, Discretisation::PrewarpedTustin] {
            // 20 rad/s over 5 s: the transient has died to exp(-70).
            assert!((settle(&PushFilter::new(20.0, 1e-3, scheme), 5000) - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_resting_filter_stays_where_it_is() {
        for scheme in [Discretisation::ZeroOrderHold, Discretisation::PrewarpedTustin] {
            let filter = PushFilter::new(20.0, 1e-3, scheme);
            let mut state = filter.resting(&[0.3]);
            filter.advance(&mut state, &[0.3]);
            assert!((filter.output(&state, &[0.3])[0] - 0.3).abs() < 1e-15);
        }
    }

    /// Naive twin: the zero-order hold of the step response against the closed form at one time.
    #[test]
    fn zero_order_hold_is_exact_at_the_samples() {
        let (alpha, period) = (20.0_f64, 0.01);
        let s = alpha / libm::sqrt(2.0);
        for k in 1..50_u32 {
            let t = f64::from(k) * period;
            let exact = 1.0 - exp(-s * t) * (cos(s * t) + sin(s * t));
            // 50 products of numbers below 1: some 50 roundings.
            assert!((settle(&PushFilter::zero_order_hold(alpha, period), k) - exact).abs() < 1e-14);
        }
    }
}
