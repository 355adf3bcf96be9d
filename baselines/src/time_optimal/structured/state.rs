//! An iterate: the profile, the pairs of rows and caps, and what one look at them gives.
//!
//! Derivatives of `T = Σ 2 h / (r_k + r_{k+1})`, `r = √x`, `g = 1 / (r_k + r_{k+1})`, an interval:
//!
//! ```text
//! ∂T/∂x_k          = -h g² / r_k
//! ∂²T/∂x_k²        =  h g³ / x_k + h g² / (2 r_k³)
//! ∂²T/∂x_k∂x_{k+1} =  h g³ / (r_k r_{k+1})
//! ```
//!
//! a rank-one `h g³ (1/r_k, 1/r_{k+1})` and two positive diagonal entries: it joins the rows in their sums.

use super::factor::Block;
use super::pair::Pair;
use super::rows::KeptRows;
use crate::time_optimal::piece::PieceProgram;
use std::ops::Range;

/// The iterate.
#[derive(Clone, Debug)]
pub(super) struct State<'a> {
    pub(super) program: &'a PieceProgram,
    pub(super) free: Range<usize>,
    pub(super) x: Vec<f64>,
    pub(super) rows: KeptRows,
    pub(super) caps: Vec<Pair>,
    roots: Vec<f64>,
    /// `1 / r`; 0 at given ends, which so have no derivative.
    pub(super) inverse_roots: Vec<f64>,
    pub(super) diagonal: Vec<f64>,
    pub(super) blocks: Vec<Block>,
    /// `-∇T - Σ a q ρ`.
    pub(super) right: Vec<f64>,
    /// `∇T + Aᵀz` without the caps'.
    slope: Vec<f64>,
}

/// The certificate of an iterate in ordinary arithmetic.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Measure {
    /// `T(x)`.
    pub(super) time: f64,
    /// The dual bound at `x` and `z`.
    pub(super) lower: f64,
    /// The largest excess of a kept row, 0 where all hold.
    pub(super) excess: f64,
    /// `Σ s z`.
    pub(super) products: f64,
}

impl Measure {
    /// The larger of the relative distance of the bounds and the sum of the products, plus the excess: outside the rows the bounds may
    /// cross, and their distance alone would vanish there.
    pub(super) fn distance(&self) -> f64 {
        let apart = (self.time - self.lower).abs();
        // Written so that not a number stays one.
        (if apart <= self.products { self.products } else { apart }) / self.time + self.excess
    }
}

impl<'a> State<'a> {
    /// Starts at a profile inside the caps; slacks are at least `floor`, products share `gap · T` equally.
    pub(super) fn new(program: &'a PieceProgram, rows: &KeptRows, x: Vec<f64>, floor: f64, gap: f64) -> Self {
        let nodes = x.len();
        let free = program.free();
        let roots: Vec<f64> = x.iter().map(|x| x.sqrt()).collect();
        let time: f64 = program.h.iter().zip(roots.windows(2)).map(|(h, r)| 2.0 * h / (r[0] + r[1])).sum();
        let share = gap * time / (free.len() + rows.rows.len()) as f64;
        let caps = (0..nodes).map(|k| {
            let cap = program.cap[k];
            if free.contains(&k) { Pair::new(cap - x[k], floor * cap, share) } else { Pair::default() }
        });
        let mut state = Self {
            caps: caps.collect(),
            program,
            free,
            rows: rows.clone(),
            roots,
            inverse_roots: vec![0.0; nodes],
            diagonal: vec![0.0; nodes],
            blocks: vec![Block::default(); nodes - 1],
            right: vec![0.0; nodes],
            slope: vec![0.0; nodes],
            x,
        };
        for k in 0..nodes - 1 {
            let ends = [state.x[k], state.x[k + 1]];
            for row in &mut state.rows.rows[state.rows.first[k]..state.rows.first[k + 1]] {
                row.pair = Pair::new(row.bound - row.along(ends), floor, share);
            }
        }
        state
    }

    /// The number of pairs.
    pub(super) fn pairs(&self) -> usize {
        self.free.len() + self.rows.rows.len()
    }

    /// Evaluates the iterate: matrix, right-hand side and certificate.
    pub(super) fn assess(&mut self) -> Measure {
        let mut measure = Measure::default();
        self.nodes(&mut measure);
        for k in 0..self.blocks.len() {
            self.interval(k, &mut measure);
        }
        self.close(&mut measure);
        measure
    }

    /// Adds the terms of one node alone: roots and caps.
    fn nodes(&mut self, measure: &mut Measure) {
        // A given end keeps its place in the elimination: a pivot of 1 and a right-hand side of 0.
        for end in [0, self.x.len() - 1] {
            (self.diagonal[end], self.right[end], self.slope[end]) = (1.0, 0.0, 0.0);
        }
        for k in self.free.clone() {
            let root = self.x[k].sqrt();
            self.roots[k] = root;
            self.inverse_roots[k] = 1.0 / root;
            let cap = &mut self.caps[k];
            cap.place(self.x[k] - self.program.cap[k]);
            self.diagonal[k] = cap.weight;
            self.right[k] = -cap.weight * cap.residual;
            self.slope[k] = 0.0;
            measure.products += cap.slack * cap.multiplier;
        }
    }

    /// The sums of one interval: the travel time and the rows.
    #[inline]
    fn interval(&mut self, k: usize, measure: &mut Measure) {
        let h = self.program.h[k];
        let inverse = [self.inverse_roots[k], self.inverse_roots[k + 1]];
        let g = 1.0 / (self.roots[k] + self.roots[k + 1]);
        let second = h * g * g;
        let third = second * g;
        measure.time += 2.0 * h * g;
        let mut slope = inverse.map(|i| -second * i);
        let mut right = slope.map(|s| -s);
        let curvature = inverse.map(|i| 0.5 * second * i * i * i);
        let (mut near, mut cross) = (third * inverse[0] * inverse[0], third * inverse[0] * inverse[1]);
        let ends = [self.x[k], self.x[k + 1]];
        measure.lower -= slope[0] * ends[0] + slope[1] * ends[1];
        let rows = &mut self.rows.rows[self.rows.first[k]..self.rows.first[k + 1]];
        for row in rows.iter_mut() {
            let excess = row.along(ends) - row.bound;
            row.pair.place(excess);
            let Pair { slack, multiplier, weight, residual, .. } = row.pair;
            let weighed = weight * row.before;
            near += weighed * row.before;
            cross += weighed * row.after;
            let pull = weight * residual;
            right = [right[0] - row.before * pull, right[1] - row.after * pull];
            slope = [slope[0] + row.before * multiplier, slope[1] + row.after * multiplier];
            measure.lower -= multiplier * row.bound;
            measure.products += slack * multiplier;
            measure.excess = if excess > measure.excess { excess } else { measure.excess };
        }
        let ratio = if near > 0.0 { cross / near } else { 0.0 };
        let off = |before: f64, after: f64| (after - ratio * before) * (after - ratio * before);
        let rest: f64 = rows.iter().map(|row| row.pair.weight * off(row.before, row.after)).sum();
        self.blocks[k] =
            Block { near, cross, rest: rest + third * off(inverse[0], inverse[1]), carried: ratio * cross };
        for (node, side) in [(k, 0), (k + 1, 1)] {
            self.diagonal[node] += curvature[side];
            self.right[node] += right[side];
            self.slope[node] += slope[side];
        }
    }

    /// The dual bound `T - ∇T·x - z·b + Σ min(0, slope_k) cap_k` ([`crate::time_optimal::lower_bound`]).
    fn close(&self, measure: &mut Measure) {
        let box_term: f64 = self.free.clone().map(|k| self.slope[k].min(0.0) * self.program.cap[k]).sum();
        measure.lower += measure.time + box_term;
    }
}

impl State<'_> {
    /// Visits the pairs of caps and rows.
    pub(super) fn each_pair(&mut self, mut visit: impl FnMut(&mut Pair)) {
        self.caps[self.free.clone()].iter_mut().for_each(&mut visit);
        self.rows.rows.iter_mut().for_each(|row| visit(&mut row.pair));
    }
}
