use super::controllable::controllable;
use super::error::OptimumError;
use super::interval::{Direction, IntervalProgram};
use super::piece::{ExtraSample, PieceProgram};
use super::repair::feasible_time;
use super::violation::Violation;
use super::{ProfilePiece, profile_piece};
use crate::outward::Outward;
use slideway_path::SampledPath;

/// Rows may be exceeded by this share of their limit: rounding of the line arithmetic. A profile that exceeds more is refused.
pub const ROW_TOLERANCE: f64 = 1e-9;

/// A profile by reachability analysis.
///
/// Feasible, fast, and **not** the discrete optimum: the forward pass takes the greatest rate at every node, and where a row
/// binds both ends of an interval from above, less now may mean more later. Its time is an upper bound of the optimum on the
/// same rows, never a lower one; the difference falls with the grid.
#[derive(Clone, Debug, PartialEq)]
pub struct ReachableProfile {
    /// Travel time, s.
    pub duration_s: f64,
    /// Largest violation of a row at the nodes, rounded up, as a share of the limit's half range; at most [`ROW_TOLERANCE`].
    pub largest_excess: f64,
    /// Largest violation of a limit between grid points.
    pub between: Violation,
    /// The profile.
    pub pieces: Vec<ProfilePiece>,
}

/// The greedy profile along a sampled path by reachability analysis, in the manner of TOPP-RA (Pham and Pham 2018): controllable
/// sets backward, the greatest controllable rate forward, two-variable linear programs throughout; linear in the grid.
///
/// The rows are those of [`super::time_optimum`]: every limit at both ends of every interval.
///
/// # Errors
///
/// The path does not move, a number is not usable, or no profile keeps the limits.
pub fn reachable_profile(path: &SampledPath) -> Result<ReachableProfile, OptimumError> {
    let mut result = ReachableProfile::empty();
    for index in 0..path.pieces.len() {
        let piece = reach_piece(path, index, &[])?;
        result.add(path, index, piece);
    }
    Ok(result)
}

/// One piece's profile, its time and its largest violation of a row.
pub(super) struct ReachedPiece {
    pub(super) b: Vec<f64>,
    time: Outward,
    excess: f64,
}

impl ReachableProfile {
    pub(super) fn empty() -> Self {
        Self { duration_s: 0.0, largest_excess: f64::NEG_INFINITY, between: Violation::default(), pieces: Vec::new() }
    }

    pub(super) fn add(&mut self, path: &SampledPath, index: usize, piece: ReachedPiece) {
        self.duration_s += 0.5 * (piece.time.lo + piece.time.hi);
        self.largest_excess = self.largest_excess.max(piece.excess);
        self.between = self.between.worst(Violation::new(path, index, &piece.b));
        self.pieces.push(profile_piece(&path.pieces[index], piece.b));
    }
}

pub(super) fn reach_piece(
    path: &SampledPath,
    index: usize,
    extra: &[ExtraSample],
) -> Result<ReachedPiece, OptimumError> {
    let program = PieceProgram::sampled(path, index, extra)?;
    let b = greedy(&program).map_err(|e| e.describe(&program, path))?;
    if program.free().all(|k| b[k] > 0.0) {
        return reached(&program, b);
    }
    let program = program.bounded(path)?;
    match positive_greedy(&program) {
        Some(b) => reached(&program, b),
        None => Err(OptimumError::Unrepairable("every profile stands still inside the path")),
    }
}

/// Re-checks a profile in the program's units against all rows.
fn reached(program: &PieceProgram, b: Vec<f64>) -> Result<ReachedPiece, OptimumError> {
    let excess = program.largest_excess(&b);
    if !(excess <= ROW_TOLERANCE) {
        return Err(OptimumError::Unrepairable("rounding exceeds a limit: the rows are too badly scaled"));
    }
    let time = feasible_time(program, &b);
    Ok(ReachedPiece { b: program.in_units(&b), time, excess })
}

/// Shares of the caps below which a profile must not fall, tried in this order.
const FLOORS: [f64; 4] = [0.0, 1e-2, 1e-4, 1e-6];

/// A greedy profile that nowhere stands still: on coarse grids taking the most now may leave nothing but rest for the next node;
/// a floor under the controllable ranges looks ahead. For a program with proven caps.
pub(super) fn positive_greedy(program: &PieceProgram) -> Option<Vec<f64>> {
    FLOORS
        .iter()
        .filter_map(|&share| greedy(&program.above(share)).ok())
        .find(|profile| program.free().all(|k| profile[k] > 0.0))
}

/// The greedy profile of a program, in its units: from the greatest controllable start, the greatest controllable next value.
///
/// Guaranteed up to rounding: every row and cap holds, for the next value is taken from the controllable range, where by
/// construction of the ranges some value is left. Ends at given values are met exactly.
pub(super) fn greedy(program: &PieceProgram) -> Result<Vec<f64>, Box<super::farkas::Infeasibility>> {
    let ranges = controllable(program, Direction::Backward)?;
    let mut profile = vec![ranges.high[0]];
    for interval in 0..program.h.len() {
        let x = profile[interval];
        let next = IntervalProgram::greatest_after(program.interval(interval), x);
        profile.push(next.min(ranges.high[interval + 1]).max(ranges.low[interval + 1]));
    }
    Ok(profile)
}
