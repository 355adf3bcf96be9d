//! The rows that the solver works on: those that the greedy profile comes near, and later those that an answer breaks.
//!
//! ```text
//! a x_k + c x_{k+1} <= b,   given ends moved into b
//! ```
//!
//! A row is taken where its slack at the profile is below a share of half the limit's range. Of 28 rows an interval at
//! 7 joints one is left on the average. What is left out is checked after every solve, and added where it is broken.

use super::pair::Pair;
use crate::time_optimal::piece::PieceProgram;
use crate::time_optimal::strip::{Row, Side};

/// A row of the reduced program.
#[derive(Clone, Copy, Debug)]
pub(super) struct KeptRow {
    pub(super) before: f64,
    pub(super) after: f64,
    pub(super) bound: f64,
    pub(super) pair: Pair,
    /// Its number in [`PieceProgram::rows`].
    pub(super) number: u32,
}

impl KeptRow {
    /// `a·v` for values at both ends of its interval.
    #[inline]
    pub(super) fn along(&self, values: [f64; 2]) -> f64 {
        self.before * values[0] + self.after * values[1]
    }
}

/// The kept rows, interval by interval.
#[derive(Clone, Debug, Default)]
pub(super) struct KeptRows {
    pub(super) rows: Vec<KeptRow>,
    /// Rows of interval `k` are `first[k]..first[k + 1]`.
    pub(super) first: Vec<usize>,
}

impl KeptRows {
    /// Keeps the rows whose slack at a profile is below `share` of their half range, beside those already kept. Returns how many are new.
    pub(super) fn keep(&mut self, program: &PieceProgram, profile: &[f64], share: f64) -> usize {
        let before = std::mem::take(&mut self.rows);
        let mut kept = before.iter().map(|row| row.number).peekable();
        self.first.clear();
        self.first.push(0);
        let mut number = 0;
        let free = program.free();
        for (k, ends) in profile.windows(2).enumerate() {
            let is_free = [free.contains(&k), free.contains(&(k + 1))];
            for strip in program.interval(k) {
                let value = strip.before * ends[0] + strip.after * ends[1];
                let margin = share * strip.half_range();
                for (side, room, bound) in
                    [(Side::Upper, strip.upper - value, strip.upper), (Side::Lower, value - strip.lower, strip.lower)]
                {
                    if bound.is_infinite() {
                        continue;
                    }
                    let was_kept = kept.next_if_eq(&number).is_some();
                    if (was_kept || !(room > margin))
                        && let Some(row) = strip.row(k, side)
                    {
                        self.rows.extend(reduced(program, row, is_free, number));
                    }
                    number += 1;
                }
            }
            self.first.push(self.rows.len());
        }
        self.rows.len() - before.len()
    }

    /// Multipliers of all the program's rows, zero where a row is left out.
    pub(super) fn multipliers(&self, values: &[f64], count: usize) -> Vec<f64> {
        let mut all = vec![0.0; count];
        for (row, value) in self.rows.iter().zip(values) {
            all[row.number as usize] = *value;
        }
        all
    }
}

/// The row without its given ends; none if nothing is left of it.
fn reduced(program: &PieceProgram, row: Row, is_free: [bool; 2], number: u32) -> Option<KeptRow> {
    let mut kept = KeptRow { before: row.before, after: row.after, bound: row.bound, pair: Pair::default(), number };
    if !is_free[0] {
        kept.bound -= kept.before * program.cap[row.interval];
        kept.before = 0.0;
    }
    if !is_free[1] {
        kept.bound -= kept.after * program.cap[row.interval + 1];
        kept.after = 0.0;
    }
    kept.bound -= rounding(program, &row);
    (kept.before != 0.0 || kept.after != 0.0).then_some(kept)
}

/// The rounding that a check with outward rounding adds to a row ([`crate::time_optimal::Strip::overshoot`]: `4 ε` of each product and of the bound), twice: inside
/// the narrowed row the check passes and nothing is left to repair.
fn rounding(program: &PieceProgram, row: &Row) -> f64 {
    let (before, after) = (row.before * program.cap[row.interval], row.after * program.cap[row.interval + 1]);
    8.0 * f64::EPSILON * (before.abs() + after.abs() + row.bound.abs())
}
