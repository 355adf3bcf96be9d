//! The direction of a step: Mehrotra's predictor and corrector, and Gondzio's correctors where they are asked for.
//!
//! ```text
//! M dx = -∇T - Σ a q ρ                    predictor (the affine direction)
//! M dx = -∇T - Σ a q ρ + Σ a η            corrector, η = ds_a dz_a / s - σ μ / s
//! ```
//!
//! One elimination a step, one pair of sweeps a direction. A Gondzio corrector tries a step longer by 0.1, pulls the products that leave
//! `[0.1, 10] σ μ` there back into it through `η`, and stays if the steps get longer by 0.01 together ([G96]).

use super::factor::Factor;
use super::state::{Measure, State};
use super::step::{Lengths, Reach, SHRINK, Sums};

/// Gondzio correctors a step of the structured solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Correctors {
    /// Mehrotra's alone.
    None,
    /// Up to two more.
    Two,
}

impl Correctors {
    fn most(self) -> usize {
        match self {
            Self::None => 0,
            Self::Two => 2,
        }
    }

    /// Steps without a gain of a tenth after which the loop ends.
    pub(super) fn patience(self) -> u32 {
        match self {
            Self::None => 12,
            Self::Two => 40,
        }
    }
}

/// Room for directions, reused from step to step.
#[derive(Clone, Debug, Default)]
pub(super) struct Centre {
    pub(super) factor: Factor,
    pub(super) step: Vec<f64>,
}

impl Centre {
    /// Finds the direction at an assessed iterate and leaves it in the pairs and in `step`. `None` if the elimination breaks down.
    pub(super) fn direct(&mut self, state: &mut State, measure: &Measure, correctors: Correctors) -> Option<Lengths> {
        if !self.factor.eliminate(&state.diagonal, &state.blocks) {
            return None;
        }
        let mean = measure.products / state.pairs() as f64;
        let target = self.predict(state) * mean;
        let fraction = (1.0 - mean / measure.time).max(0.99);
        let mut lengths = self.correct(state, target, fraction);
        for _ in 0..correctors.most() {
            if lengths.primal > 0.9 && lengths.dual > 0.9 {
                break;
            }
            let longer = |length: f64| (length + 0.1).min(1.0);
            state.each_pair(|pair| pair.pull(longer(lengths.primal), longer(lengths.dual), target));
            let pulled = self.correct(state, target, fraction);
            if pulled.primal + pulled.dual < lengths.primal + lengths.dual + 0.01 {
                state.each_pair(super::pair::Pair::release);
                lengths = self.correct(state, target, fraction);
                break;
            }
            lengths = pulled;
        }
        Some(lengths)
    }

    /// The affine direction; returns the centring weight `σ`.
    fn predict(&mut self, state: &mut State) -> f64 {
        self.step.clone_from(&state.right);
        self.factor.solve(&mut self.step);
        let (mut reach, mut sums) = (Reach::default(), Sums::default());
        for k in state.free.clone() {
            state.caps[k].predict(self.step[k], &mut reach, &mut sums);
        }
        for (ends, range) in self.step.windows(2).zip(state.rows.first.windows(2)) {
            for row in &mut state.rows.rows[range[0]..range[1]] {
                row.pair.predict(row.along([ends[0], ends[1]]), &mut reach, &mut sums);
            }
        }
        reach.node = self.shrinkage(state);
        sums.centring(reach.lengths(1.0))
    }

    /// The corrected direction and the lengths of its steps.
    fn correct(&mut self, state: &mut State, target: f64, fraction: f64) -> Lengths {
        self.step.clone_from(&state.right);
        for k in state.free.clone() {
            self.step[k] += state.caps[k].bend(target);
        }
        for (k, range) in state.rows.first.windows(2).enumerate() {
            for row in &state.rows.rows[range[0]..range[1]] {
                let bend = row.pair.bend(target);
                self.step[k] += row.before * bend;
                self.step[k + 1] += row.after * bend;
            }
        }
        self.factor.solve(&mut self.step);
        let mut reach = Reach::default();
        for k in state.free.clone() {
            state.caps[k].correct(self.step[k], target, &mut reach);
        }
        for (ends, range) in self.step.windows(2).zip(state.rows.first.windows(2)) {
            for row in &mut state.rows.rows[range[0]..range[1]] {
                row.pair.correct(row.along([ends[0], ends[1]]), target, &mut reach);
            }
        }
        reach.node = self.shrinkage(state);
        reach.lengths(fraction)
    }

    /// The largest relative decrease of a node's value.
    fn shrinkage(&self, state: &State) -> f64 {
        let relative = |k: usize| -self.step[k] * state.inverse_roots[k] * state.inverse_roots[k];
        state.free.clone().map(relative).fold(0.0, |most, here| if here > most { here } else { most })
    }

    /// Goes along the direction.
    pub(super) fn advance(&self, state: &mut State, lengths: Lengths) {
        debug_assert!(lengths.primal * self.shrinkage(state) <= SHRINK * (1.0 + 1e-9));
        for k in state.free.clone() {
            state.x[k] += lengths.primal * self.step[k];
        }
        state.each_pair(|pair| pair.advance(lengths.primal, lengths.dual));
    }
}
