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
//! The path comes in smooth pieces. Under speed limits alone each piece is free at its ends; under acceleration limits each
//! begins and ends at rest, for between pieces the joint path has a corner.
//!
//! Nothing here believes the solver: its answer is repaired until every limit holds at the nodes in a re-check (an upper
//! bound), its multipliers are turned into a lower bound that is valid whatever they are, and the answer is accepted if the
//! two are close enough.

mod certificate;
mod conic;
mod error;
mod piece;
mod repair;
mod violation;

pub use certificate::lower_bound;
pub use conic::{ConicAnswer, solve_conic};
pub use error::OptimumError;
pub use piece::{PieceProgram, Row, RowSource};
pub use repair::{feasible_time, repair};
pub use violation::Violation;

use crate::outward::Outward;
use slideway_lab::SampledPath;

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
    /// What the solver said, piece by piece: reported, not believed.
    pub status: Vec<String>,
    /// Iterations of the solver, all pieces together.
    pub iterations: u32,
    /// Time spent in the solver, s.
    pub solve_s: f64,
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
    /// Whether the tool stands still along the piece.
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

    /// Whether the certificate closes to [`GAP_TOLERANCE`]. NaN does not.
    #[must_use]
    pub fn is_certified(&self) -> bool {
        self.lower_s > 0.0 && self.gap() <= GAP_TOLERANCE
    }
}

/// Solves and certifies the time optimum along a sampled joint path.
///
/// # Errors
///
/// The path does not move, a number is not finite, or the solver's answer cannot be repaired.
pub fn time_optimum(path: &SampledPath) -> Result<TimeOptimum, OptimumError> {
    let mut optimum = TimeOptimum {
        duration_s: 0.0,
        lower_s: 0.0,
        upper_s: 0.0,
        grid_points: 0,
        status: Vec::new(),
        iterations: 0,
        solve_s: 0.0,
        between: Violation::default(),
        pieces: Vec::new(),
    };
    let (mut lower, mut upper) = (Outward::ZERO, Outward::ZERO);
    for (index, piece) in path.pieces.iter().enumerate() {
        let program = PieceProgram::new(path, index)?;
        let answer = solve_conic(&program)?;
        let profile = repair(&program, &answer.b)?;
        let time = feasible_time(&program, &profile);
        let b = program.in_units(&profile);
        lower = lower + lower_bound(&program, &profile, &answer.multipliers);
        upper = upper + time;
        optimum.duration_s += 0.5 * (time.lo + time.hi);
        optimum.grid_points += piece.nodes.len();
        optimum.status.push(answer.status);
        optimum.iterations += answer.iterations;
        optimum.solve_s += answer.solve_s;
        optimum.between = optimum.between.worst(Violation::new(path, index, &b));
        optimum.pieces.push(ProfilePiece {
            lambda: piece.nodes.iter().map(|n| n.lambda).collect(),
            s: piece.nodes.iter().map(|n| n.s).collect(),
            b,
            is_self_motion: piece.is_self_motion,
        });
    }
    (optimum.lower_s, optimum.upper_s) = (lower.lo, upper.hi);
    Ok(optimum)
}
