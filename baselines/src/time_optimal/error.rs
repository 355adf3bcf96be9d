use thiserror::Error;

/// Why there is no optimum.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum OptimumError {
    /// A piece whose joints do not move: any speed is possible.
    #[error("piece {} of the joint path does not move: its shortest time is zero", piece + 1)]
    NoMotion {
        /// The piece, counted from 0.
        piece: usize,
    },
    /// A derivative of the joint path that is NaN or infinite.
    #[error("the joint path has no finite derivatives at node {node} of piece {}", piece + 1)]
    NotFinite {
        /// The piece, counted from 0.
        piece: usize,
        /// The node, counted from 0.
        node: usize,
    },
    /// A limit that no speed, however small, can keep.
    #[error("{limit} limit of joint {} cannot be kept at node {node} of piece {}", joint + 1, piece + 1)]
    Infeasible {
        /// The piece, counted from 0.
        piece: usize,
        /// The node, counted from 0.
        node: usize,
        /// The joint, counted from 0.
        joint: usize,
        /// Which limit.
        limit: &'static str,
    },
    /// The solver refused the problem's data.
    #[error("the solver refused the problem: {0}")]
    Solver(String),
    /// The solver's answer is no profile, or breaks a limit that scaling does not mend.
    #[error("the solver's answer cannot be repaired: {0}")]
    Unrepairable(&'static str),
}
