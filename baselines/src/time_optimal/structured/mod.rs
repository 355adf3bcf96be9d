//! The time optimum by an interior point on a tridiagonal matrix.
//!
//! ```text
//! minimise  T(x) = Σ 2 h_k / (√x_k + √x_{k+1})   subject to   a_j x_k + c_j x_{k+1} <= b_j,   0 < x_k <= cap_k
//! ```
//!
//! Every row touches two neighbouring nodes, so the Newton matrix `∇²T + Σ (z/s) a aᵀ` of the primal-dual method is
//! tridiagonal, and a step costs a constant number of operations a row. The parts: [`rows`] chooses the rows, [`state`] evaluates an iterate,
//! [`factor`] eliminates, [`centre`] finds a direction, [`step`] its lengths, [`iterate`] repeats until the
//! certificate closes and keeps the best.
//!
//! Sources: Verscheure et al. 2009 for the program, \[M92\] for predictor and corrector, \[G96\] for further correctors, \[G73\] for rotations
//! without square roots. The start, the choice of rows, the closed form of the elimination and the stop are this project's.

mod centre;
mod factor;
mod iterate;
mod pair;
mod rows;
#[cfg(test)]
mod scratch;
mod state;
mod step;

pub use centre::Correctors;

use super::interval::IntervalProgram;
use super::piece::PieceProgram;
use super::solver::SolverAnswer;
use iterate::{Best, iterate};
use rows::KeptRows;
use state::State;
use std::time::Instant;

/// Slack at the greedy profile, as a share of half the limit's range, up to which a row is kept.
const NEAR: f64 = 0.5;

/// The same at an answer that breaks a row.
const BROKEN: f64 = 0.1;

/// Rounds of adding broken rows; the last takes all rows.
const ROUNDS: usize = 6;

/// The start as a share of the greedy profile.
const SHARE: f64 = 0.97;

/// Least slack of the start, as a share of the cap or in the row's units (half the limit's range is between 1 and 2).
const FLOOR: f64 = 0.03;

/// Sum of the products `s z` at the start, as a share of the travel time.
const GAP: f64 = 0.1;

/// Solves the program in its own structure. Any answer is returned as it is, with the loop's ending as status: it is for the
/// certificate to judge.
#[must_use]
pub fn solve_structured(program: &PieceProgram, correctors: Correctors) -> SolverAnswer {
    let begin = Instant::now();
    let greedy = forward(program);
    let mut rows = KeptRows::default();
    rows.keep(program, &greedy, NEAR);
    let mut steps = 0;
    let mut round = 1;
    let best = loop {
        let best = solve(program, &rows, &greedy, correctors);
        steps += best.steps;
        if round == ROUNDS || program.largest_excess(&best.x) <= 0.0 {
            break best;
        }
        round += 1;
        let share = if round == ROUNDS { f64::INFINITY } else { BROKEN };
        if rows.keep(program, &best.x, share) == 0 {
            break best;
        }
    };
    SolverAnswer {
        multipliers: rows.multipliers(&best.multipliers, program.row_count()),
        b: best.x,
        status: format!("{:?}", best.ending),
        iterations: steps,
        solve_s: begin.elapsed().as_secs_f64(),
    }
}

fn solve(program: &PieceProgram, rows: &KeptRows, greedy: &[f64], correctors: Correctors) -> Best {
    let free = program.free();
    let x = greedy.iter().enumerate().map(|(k, x)| if free.contains(&k) { SHARE * x } else { *x }).collect();
    iterate(&mut State::new(program, rows, x, FLOOR, GAP), correctors)
}

/// The greedy profile below the program's proven caps, as a start: from the greatest value, the greatest next one. Where that leaves
/// nothing, half the cap.
fn forward(program: &PieceProgram) -> Vec<f64> {
    let mut profile = vec![program.cap[0]];
    for k in 0..program.h.len() {
        let cap = program.cap[k + 1];
        let next = IntervalProgram::greatest_after(program.interval(k), profile[k]).min(cap);
        let is_given = !program.free().contains(&(k + 1));
        profile.push(if is_given { cap } else if next > 1e-9 * cap { next } else { 0.5 * cap });
    }
    profile
}
