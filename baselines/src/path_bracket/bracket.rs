//! The bracket of a whole path: its pieces' brackets, summed.

use super::cells::{self, Piece};
use super::error::BracketError;
use super::path::JointPathProblem;
use super::profile::Profile;
use super::refine::{self, PieceBracket};
use super::rows::LimitName;
use super::speed_only;
use crate::outward::Outward;

/// The solver that seeks profiles. Neither bound rests on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Solver {
    /// The project's own structured interior point.
    #[default]
    InteriorPoint,
    /// The conic solver Clarabel on the same cells and rows: slower, a reference.
    Conic,
}

/// How close the bounds are to come, and what that may cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BracketOptions {
    /// Relative gap `upper / lower - 1` to reach, above 0.
    pub gap: f64,
    /// Most cells, at least 10.
    pub cells: usize,
    /// Cells to begin with; about that many.
    pub start: usize,
    /// The solver.
    pub solver: Solver,
}

impl Default for BracketOptions {
    /// A gap of 1e-5 with at most 20 000 cells.
    fn default() -> Self {
        Self { gap: 1e-5, cells: 20_000, start: 150, solver: Solver::InteriorPoint }
    }
}

/// Why the refinement ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopReason {
    /// The gap asked for is reached.
    GapReached,
    /// All cells are used.
    CellsSpent,
    /// Rounds gain nothing any more, or there is no profile to refine.
    NoProgress,
}

/// What one cell adds to the gap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellGap {
    /// Path parameter at the cell's ends.
    pub from: f64,
    /// Its end.
    pub to: f64,
    /// Its part of `upper - lower`, s.
    pub gap_s: f64,
    /// The limit that the profile uses most there.
    pub limit: Option<LimitName>,
}

/// The time optimum of a path between two numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct PathBracket {
    /// No motion along the path that keeps the limits is faster, s.
    pub lower_s: f64,
    /// Travel time of the profile, rounded up, s.
    pub upper_s: f64,
    /// `upper / lower - 1`, rounded up; infinite where a bound is missing.
    pub gap: f64,
    /// Whether the gap asked for is reached.
    pub certified: bool,
    /// Cells at the end.
    pub cells: usize,
    /// Rounds, the most of any piece.
    pub rounds: usize,
    /// The profile of the upper bound. It keeps every limit on whole cells.
    pub profile: Profile,
    /// The cells with the largest parts of the gap, largest first, at most ten.
    pub worst: Vec<CellGap>,
    /// Why it ended: the first reason of a piece that is not [`StopReason::GapReached`].
    pub stop: StopReason,
}

/// Cells listed as the worst.
const WORST: usize = 10;

impl PathBracket {
    /// Brackets the time optimum. Between corners of the path, where `q'` jumps, the path is in pieces; under acceleration limits the robot rests there.
    /// The answer may be uncertified; `stop` says why. Both bounds hold all the same.
    ///
    /// # Errors
    ///
    /// Options out of range, and places where the path stands without turning back.
    pub fn solve(problem: &JointPathProblem, options: &BracketOptions) -> Result<Self, BracketError> {
        if !(options.gap > 0.0 && options.gap.is_finite()) {
            return Err(BracketError::Option { what: "the gap", needed: "a finite number above 0" });
        }
        if options.cells < 10 || options.start < 1 {
            return Err(BracketError::Option {
                what: "the number of cells",
                needed: "at least 10, with at least 1 to begin with",
            });
        }
        // Without rows there is nothing to solve on the first cells: fewer do.
        let start = if problem.limits().has_acceleration() { options.start } else { options.start.div_ceil(4) };
        let pieces = cells::pieces(problem, start.min(options.cells))?;
        let first: usize = pieces.iter().map(|p| p.cells.len()).sum();
        let mut parts = Vec::new();
        for piece in pieces {
            let most = options.cells * piece.cells.len() / first;
            parts.push(bracket_of(piece, problem, options, most));
        }
        Ok(Self::of(parts, options))
    }

    fn of(parts: Vec<PieceBracket>, options: &BracketOptions) -> Self {
        let sum = |of: fn(&PieceBracket) -> Outward| parts.iter().map(of).fold(Outward::ZERO, |sum, time| sum + time);
        let (lower_s, upper_s) = (sum(|p| p.lower).lo.max(0.0), sum(|p| p.upper).hi);
        let gap = refine::relative_gap(lower_s, upper_s);
        let mut worst: Vec<CellGap> = parts
            .iter()
            .flat_map(|p| &p.gaps)
            .map(|g| CellGap { from: g.from, to: g.to, gap_s: g.gap, limit: g.limit })
            .collect();
        worst.sort_by(|a, b| b.gap_s.total_cmp(&a.gap_s));
        worst.truncate(WORST);
        let stops = parts.iter().map(|p| p.stop);
        Self {
            lower_s,
            upper_s,
            gap,
            certified: gap <= options.gap,
            cells: parts.iter().map(|p| p.cells).sum(),
            rounds: parts.iter().map(|p| p.rounds).max().unwrap_or(0),
            stop: stops.clone().find(|s| *s != StopReason::GapReached).unwrap_or(StopReason::GapReached),
            profile: Profile::new(parts.into_iter().flat_map(|p| p.profile).collect()),
            worst,
        }
    }
}

/// The bracket of one piece; from nothing to for ever where no profile comes out.
fn bracket_of(piece: Piece, problem: &JointPathProblem, options: &BracketOptions, most: usize) -> PieceBracket {
    let cells = piece.cells.len();
    if !problem.limits().has_acceleration() {
        return speed_only::bracket(piece, problem.limits(), options, most);
    }
    refine::bracket(piece, problem.limits(), options, most).unwrap_or_else(|| PieceBracket {
        lower: Outward::ZERO,
        upper: Outward::exact(f64::INFINITY),
        profile: Vec::new(),
        gaps: Vec::new(),
        cells,
        rounds: 0,
        stop: StopReason::NoProgress,
    })
}
