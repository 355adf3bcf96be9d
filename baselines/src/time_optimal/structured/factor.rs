//! The elimination of the tridiagonal matrix `M = ∇²T + Σ q a aᵀ` without a subtraction.
//!
//! `M` is a sum of positive diagonal entries `d_k` and of rank-ones `q (a, c)ᵀ(a, c)` on neighbouring nodes. With the sums of an interval
//!
//! ```text
//! A = Σ q a²,   B = Σ q a c,   β = B / A,   P = Σ q (c - β a)²
//! ```
//!
//! and `ρ_k` what the nodes before leave on the diagonal, the pivot is `D_k = ρ_k + A`, the factor `l_k = B / D_k`, and what
//! is left for the next node
//!
//! ```text
//! ρ_{k+1} = d_{k+1} + Σ q c² - B² / D_k = d_{k+1} + P + β B ρ_k / D_k.
//! ```
//!
//! In the middle form two numbers of the size `q c²` cancel down to `ρ`: `q` grows as `1/μ`, `ρ` falls with the interval, and the pivot loses its
//! sign. In the last form only positive numbers are added: it is what square-root-free Givens rotations of the weighted rows
//! give ([G73]), in closed form and with the divisions of an interval instead of those of every row. An error of `β` enters `P` by
//! its square alone, for `β` minimises it.

/// The sums of one interval.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Block {
    /// `A`.
    pub(super) near: f64,
    /// `B`.
    pub(super) cross: f64,
    /// `P`.
    pub(super) rest: f64,
    /// `β B`.
    pub(super) carried: f64,
}

/// `M = L D Lᵀ`: the inverses of the pivots and the factor below the diagonal.
#[derive(Clone, Debug, Default)]
pub(super) struct Factor {
    inverse: Vec<f64>,
    below: Vec<f64>,
}

impl Factor {
    /// Eliminates. False if a pivot is no positive number: only numbers that are none, or overflow, lead there.
    pub(super) fn eliminate(&mut self, diagonal: &[f64], blocks: &[Block]) -> bool {
        self.inverse.clear();
        self.below.clear();
        let mut left = diagonal[0];
        let mut least = left;
        for (block, next) in blocks.iter().zip(&diagonal[1..]) {
            let pivot = left + block.near;
            let inverse = 1.0 / pivot;
            self.inverse.push(inverse);
            self.below.push(block.cross * inverse);
            // A second division beside the first: the chain from node to node is shorter by a product.
            left = (next + block.rest) + block.carried * (left / pivot);
            // Not a number fails both comparisons and stays.
            least = if left >= least { least } else { left };
        }
        self.inverse.push(1.0 / left);
        least > 0.0 && left < f64::INFINITY
    }

    /// Replaces a right-hand side by the solution.
    pub(super) fn solve(&self, values: &mut [f64]) {
        let mut before = values[0];
        for ((value, below), inverse) in values[1..].iter_mut().zip(&self.below).zip(&self.inverse[1..]) {
            before = *value - below * before;
            *value = before * inverse;
        }
        values[0] *= self.inverse[0];
        let Some((last, others)) = values.split_last_mut() else { return };
        let mut after = *last;
        for (value, below) in others.iter_mut().zip(&self.below).rev() {
            after = *value - below * after;
            *value = after;
        }
    }
}
