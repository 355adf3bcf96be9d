//! Random joint paths of three joints whose slope and curvature are known in closed form.

use std::array::from_fn;

use slideway_conditioner::SpeedLimits;

use crate::engine::Choices;

/// `q_i(λ) = w_i (b_i λ + Σ_j (d_ij / ω_j) sin(ω_j λ + ψ_ij))`, in which the first joint never turns back: `b_0 > Σ_j d_0j`.
#[derive(Clone, Copy, Debug)]
pub struct JointPath {
    /// The smaller speed limit of each joint, `w_i`, rad/s.
    pub limit: [f64; 3],
    drift: [f64; 3],
    swing: [[f64; 2]; 3],
    frequency: [f64; 2],
    phase: [[f64; 2]; 3],
}

impl JointPath {
    /// Slopes of about `slope` (in limits, s); frequencies from slow to some radians in ten `period`s at the rate `1 / slope`.
    pub fn draw(choices: &mut Choices, limits: &SpeedLimits<3>, slope: f64, period: f64) -> Self {
        let limit = from_fn(|i| limits.upper()[i].min(-limits.lower()[i]));
        let shares: [[f64; 2]; 3] = from_fn(|_| choices.numbers(0.0, 0.45));
        let scale = [1.0, 2.0 * choices.unit(), 2.0 * choices.unit()];
        let drift =
            [slope, choices.between(-1.0, 1.0) * slope * scale[1], choices.between(-1.0, 1.0) * slope * scale[2]];
        let swing = from_fn(|i| shares[i].map(|share| share * slope * scale[i]));
        let frequency = from_fn(|_| choices.decade(-4.0, -0.5) * slope / period);
        Self { limit, drift, swing, frequency, phase: from_fn(|_| choices.numbers(0.0, std::f64::consts::TAU)) }
    }

    fn sum(&self, i: usize, term: impl Fn(f64, f64, f64) -> f64) -> f64 {
        (0..2).map(|j| term(self.swing[i][j], self.frequency[j], self.phase[i][j])).sum()
    }

    /// `q(λ)`, rad.
    #[must_use]
    pub fn position(&self, at: f64) -> [f64; 3] {
        from_fn(|i| self.limit[i] * (self.drift[i] * at + self.sum(i, |d, w, p| d / w * (w * at + p).sin())))
    }

    /// `q'(λ)`, rad.
    #[must_use]
    pub fn slope(&self, at: f64) -> [f64; 3] {
        from_fn(|i| self.limit[i] * (self.drift[i] + self.sum(i, |d, w, p| d * (w * at + p).cos())))
    }

    /// `max_i sup |q_i'| / w_i`, s.
    #[must_use]
    pub fn slope_max(&self) -> f64 {
        (0..3).map(|i| self.drift[i].abs() + self.sum(i, |d, _, _| d)).fold(0.0, f64::max)
    }

    /// `max_i sup |q_i''| / w_i`, s.
    #[must_use]
    pub fn curvature(&self) -> f64 {
        (0..3).map(|i| self.sum(i, |d, w, _| d * w)).fold(0.0, f64::max)
    }

    /// The path rate is nowhere allowed to be larger, by the first joint alone, 1/s.
    #[must_use]
    pub fn rate_max(&self, limits: &SpeedLimits<3>) -> f64 {
        limits.upper()[0] / (self.limit[0] * (self.drift[0] - self.sum(0, |d, _, _| d)))
    }

    /// Sum of the sizes of the terms of `q / w` up to a place, s.
    #[must_use]
    pub fn size(&self, at: f64) -> f64 {
        (0..3).map(|i| self.drift[i].abs() * at + self.sum(i, |d, w, _| d / w + d * at)).fold(0.0, f64::max)
    }
}
