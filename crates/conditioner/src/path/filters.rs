use libm::{cos, exp, sin, tan};

use super::vector::add_scaled;

/// Rule that turns the continuous filters of `[G12] eq 5, 6` into difference equations.
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
        // [G12] eq 5, its solution over one period.
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

    /// Gain of position and velocity from a unit input held over one sample: `(γ1, γ2)`, zero-order hold only.
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
        // Zero-order hold: the second state is the velocity, and 0 to the bit because `b2 = -a21` and `first` is 1.
        let second = self.a[1][0] * first + self.b[1];
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
                // [G12] eq 6, its solution over one period.
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

    /// Gain of the integral over one sample.
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

    /// Naive twin: the zero-order hold of the step response, position and velocity, against its closed form.
    #[test]
    fn zero_order_hold_is_exact_at_the_samples() {
        let (alpha, period) = (20.0_f64, 0.01);
        let s = alpha / libm::sqrt(2.0);
        let filter = PushFilter::new(alpha, period, Discretisation::ZeroOrderHold);
        let mut state = filter.resting(&[0.0]);
        for k in 1..50_u32 {
            filter.advance(&mut state, &[1.0]);
            let t = f64::from(k) * period;
            let position = 1.0 - exp(-s * t) * (cos(s * t) + sin(s * t));
            let velocity = 2.0 * s * exp(-s * t) * sin(s * t);
            // 50 products of numbers below 1, of the velocity below 10 times as much: some 50 roundings each.
            assert!((filter.output(&state, &[1.0])[0] - position).abs() < 1e-14);
            assert!((state.second[0] - velocity).abs() < 1e-13);
            if k == 1 {
                assert_eq!(filter.reach(), [state.first[0], state.second[0]]);
            }
        }
    }

    /// Half the step of the trapezoidal rule that Tustin's rule amounts to when it is prewarped at the cutoff.
    fn half_step(cutoff: f64, period: f64) -> f64 {
        tan(0.5 * cutoff * period) / cutoff
    }

    /// An input that does not repeat itself soon and is neither 0 nor 1.
    fn ragged(k: u32) -> f64 {
        f64::from(k * k % 7) - 2.3
    }

    /// Naive twin: the trapezoidal rule on `f̈ = -√2 α ḟ + α² (u - f)`, its two equations solved by Cramer's rule.
    #[test]
    fn prewarped_tustin_is_the_trapezoidal_rule_on_the_push_filter() {
        let (alpha, period) = (20.0, 0.01);
        let half = half_step(alpha, period);
        let (stiffness, damping) = (alpha * alpha, libm::sqrt(2.0) * alpha);
        let filter = PushFilter::new(alpha, period, Discretisation::PrewarpedTustin);
        let mut state = filter.resting(&[0.0, 0.0]);
        let (mut f, mut rate, mut before) = (0.0, 0.0, 0.0);
        for k in 0..50 {
            let u = ragged(k);
            // f' - half ḟ' = p and half α² f' + (1 + half √2 α) ḟ' = q, primes for the new values.
            let p = f + half * rate;
            let q = rate + half * (stiffness * (before + u - f) - damping * rate);
            let (left, right) = (half * stiffness, 1.0 + half * damping);
            let determinant = right + half * left;
            (f, rate, before) = ((right * p + half * q) / determinant, (q - left * p) / determinant, u);
            let output = filter.output(&state, &[u, -2.0 * u]);
            // Numbers below 5, and a filter that forgets within some 10 samples: a few tens of roundings.
            assert!((output[0] - f).abs() < 1e-13 && (output[1] + 2.0 * f).abs() < 2e-13, "{output:?}, {f} at {k}");
            filter.advance(&mut state, &[u, -2.0 * u]);
        }
    }

    #[test]
    fn prewarping_keeps_gain_and_phase_at_the_cutoff() {
        // eq 5 at s = jα: 1 / (√2 j). A sine comes out as -cos / √2, however coarse the sampling.
        for period in [1e-3, 0.05] {
            let alpha = 20.0;
            let filter = PushFilter::new(alpha, period, Discretisation::PrewarpedTustin);
            let mut state = filter.resting(&[0.0]);
            for k in 0..5000_u32 {
                let angle = alpha * period * f64::from(k);
                let output = filter.output(&state, &[sin(angle)])[0];
                // After 4 s the transient has died to exp(-56); the angle of up to 5000 rad carries 1e-12 of rounding.
                let exact = -cos(angle) / libm::sqrt(2.0);
                assert!(angle < 80.0 || (output - exact).abs() < 2e-12, "{output}, {exact}");
                filter.advance(&mut state, &[sin(angle)]);
            }
        }
    }

    #[test]
    fn a_held_input_moves_the_rate_and_its_integral_by_the_closed_form() {
        let (alpha, period, start, input) = (20.0, 0.01, 0.3, -0.7);
        let filter = RateFilter::new(alpha, period, Discretisation::ZeroOrderHold);
        let (mut memory, mut integral) = (filter.resting(start), 0.0);
        for k in 1..50_u32 {
            integral += filter.gained(memory, input);
            memory = filter.next(memory, input);
            let t = f64::from(k) * period;
            // y = u + (y0 - u) exp(-α t), and its integral. Some 50 roundings of numbers below 1.
            let faded = (start - input) * exp(-alpha * t);
            assert!((filter.rate(memory, input) - (input + faded)).abs() < 1e-14);
            assert!((integral - (input * t + (start - input - faded) / alpha)).abs() < 1e-14);
        }
    }

    /// Naive twin: the trapezoidal rule on `ẏ = α (u - y)`; the integral holds the rate over the sample.
    #[test]
    fn prewarped_tustin_is_the_trapezoidal_rule_on_the_rate() {
        let (alpha, period) = (20.0, 0.01);
        let c = half_step(alpha, period) * alpha;
        let filter = RateFilter::new(alpha, period, Discretisation::PrewarpedTustin);
        let (mut memory, mut rate, mut before) = (filter.resting(0.4), 0.4, 0.4);
        for k in 0..50 {
            let u = ragged(k);
            (rate, before) = ((rate * (1.0 - c) + c * (before + u)) / (1.0 + c), u);
            // Numbers below 5, and a filter that forgets within some 10 samples: a few tens of roundings.
            assert!((filter.rate(memory, u) - rate).abs() < 1e-13);
            assert!((filter.gained(memory, u) - period * rate).abs() < 1e-15);
            memory = filter.next(memory, u);
        }
    }

    #[test]
    fn a_resting_rate_stays_what_it_is() {
        for scheme in [Discretisation::ZeroOrderHold, Discretisation::PrewarpedTustin] {
            let filter = RateFilter::new(20.0, 0.01, scheme);
            let memory = filter.resting(0.3);
            assert!((filter.rate(memory, 0.3) - 0.3).abs() < 1e-15);
            assert!((filter.next(memory, 0.3) - memory).abs() < 1e-15);
            assert!((filter.gained(memory, 0.3) - 0.003).abs() < 1e-15);
        }
    }

    #[test]
    fn a_cutoff_at_the_nyquist_frequency_is_too_fast() {
        // π / T: 314.16 rad/s at 10 ms. The tangent of the prewarping has its pole there.
        assert!(below_nyquist(314.0, 0.01) && below_nyquist(3.1, 1.0));
        assert!(!below_nyquist(315.0, 0.01) && !below_nyquist(core::f64::consts::PI, 1.0));
        assert!(!below_nyquist(f64::NAN, 1.0));
    }
}
