//! Time-optimal speed along a known joint path: the best that any speed law can do.
//!
//! With `b = ṡ²` as the unknown at every node of a grid, joint speeds and accelerations are linear in `b` and the travel
//! time is convex (Verscheure et al. 2009):
//!
//! ```text
//! T(b) = Σ_k 2 Δs_k / (√b_k + √b_{k+1})
//! q̇ = q' √b,   q̈ = q' s̈ + q'' b,   s̈_k = (b_{k+1} - b_k) / (2 Δs_k)
//! ```
//!
//! So are torques, `τ = m s̈ + c b + g`, and tool accelerations: any limit of the form `lower <= a s̈ + c b + d <= upper`, with
//! numbers that vary along the path ([`slideway_path::LinearLimit`]); limits on the path rate bound `b` itself. Every limit is taken at both
//! ends of every interval, with that interval's `s̈`.
//!
//! The path comes in smooth pieces. Unless the caller says otherwise, under speed limits alone each piece is free at its
//! ends; under other limits each begins and ends at rest, for between pieces the joint path has a corner.
//!
//! [`time_optimum`] solves the program and certifies it: by an interior point on the tridiagonal Newton matrix ([`Solver`]), by
//! Clarabel on the second-order cone program where that is asked for or the certificate does not close.
//! [`reachable_profile`] works on the same rows and sweeps over the grid with two-variable linear programs: faster, feasible, not
//! quite optimal.
//!
//! Nothing here believes the solver: its answer is repaired until every limit holds at the nodes in a re-check (an upper
//! bound), its multipliers are turned into a lower bound that is valid whatever they are, and the answer is accepted if the
//! two are close enough. That no profile exists is decided by the sweep and proven by a Farkas certificate. All of this is about the
//! rows as rounded to `f64`; between the nodes see [`Violation`] and [`refine_optimum`].

mod certificate;
mod conic;
mod controllable;
mod error;
mod farkas;
mod interval;
mod motion;
mod piece;
mod reachability;
mod refine;
mod repair;
mod solver;
mod strip;
mod structured;
mod violation;
mod widening;

pub use certificate::lower_bound;
pub use conic::solve_conic;
pub use error::OptimumError;
pub use motion::{GridMotion, GridState};
pub use piece::{ExtraSample, PieceProgram};
pub use reachability::{ROW_TOLERANCE, ReachableProfile, reachable_profile};
pub use refine::{Refined, refine_optimum, refine_optimum_by, refine_profile};
pub use repair::{feasible_time, repair};
pub use solver::{Attempt, Solver, SolverAnswer};
pub use strip::{Row, RowSource, Strip};
pub use structured::{Start, solve_structured};
pub use violation::Violation;
pub use widening::needed_widening;

use crate::outward::Outward;
use slideway_path::{SampledPath, SampledPiece};

/// A certified optimum.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeOptimum {
    /// Travel time of the repaired profile, s.
    pub duration_s: f64,
    /// No profile that keeps the limits at the nodes is faster than this, s.
    pub lower_s: f64,
    /// Travel time of a profile that keeps the limits at the nodes, rounded up, s.
    pub upper_s: f64,
    /// Nodes of the grid, all pieces together.
    pub grid_points: usize,
    /// The solver whose answer the bounds are from, piece by piece.
    pub solvers: Vec<Solver>,
    /// Its status, piece by piece: reported, not believed.
    pub status: Vec<String>,
    /// Iterations, all attempts and pieces together.
    pub iterations: u32,
    /// Time spent in solvers, all attempts and pieces together, s.
    pub solve_s: f64,
    /// Every run of a solver, in order: more than one a piece where an answer was not certified.
    pub attempts: Vec<Attempt>,
    /// Largest violation of a limit between grid points.
    pub between: Violation,
    /// The profile.
    pub pieces: Vec<ProfilePiece>,
}

/// The speed profile along one piece.
#[derive(Clone, Debug, PartialEq)]
pub struct ProfilePiece {
    /// Path parameter of the tool path at the nodes.
    pub lambda: Vec<f64>,
    /// The piece's own parameter at the nodes.
    pub s: Vec<f64>,
    /// `b = ṡ²` at the nodes.
    pub b: Vec<f64>,
    /// True if the tool stands still along the piece.
    pub is_self_motion: bool,
}

impl ProfilePiece {
    /// Rate of the tool path's parameter at the nodes, `dλ/dt`, 1/s.
    #[must_use]
    pub fn path_rate(&self) -> Vec<f64> {
        if self.is_self_motion { vec![0.0; self.b.len()] } else { self.b.iter().map(|b| b.sqrt()).collect() }
    }
}

impl ProfilePiece {
    /// Time at the nodes since the piece's start, s.
    #[must_use]
    pub fn times(&self) -> Vec<f64> {
        let mut times = vec![0.0];
        for (s, b) in self.s.windows(2).zip(self.b.windows(2)) {
            times.push(times[times.len() - 1] + 2.0 * (s[1] - s[0]) / (b[0].sqrt() + b[1].sqrt()));
        }
        times
    }
}

/// Relative gap below which an answer is accepted.
pub const GAP_TOLERANCE: f64 = 1e-6;

impl TimeOptimum {
    /// `(upper - lower) / lower`.
    #[must_use]
    pub fn gap(&self) -> f64 {
        (self.upper_s - self.lower_s) / self.lower_s
    }

    /// True if the certificate closes to [`GAP_TOLERANCE`]. NaN does not.
    #[must_use]
    pub fn is_certified(&self) -> bool {
        self.lower_s > 0.0 && self.gap() <= GAP_TOLERANCE
    }
}

/// Solves and certifies the time optimum along a sampled joint path, by the structured solver first.
///
/// # Errors
///
/// The path does not move, a number is not usable, no profile keeps the limits (with the limit, the place and by how much), or
/// the solver's answer cannot be repaired.
pub fn time_optimum(path: &SampledPath) -> Result<TimeOptimum, OptimumError> {
    time_optimum_by(path, Solver::default())
}

/// As [`time_optimum`], by a solver of choice.
///
/// # Errors
///
/// As [`time_optimum`].
pub fn time_optimum_by(path: &SampledPath, solver: Solver) -> Result<TimeOptimum, OptimumError> {
    let parts: Result<Vec<_>, _> = (0..path.pieces.len()).map(|index| solve_piece(path, index, &[], solver)).collect();
    Ok(TimeOptimum::of(path, parts?))
}

/// One piece, solved and certified.
pub(crate) struct SolvedPiece {
    b: Vec<f64>,
    lower: Outward,
    upper: Outward,
    solver: Solver,
    status: String,
    attempts: Vec<Attempt>,
}

pub(crate) fn solve_piece(
    path: &SampledPath,
    index: usize,
    extra: &[ExtraSample],
    solver: Solver,
) -> Result<SolvedPiece, OptimumError> {
    solver.certify(&PieceProgram::sampled(path, index, extra)?.bounded(path)?)
}

impl TimeOptimum {
    fn of(path: &SampledPath, mut parts: Vec<SolvedPiece>) -> Self {
        let (lower, upper) = (SolvedPiece::sum(&parts, |p| p.lower), SolvedPiece::sum(&parts, |p| p.upper));
        let violations = parts.iter().enumerate().map(|(index, p)| Violation::new(path, index, &p.b));
        let between = violations.fold(Violation::default(), Violation::worst);
        let attempts: Vec<Attempt> = parts.iter_mut().flat_map(|p| std::mem::take(&mut p.attempts)).collect();
        Self {
            duration_s: 0.5 * (upper.lo + upper.hi),
            lower_s: lower.lo,
            upper_s: upper.hi,
            grid_points: path.pieces.iter().map(|p| p.nodes.len()).sum(),
            solvers: parts.iter().map(|p| p.solver).collect(),
            status: parts.iter().map(|p| p.status.clone()).collect(),
            iterations: attempts.iter().map(|a| a.iterations).sum(),
            solve_s: attempts.iter().map(|a| a.solve_s).sum(),
            attempts,
            between,
            pieces: path.pieces.iter().zip(parts).map(|(piece, part)| profile_piece(piece, part.b)).collect(),
        }
    }
}

fn profile_piece(piece: &SampledPiece, b: Vec<f64>) -> ProfilePiece {
    ProfilePiece {
        lambda: piece.nodes.iter().map(|n| n.lambda).collect(),
        s: piece.nodes.iter().map(|n| n.s).collect(),
        b,
        is_self_motion: piece.is_self_motion,
    }
}
