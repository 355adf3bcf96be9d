use super::error::OptimumError;
use super::piece::ExtraSample;
use super::reachability::{ReachableProfile, reach_piece};
use super::violation::{Violation, at_samples};
use super::{Solver, TimeOptimum, solve_piece};
use slideway_path::SampledPath;
use std::collections::BTreeSet;

/// A result whose limits hold between the nodes as well.
#[derive(Clone, Debug, PartialEq)]
pub struct Refined<T> {
    /// The result, on the rows at the nodes and at the samples that were added.
    pub result: T,
    /// Rounds of solving, the largest number over the pieces.
    pub rounds: usize,
    /// Samples between nodes whose limits were added as rows.
    pub added: usize,
}

/// Rounds after which refinement gives up. Every round adds at least one of finitely many samples, and each added sample's rows
/// bind from then on; in practice two or three rounds do.
const MAX_ROUNDS: usize = 40;

/// The certified optimum with the limits kept at the samples between the nodes as well, to `tolerance` as a share of each limit.
///
/// Solve, look at every sample between the nodes, add the limits of each sample that is exceeded as rows (within an interval
/// `b` is linear in `s`, so they are rows in the same two unknowns), solve again. Guaranteed on return: no limit is
/// exceeded by more than `tolerance` at any node or any sample of `path`; the certificate is about the program with the added
/// rows. Not guaranteed: anything between the samples, where for a smooth path the excess falls with the square of
/// their distance. Give more samples, or another set, to see.
///
/// # Errors
///
/// As [`super::time_optimum`], or the limits stay exceeded.
pub fn refine_optimum(path: &SampledPath, tolerance: f64) -> Result<Refined<TimeOptimum>, OptimumError> {
    refine_optimum_by(path, tolerance, Solver::default())
}

/// As [`refine_optimum`], by a solver of choice.
///
/// # Errors
///
/// As [`refine_optimum`].
pub fn refine_optimum_by(
    path: &SampledPath,
    tolerance: f64,
    solver: Solver,
) -> Result<Refined<TimeOptimum>, OptimumError> {
    let (mut parts, mut rounds, mut added) = (Vec::new(), 0, 0);
    for index in 0..path.pieces.len() {
        let piece = refine_piece(path, index, tolerance, |extra| solve_piece(path, index, extra, solver), |p| &p.b)?;
        rounds = piece.rounds.max(rounds);
        added += piece.added;
        parts.push(piece.result);
    }
    Ok(Refined { result: TimeOptimum::of(path, parts), rounds, added })
}

/// The greedy profile with the limits kept at the samples between the nodes as well; guarantee as [`refine_optimum`].
///
/// # Errors
///
/// As [`super::reachable_profile`], or the limits stay exceeded.
pub fn refine_profile(path: &SampledPath, tolerance: f64) -> Result<Refined<ReachableProfile>, OptimumError> {
    let (mut result, mut rounds, mut added) = (ReachableProfile::empty(), 0, 0);
    for index in 0..path.pieces.len() {
        let piece = refine_piece(path, index, tolerance, |extra| reach_piece(path, index, extra), |p| &p.b)?;
        rounds = piece.rounds.max(rounds);
        added += piece.added;
        result.add(path, index, piece.result);
    }
    Ok(Refined { result, rounds, added })
}

fn refine_piece<T>(
    path: &SampledPath,
    index: usize,
    tolerance: f64,
    solve: impl Fn(&[ExtraSample]) -> Result<T, OptimumError>,
    profile: impl Fn(&T) -> &[f64],
) -> Result<Refined<T>, OptimumError> {
    let mut extra = BTreeSet::new();
    let mut excess = f64::INFINITY;
    for rounds in 1..=MAX_ROUNDS {
        let samples: Vec<ExtraSample> = extra.iter().copied().collect();
        let result = solve(&samples)?;
        let b = profile(&result);
        excess = Violation::new(path, index, b).largest();
        if excess <= tolerance {
            return Ok(Refined { result, rounds, added: extra.len() });
        }
        let before = extra.len();
        for interval in 0..path.pieces[index].between.len() {
            let found = at_samples(path, index, b, interval);
            let exceeded = found.iter().enumerate().filter(|(_, v)| !(v.largest() <= 0.5 * tolerance));
            extra.extend(exceeded.map(|(sample, _)| ExtraSample { interval, sample }));
        }
        if extra.len() == before {
            return Err(OptimumError::NotRefined { excess, rounds });
        }
    }
    Err(OptimumError::NotRefined { excess, rounds: MAX_ROUNDS })
}
