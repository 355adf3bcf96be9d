//! Solvers of a piece: their order, and each one's attempt and answer.

use super::certificate::lower_bound;
use super::conic::solve_conic;
use super::error::OptimumError;
use super::piece::PieceProgram;
use super::repair::{feasible_time, repair};
use super::structured::{Start, solve_structured};
use super::{GAP_TOLERANCE, SolvedPiece};
use crate::outward::Outward;
use std::fmt;

/// A solver of the discretised program. The certificate is the same for all.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Solver {
    /// The interior point on the tridiagonal Newton matrix ([`super::solve_structured`]); where its answer is not certified it is
    /// asked again from a profile inside all rows and with Gondzio's correctors, and after that [`Solver::Conic`] is asked.
    #[default]
    Structured,
    /// Clarabel on the second-order cone program ([`solve_conic`]).
    Conic,
}

impl fmt::Display for Solver {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Self::Structured => "structured",
            Self::Conic => "conic",
        })
    }
}

/// The answer of a solver. None of it is believed.
#[derive(Clone, Debug, PartialEq)]
pub struct SolverAnswer {
    /// The profile `x` at all nodes.
    pub b: Vec<f64>,
    /// Multipliers of the program's rows, in their order, as the solver gives them; 0 for rows that it left out.
    pub multipliers: Vec<f64>,
    /// The solver's status.
    pub status: String,
    /// Iterations.
    pub iterations: u32,
    /// Wall-clock time for setting up and solving, s.
    pub solve_s: f64,
}

/// One run of a solver on one piece.
#[derive(Clone, Debug, PartialEq)]
pub struct Attempt {
    /// The piece, counted from 0.
    pub piece: usize,
    /// The solver.
    pub solver: Solver,
    /// Its status: reported, not believed.
    pub status: String,
    /// Its iterations.
    pub iterations: u32,
    /// Its wall-clock time, s.
    pub solve_s: f64,
    /// Relative distance of the bounds that its answer gives this piece; infinite if it could not be repaired.
    pub gap: f64,
}

/// A run of a solver; the runs follow in their order until the bounds are close enough.
#[derive(Clone, Copy)]
enum Run {
    Structured(Start),
    Conic,
}

impl Solver {
    fn runs(self) -> &'static [Run] {
        match self {
            Self::Structured => &[Run::Structured(Start::Greedy), Run::Structured(Start::Inside), Run::Conic],
            Self::Conic => &[Run::Conic],
        }
    }

    /// Solves and certifies one piece; the answer with the closest bounds is kept, the first that is certified ends the search.
    pub(super) fn certify(self, program: &PieceProgram) -> Result<SolvedPiece, OptimumError> {
        let mut best: Option<SolvedPiece> = None;
        let mut attempts = Vec::new();
        let mut failure = None;
        for run in self.runs() {
            let answer = match run.solve(program) {
                Ok(answer) => answer,
                Err(error) => {
                    failure = Some(error);
                    continue;
                }
            };
            let mut attempt = run.attempt(program, &answer);
            match bounds(program, answer, run.solver()) {
                Ok(piece) => {
                    attempt.gap = piece.gap();
                    if best.as_ref().is_none_or(|b| attempt.gap < b.gap()) {
                        best = Some(piece);
                    }
                }
                Err(error) => failure = Some(error),
            }
            let is_certified = attempt.gap <= GAP_TOLERANCE;
            attempts.push(attempt);
            if is_certified {
                break;
            }
        }
        match (best, failure) {
            (Some(piece), _) => Ok(SolvedPiece { attempts, ..piece }),
            (None, Some(error)) => Err(error),
            (None, None) => Err(OptimumError::Unrepairable("no solver gave an answer")),
        }
    }
}

impl Run {
    fn solver(self) -> Solver {
        match self {
            Self::Structured(_) => Solver::Structured,
            Self::Conic => Solver::Conic,
        }
    }

    fn solve(self, program: &PieceProgram) -> Result<SolverAnswer, OptimumError> {
        match self {
            Self::Structured(start) => Ok(solve_structured(program, start)),
            Self::Conic => solve_conic(program),
        }
    }

    fn attempt(self, program: &PieceProgram, answer: &SolverAnswer) -> Attempt {
        Attempt {
            piece: program.index,
            solver: self.solver(),
            status: answer.status.clone(),
            iterations: answer.iterations,
            solve_s: answer.solve_s,
            gap: f64::INFINITY,
        }
    }
}

/// Both bounds from an answer, whatever it is.
fn bounds(program: &PieceProgram, answer: SolverAnswer, solver: Solver) -> Result<SolvedPiece, OptimumError> {
    let profile = repair(program, &answer.b)?;
    let (lower, upper) = (lower_bound(program, &profile, &answer.multipliers), feasible_time(program, &profile));
    Ok(SolvedPiece { b: program.in_units(&profile), lower, upper, solver, status: answer.status, attempts: Vec::new() })
}

impl SolvedPiece {
    /// `(upper - lower) / lower`; infinite where that is no gap.
    fn gap(&self) -> f64 {
        let gap = (self.upper - self.lower).hi / self.lower.lo;
        if self.lower.lo > 0.0 && gap >= 0.0 { gap } else { f64::INFINITY }
    }

    /// A bound of the piece.
    pub(super) fn sum(parts: &[Self], bound: fn(&Self) -> Outward) -> Outward {
        parts.iter().map(bound).fold(Outward::ZERO, |sum, time| sum + time)
    }
}
