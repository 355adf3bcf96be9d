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
mod state;
mod step;
#[cfg(test)]
mod tests;

use super::interval::IntervalProgram;
use super::piece::PieceProgram;
use super::repair::central_profile;
use super::solver::SolverAnswer;
use centre::Correctors;
use iterate::{Best, iterate};
use rows::KeptRows;
use state::State;
use std::time::Instant;

/// Slack at the start's profile, as a share of half the limit's range, up to which a row is kept.
const NEAR: f64 = 0.5;

/// The same at an answer that breaks a row.
const BROKEN: f64 = 0.1;

/// Rounds of adding broken rows; the last takes all rows.
const ROUNDS: usize = 6;

/// Where the steps begin, and how many correctors they take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// A little below the greedy profile, slacks as large as they should be rather than as they are; Mehrotra's corrector alone.
    Greedy,
    /// A profile inside all rows, so that no row is ever broken by more than rounding; two further correctors. For thin feasible
    /// sets, where the first way leaves the rows broken.
    Inside,
}

/// Solves the program in its own structure. Any answer is returned as it is, with the loop's ending as status: it is for the
/// certificate to judge.
#[must_use]
pub fn solve_structured(program: &PieceProgram, start: Start) -> SolverAnswer {
    let begin = Instant::now();
    let beginning = Beginning::new(program, start);
    let mut rows = KeptRows::default();
    rows.keep(program, &beginning.profile, beginning.near);
    let (mut steps, mut round) = (0, 1);
    let best = loop {
        let best = beginning.solve(program, &rows);
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

/// Start of the steps.
struct Beginning {
    /// The profile by which rows are chosen.
    profile: Vec<f64>,
    near: f64,
    /// The start as a share of it.
    share: f64,
    /// Least slack, as a share of the cap or in the row's units (half the limit's range is between 1 and 2).
    floor: f64,
    /// Sum of the products `s z`, as a share of the travel time.
    gap: f64,
    correctors: Correctors,
}

impl Beginning {
    fn new(program: &PieceProgram, start: Start) -> Self {
        let greedy = Self {
            profile: forward(program),
            near: NEAR,
            share: 0.97,
            floor: 0.03,
            gap: 0.1,
            correctors: Correctors::None,
        };
        let inside = match start {
            Start::Greedy => None,
            Start::Inside => central_profile(program).ok(),
        };
        match inside {
            Some(profile) => Self {
                gap: (-program.largest_excess(&profile)).clamp(1e-6, 0.1),
                profile,
                near: f64::INFINITY,
                share: 1.0 - 1e-3,
                floor: 1e-12,
                correctors: Correctors::Two,
            },
            None if start == Start::Inside => Self { near: f64::INFINITY, correctors: Correctors::Two, ..greedy },
            None => greedy,
        }
    }

    fn solve(&self, program: &PieceProgram, rows: &KeptRows) -> Best {
        let free = program.free();
        let x = self.profile.iter().enumerate();
        let x = x.map(|(k, x)| if free.contains(&k) { self.share * x } else { *x }).collect();
        iterate(&mut State::new(program, rows, x, self.floor, self.gap), self.correctors)
    }
}

/// The greedy profile below the program's proven caps, as a start: from the greatest value, the greatest next one. Where that leaves
/// nothing, half the cap.
fn forward(program: &PieceProgram) -> Vec<f64> {
    let mut profile = vec![program.cap[0]];
    for k in 0..program.h.len() {
        let cap = program.cap[k + 1];
        let next = IntervalProgram::greatest_after(program.interval(k), profile[k]).min(cap);
        let is_given = !program.free().contains(&(k + 1));
        profile.push(if is_given {
            cap
        } else if next > 1e-9 * cap {
            next
        } else {
            0.5 * cap
        });
    }
    profile
}
