//! A row's slack with its multiplier, and what one step does to them.
//!
//! With `e = a·x - b` the row's excess, the linearised conditions of a row are
//!
//! ```text
//! a·dx + ds = -ρ,   ρ = e + s              (primal residual)
//! z ds + s dz = -s z - s η                 (complementarity; η s = ds_a dz_a - σ μ after the predictor, 0 in it)
//! ds = -w,   dz = q w - z - η,   w = ρ + a·dx,   q = z / s
//! ```
//!
//! so that after the elimination of `ds` and `dz` a row adds `q a aᵀ` to the matrix and `a (η - q ρ)` to the right-hand side, beside
//! `-∇T` ([M92] eq 6-9 with the multipliers kept positive).

use super::step::{Reach, Sums};

/// A slack, its multiplier and their steps.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pair {
    pub(super) slack: f64,
    pub(super) multiplier: f64,
    /// `ρ = a·x + s - b`.
    pub(super) residual: f64,
    /// `1 / s`.
    pub(super) inverse: f64,
    /// `q = z / s`.
    pub(super) weight: f64,
    /// `ds_a dz_a / s` of the predictor, less the pull of further correctors.
    pub(super) product: f64,
    slack_step: f64,
    multiplier_step: f64,
    pull: f64,
}

impl Pair {
    /// A pair with `s z = share`, its slack at least `floor`.
    pub(super) fn new(room: f64, floor: f64, share: f64) -> Self {
        let slack = room.max(floor);
        Self { slack, multiplier: share / slack, ..Self::default() }
    }

    /// Takes the row's excess `a·x - b` at a new `x`.
    #[inline]
    pub(super) fn place(&mut self, excess: f64) {
        self.residual = excess + self.slack;
        self.inverse = 1.0 / self.slack;
        self.weight = self.multiplier * self.inverse;
    }

    /// The predictor's steps from `a·dx`; of them only their product is kept.
    ///
    /// `-ds / s = w / s` and `-dz / z = 1 - w / s`: neither needs a division.
    #[inline]
    pub(super) fn predict(&mut self, change: f64, reach: &mut Reach, sums: &mut Sums) {
        let w = self.residual + change;
        let step = self.weight * w - self.multiplier;
        let share = w * self.inverse;
        self.product = -share * step;
        reach.shorten(share, 1.0 - share);
        sums.add(self.slack * self.multiplier, w * self.multiplier, -w * step);
    }

    /// `η` under the target `σ μ`.
    #[inline]
    pub(super) fn bend(&self, target: f64) -> f64 {
        self.product - target * self.inverse
    }

    /// The corrected steps from `a·dx`.
    #[inline]
    pub(super) fn correct(&mut self, change: f64, target: f64, reach: &mut Reach) {
        let w = self.residual + change;
        self.slack_step = -w;
        self.multiplier_step = self.weight * w - self.multiplier - self.bend(target);
        let share = w * self.inverse;
        if share > reach.primal {
            reach.primal = share;
        }
        // A division only where it changes the result.
        if -self.multiplier_step > reach.dual * self.multiplier {
            reach.dual = -self.multiplier_step / self.multiplier;
        }
    }

    /// Gondzio's pull ([G96] section 4): where the product of the longer trial step leaves `[β_min, β_max]` it is projected back.
    #[inline]
    pub(super) fn pull(&mut self, primal: f64, dual: f64, target: f64) {
        let (least, most) = (0.1 * target, 10.0 * target);
        let product = (self.slack + primal * self.slack_step) * (self.multiplier + dual * self.multiplier_step);
        let away = if product < least { least - product } else { (most - product).min(0.0).max(-most) };
        self.pull = away * self.inverse;
        self.product -= self.pull;
    }

    /// Takes the last pull back.
    #[inline]
    pub(super) fn release(&mut self) {
        self.product += self.pull;
    }

    /// Goes along the corrected steps.
    #[inline]
    pub(super) fn advance(&mut self, primal: f64, dual: f64) {
        self.slack += primal * self.slack_step;
        self.multiplier += dual * self.multiplier_step;
    }
}
